// Maps on the command line: "bricks.png:height=0.1:repeat=2,2" becomes a map of the scene and the other way
// round; and the pictures that they name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/files/budget.h"
#include "pipeline/scene/render_scene.h"

namespace barrido::cli {

/// PATH[:KEY=VALUE]…, each key at most once.
///
///  repeat   U,V: how often the picture is laid on the surface's 0..1; 1,1
///  height   of white over black; 0.05. Of bump maps, as is
///  form     invariant (D', the same at every size of the object) or blinn (N' = N + D)
/// @throws ValueError naming the key.
scene::UserMap parse_bump(std::string_view spec);
/// The same with nothing but `repeat`.
scene::UserMap parse_map(std::string_view spec);

/// As they are read.
std::string bump_text(const scene::UserMap& map);
std::string map_text(const scene::UserMap& map);

/// What the texels of a map become.
enum class MapTexels {
  values,   ///< Used as they are.
  colors,   ///< Decoded to light where colours are managed.
  opacity,  ///< White, with the red as alpha.
};

/// Where the maps' pictures are.
std::vector<std::string> map_paths(const scene::RenderSettings& settings);

/// Reads the picture of every map that has none yet. @throws scene::InputError.
void load_maps(scene::RenderSettings& settings, scene::Budget* budget);

}  // namespace barrido::cli
