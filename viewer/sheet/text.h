// Lines of text as pixels. Enters: UTF-8. Leaves: a mask of pixels to be coloured. Must not know: sheets,
// pictures.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace barrido::sheet {

/// Pixels that are ink (1) or not (0), row-major, top row first.
struct TextMask {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> ink;

  bool at(int x, int y) const {
    return x >= 0 && y >= 0 && x < width && y < height &&
           ink[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] !=
               0;
  }
};

struct TextStyle {
  int scale = 1;  ///< A power of two; strokes are `scale` pixels thick and rounded where they bend.
  bool bold = false;
};

/// Width in pixels of one line of UTF-8; bytes that are no UTF-8 count as one box each.
int text_width(std::string_view utf8, const TextStyle& style);

/// Height in pixels of a line, room for descenders included.
int text_height(const TextStyle& style);

/// The pixels of one line.
TextMask draw_text(std::string_view utf8, const TextStyle& style);

/// The text, or as much of its beginning as fits into `max_width` pixels with "..." after it.
std::string fit_text(std::string_view utf8, const TextStyle& style, int max_width);

}  // namespace barrido::sheet
