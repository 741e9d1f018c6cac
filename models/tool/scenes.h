// The scenes of models/ as GLB files. Enters: the pictures, as PNG; leaves: the bytes of each file.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace barrido::models {

using Bytes = std::vector<std::uint8_t>;

/// PNG files by name: "checker", "patch", "bricks", "marble", "brick_heights" …
using Textures = std::map<std::string, Bytes>;

struct SceneFile {
  std::string name;  ///< "teapot.glb"
  Bytes bytes;
};

/// Teapots, sphere, torus: one object each, for trying things out. `teapot_cells` as in make_teapot.
std::vector<SceneFile> make_object_scenes(const Textures& textures, int teapot_cells);

/// One lesson of the course each: room, ground plane, T-junction, lost highlight.
std::vector<SceneFile> make_lesson_scenes(const Textures& textures);

/// Teapot, spheres and torus on a checker floor, with camera and lights.
SceneFile make_showcase(const Textures& textures, int teapot_cells);

}  // namespace barrido::models
