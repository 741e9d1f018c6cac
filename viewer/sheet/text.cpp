#include "viewer/sheet/text.h"

#include <algorithm>
#include <bit>

#include "viewer/sheet/font.h"

namespace barrido::sheet {
namespace {

constexpr int kLetterSpace = 2;  // between two glyphs, at scale 1
constexpr char32_t kUnreadable = 0xfffd;

/// Signs that text has and the font has not, as the nearest that it has.
char32_t plain(char32_t code) {
  switch (code) {
    case 0x00a0:
      return ' ';
    case 0x00d7:
      return 'x';
    case 0x2010:
    case 0x2011:
    case 0x2012:
    case 0x2013:
    case 0x2014:
    case 0x2212:
      return '-';
    case 0x2018:
    case 0x2019:
      return '\'';
    case 0x201c:
    case 0x201d:
      return '"';
    default:
      return code;
  }
}

/// Takes one code point off the front (RFC 3629); a byte that starts none counts as one.
char32_t take_code_point(std::string_view& utf8) {
  const auto first = static_cast<unsigned char>(utf8.front());
  const int ones = std::countl_one(first);
  const std::size_t length = ones == 0 ? 1 : static_cast<std::size_t>(ones);
  const bool starts = ones == 0 || (ones >= 2 && ones <= 4);
  if (!starts || length > utf8.size()) {
    utf8.remove_prefix(1);
    return kUnreadable;
  }
  char32_t code = ones == 0 ? first : first & (0x7fu >> ones);
  for (std::size_t i = 1; i < length; ++i) {
    const auto next = static_cast<unsigned char>(utf8[i]);
    if ((next & 0xc0u) != 0x80u) {
      utf8.remove_prefix(1);
      return kUnreadable;
    }
    code = code << 6 | (next & 0x3fu);
  }
  utf8.remove_prefix(length);
  return code;
}

const Glyph& next_glyph(std::string_view& utf8) { return glyph_of(plain(take_code_point(utf8))); }

/// Width at scale 1.
int unscaled_width(std::string_view utf8, bool bold) {
  int width = 0;
  while (!utf8.empty()) width += next_glyph(utf8).width + kLetterSpace + (bold ? 1 : 0);
  return std::max(width - kLetterSpace, 0);
}

void draw_glyph(TextMask& mask, const Glyph& glyph, int left) {
  for (int y = 0; y < kGlyphRows; ++y) {
    for (int x = 0; x < glyph.width; ++x) {
      if (glyph.pixel(x, y)) mask.ink[static_cast<std::size_t>(y * mask.width + left + x)] = 1;
    }
  }
}

/// Twice the size. A pixel's quarter takes the value of its two neighbours at that corner where they agree
/// and the two others do not, so that stairs become slopes (Scale2x, Mazzoleni 2001).
TextMask doubled(const TextMask& mask) {
  TextMask out{mask.width * 2, mask.height * 2, {}};
  out.ink.resize(mask.ink.size() * 4);
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      const int px = x / 2, py = y / 2;
      const int dx = x % 2 == 0 ? -1 : 1, dy = y % 2 == 0 ? -1 : 1;
      const bool beside = mask.at(px + dx, py), across = mask.at(px - dx, py);
      const bool above = mask.at(px, py + dy), below = mask.at(px, py - dy);
      const bool corner = beside == above && beside != below && above != across;
      out.ink[static_cast<std::size_t>(y * out.width + x)] = corner ? beside : mask.at(px, py);
    }
  }
  return out;
}

/// Strokes grow to the right; the width of bold text leaves room for it.
void thicken(TextMask& mask, int pixels) {
  const TextMask thin = mask;
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) {
      bool ink = false;
      for (int step = 0; step <= pixels; ++step) ink = ink || thin.at(x - step, y);
      mask.ink[static_cast<std::size_t>(y * mask.width + x)] = ink;
    }
  }
}

}  // namespace

int text_width(std::string_view utf8, const TextStyle& style) {
  return unscaled_width(utf8, style.bold) * style.scale;
}

int text_height(const TextStyle& style) { return kGlyphRows * style.scale; }

TextMask draw_text(std::string_view utf8, const TextStyle& style) {
  TextMask mask{unscaled_width(utf8, style.bold), kGlyphRows, {}};
  mask.ink.resize(static_cast<std::size_t>(mask.width * mask.height));
  int left = 0;
  while (!utf8.empty()) {
    const Glyph& glyph = next_glyph(utf8);
    draw_glyph(mask, glyph, left);
    left += glyph.width + kLetterSpace + (style.bold ? 1 : 0);
  }
  for (int scale = 1; scale < style.scale; scale *= 2) mask = doubled(mask);
  if (style.bold) thicken(mask, style.scale);
  return mask;
}

std::string fit_text(std::string_view utf8, const TextStyle& style, int max_width) {
  if (text_width(utf8, style) <= max_width) return std::string(utf8);
  std::string fitting;
  std::string_view rest = utf8;
  while (!rest.empty()) {
    const std::size_t before = rest.size();
    take_code_point(rest);
    const std::string_view longer = utf8.substr(0, utf8.size() - rest.size());
    if (before == rest.size() || text_width(std::string(longer) + "...", style) > max_width) break;
    fitting = longer;
  }
  return fitting.empty() ? fitting : fitting + "...";
}

}  // namespace barrido::sheet
