// Properties of materials on the command line: "roughness=0.3:diffuse=1,0,0" becomes an override.
#pragma once

#include <string_view>

#include "pipeline/scene/render_scene.h"
#include "viewer/barrido/usage_error.h"

namespace barrido::cli {

/// KEY=VALUE[:KEY=VALUE]…, each key at most once.
///
///  color                                R,G,B in 0..1, linear: glTF's base colour
///  metallic, roughness                  0..1
///  ambient diffuse specular emission    R,G,B ≥ 0, linear: k_a, k_d, k_s and emission
///  shininess                            n, 0..100000
/// @throws ValueError naming the key.
scene::MaterialOverride parse_material(std::string_view spec);

}  // namespace barrido::cli
