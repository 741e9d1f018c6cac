// The difference of two pictures as a picture. Must not know: files, reports.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/pictures/stored_picture.h"

namespace barrido::compare {

struct DifferenceOptions {
  bool absolute = false;  ///< |A − B| instead of A − B, of which a format of bytes keeps what is positive.
  float scale = 1.0f;     ///< Multiplied.
};

/// Opaque pixels in both forms that a file can hold, top row first.
struct DifferencePicture {
  int width = 0;
  int height = 0;
  std::vector<float> rgba_float;
  std::vector<std::uint8_t> rgba8;  ///< The floats in 0..1 as 0..255, without encoding.
};

/// Expected − actual, as large as both pictures on each other. The difference of alpha is added to all three
/// colours, so that it can be seen.
DifferencePicture difference_picture(const scene::StoredPicture& expected, const scene::StoredPicture& actual,
                                     const DifferenceOptions& options);

}  // namespace barrido::compare
