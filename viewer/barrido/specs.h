// Lights, fog and materials on the command line: "point:pos=1,2,3:intensity=2" becomes a light of the scene
// and the other way round. What is written reads back as the same bits.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "pipeline/scene/render_scene.h"
#include "raster/fragments/fragment_state.h"

namespace barrido::cli {

/// TYPE[:KEY=VALUE]…, each key at most once. Lengths in the model's units, angles in degrees, colours linear.
///
///  type         key fill back (presets that move with the camera) directional point spot
///  color        R,G,B ≥ 0, linear; 1,1,1
///  intensity    I_p, negative takes light away; 1 (presets: their share of the three-light set-up)
///  dir          X,Y,Z in which it shines; 0,0,-1. Not for points.
///  pos          X,Y,Z; the origin. Points and spots.
///  attenuation  kc,kl,kq of 1/(kc + kl d + kq d²); 1,0,0. Points and spots.
///  range        distance at which it ends; 0 for never. Points and spots.
///  cone         INNER,OUTER half angles of a soft cone in 0..90. Spots.
///  cutoff       half angle of a hard cone in 0..90; 45. Spots, not with cone.
///  exponent     of the cosine inside the hard cone; 0. Spots, not with cone.
///  space        world or camera: what dir and pos refer to, and what the light moves with.
/// @throws ValueError naming the key.
scene::UserLight parse_light(std::string_view spec);

/// As parse_light reads it. Angles are the degrees that give the light's radians, or the nearest there are.
std::string light_text(const scene::UserLight& light);

/// KEY=VALUE[:KEY=VALUE]…, each key at most once.
///
///  color                                R,G,B in 0..1, linear: glTF's base colour
///  metallic, roughness                  0..1
///  ambient diffuse specular emission    R,G,B ≥ 0, linear: k_a, k_d, k_s and emission
///  shininess                            n, 0..100000
/// @throws ValueError naming the key.
scene::MaterialOverride parse_material(std::string_view spec);

/// As parse_material reads it; empty when nothing is overridden.
std::string material_text(const scene::MaterialOverride& material);

struct FogChoice {
  raster::FogState state;                           ///< Its colour is not set here.
  std::optional<std::array<float, 3>> color_shown;  ///< As it is to be seen; empty: the background's.
};

/// linear:START,END[:R,G,B], exp:DENSITY[:R,G,B] or exp2:DENSITY[:R,G,B]; distances in the model's units from
/// the eye, colours in [0, 1] as they are to be seen. @throws ValueError.
FogChoice parse_fog(std::string_view spec);

/// As parse_fog reads it.
std::string fog_text(const FogChoice& fog);

/// NAME[:radius=R], R in 0.01..8. @throws ValueError.
raster::PixelFilter parse_pixel_filter(std::string_view spec);

/// As parse_pixel_filter reads it; empty for the default.
std::string pixel_filter_text(const raster::PixelFilter& filter);

}  // namespace barrido::cli
