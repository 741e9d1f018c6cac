// Environment maps (T17): six files, a cross, or a latitude-longitude picture become the six faces of a cube
// map.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>

#include "pipeline/pictures/image_io.h"
#include "raster/textures/texture.h"

namespace barrido::scene {

/// Six square faces, OpenGL's order (+X −X +Y −Y +Z −Z) and orientation (OpenGL 1.3, table 3.19), 8-bit.
struct CubeMapImage {
  int size = 0;
  std::array<std::vector<std::uint8_t>, 6> faces_rgba;
};

/// Reads an environment:
///  - a folder, or a path with {face}, holding px nx py ny pz nz (or posx … negz, right left top bottom front
///  back);
///  - a picture 4:3 or 3:4 is a horizontal or vertical cross;
///  - a picture 2:1 is latitude-longitude, looking along −Z in its middle, +Y up.
/// High-range pictures are multiplied by 2^exposure_ev and clamped; `srgb` says whether linear values are to
/// be stored encoded (the usual) or as they are.
/// Pictures must keep to `limits`. @throws InputError.
CubeMapImage read_environment(const std::filesystem::path& path, float exposure_ev = 0.0f, bool srgb = true,
                              const ImageLimits& limits = {});

}  // namespace barrido::scene
