// A picture in at most 256 colours, for GIF: by median cut, without dithering, in whole numbers and with
// every tie decided, so that it is the same bytes everywhere. Enters: straight RGBA. Must not know: files.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace barrido::scene {

struct IndexedPicture {
  std::vector<std::uint8_t> indices;            ///< One a pixel, in their order.
  std::array<std::uint8_t, 3 * 256> palette{};  ///< R, G, B; what is not used is black.
  int transparent = -1;                         ///< The index of pixels whose alpha is below a half, or -1.
};

/// `rgba`: 4 bytes a pixel. A picture of at most 256 colours (255 beside transparent pixels) keeps each; of
/// more, all that differ in less than 1/32 (green 1/64) are one to begin with, and boxes of colours are cut
/// in two at their median until there are enough (P. Heckbert, "Color image quantization for frame buffer
/// display", SIGGRAPH 1982). Colours of a box become their mean.
IndexedPicture index_colors(std::span<const std::uint8_t> rgba);

}  // namespace barrido::scene
