// Models of a few triangles, written by the tests that need them.
#pragma once

#include <filesystem>
#include <string>

namespace barrido::test {

/// A square from (−1, −1, 0) to (1, 1, 0) facing +Z, as glTF with its buffer inside: no normals, no camera.
void write_square(const std::filesystem::path& path);

/// Two squares, two cameras ("front", "side") and an animation of one second that moves a node by (1, 0, 0).
void write_animated(const std::filesystem::path& path);

/// A bumpy square of 2 · cells² triangles as GLB, with normals, texture coordinates and a noisy PNG picture:
/// its frames compress badly.
void write_textured_glb(const std::filesystem::path& path, int cells);

}  // namespace barrido::test
