// A bitmap font for labels, drawn for Barrido: capitals ten pixels high, small letters seven, strokes of one
// pixel, widths that follow the letters. Must not know: pictures.
#pragma once

#include <cstdint>

namespace barrido::sheet {

inline constexpr int kGlyphRows = 16;  ///< The baseline lies below row 11, counted from 0 at the top.

struct Glyph {
  int width;  ///< Pixels, at most 8, without the space to the next glyph.
  /// Eight rows each, a byte a row, the top row in the highest byte, the leftmost pixel in the highest bit.
  std::uint64_t upper, lower;

  bool pixel(int x, int y) const {
    const std::uint64_t rows = y < 8 ? upper : lower;
    return (rows >> (8 * (7 - y % 8) + (7 - x)) & 1) != 0;
  }
};

/// The glyph of a code point; those outside ASCII are an empty box.
const Glyph& glyph_of(char32_t code_point);

}  // namespace barrido::sheet
