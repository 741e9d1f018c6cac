// A decoded picture in memory. Enters and leaves everything that reads or writes pictures; knows no format.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "raster/base/memory.h"

namespace barrido::scene {

/// Bytes of pixels; new elements are left as the memory is.
using PixelBytes = raster::UnclearedArray<std::uint8_t>;

/// A decoded picture: straight RGBA, 8 bits, top row first (row 0 is t = 0, glTF's convention).
struct Image {
  std::string name;  ///< File name or "image 3"; for messages.
  int width = 0;
  int height = 0;
  PixelBytes rgba;
};

/// A picture with values over the maximum: straight RGBA floats in linear light, top row first.
struct FloatImage {
  int width = 0;
  int height = 0;
  std::vector<float> rgba;
};

}  // namespace barrido::scene
