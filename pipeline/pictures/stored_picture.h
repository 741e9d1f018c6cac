// A picture as its file stores it, for comparisons: nothing is rounded, encoded, or divided by alpha.
#pragma once

#include <vector>

namespace barrido::scene {

struct StoredPicture {
  int width = 0;
  int height = 0;
  int channels = 4;        ///< That the file stores: 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA.
  bool is_linear = false;  ///< The file holds floats: linear light, any size. Else fractions in 0..1, sRGB.
  bool is_associated = false;  ///< Colours are multiplied by alpha.
  /// RGBA, top row first; grey stands in R, G and B, an alpha that the file does not store is 1.
  std::vector<float> rgba;
};

}  // namespace barrido::scene
