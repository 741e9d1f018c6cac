// A light on the command line: "point:pos=1,2,3:intensity=2" becomes a light of the scene. Colours are linear
// and the intensity is the course's I_p, which may be negative.
#pragma once

#include <string_view>

#include "pipeline/scene/render_scene.h"
#include "viewer/barrido/usage_error.h"

namespace barrido::cli {

/// TYPE[:KEY=VALUE]…, each key at most once. Lengths in the model's units, angles in degrees.
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

}  // namespace barrido::cli
