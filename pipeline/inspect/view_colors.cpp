#include "pipeline/inspect/view_colors.h"

#include <cmath>
#include <cstddef>
#include <span>

namespace barrido::inspect {
namespace {

/// sRGB; CIE lightness rises by about the same from each to the next.
constexpr Rgb8 kOrdered[] = {{20, 16, 60},   {41, 38, 112},  {38, 76, 146},  {26, 108, 158}, {20, 139, 152},
                             {48, 168, 128}, {116, 193, 92}, {196, 214, 70}, {252, 240, 150}};
constexpr Rgb8 kBelow[] = {{30, 30, 34}, {28, 62, 122}, {52, 110, 198}, {84, 148, 240}, {132, 196, 255}};
constexpr Rgb8 kAbove[] = {{30, 30, 34}, {108, 50, 18}, {190, 88, 20}, {236, 138, 40}, {255, 198, 84}};

/// Linear between the neighbours in the table.
Rgb8 between(std::span<const Rgb8> table, double t) {
  const double bounded = t > 0.0 ? (t < 1.0 ? t : 1.0) : 0.0;
  const double place = bounded * static_cast<double>(table.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = below + 1 < table.size() ? below + 1 : below;
  const double share = place - static_cast<double>(below);
  Rgb8 color{};
  for (std::size_t c = 0; c < 3; ++c) {
    color[c] = static_cast<std::uint8_t>(table[below][c] + share * (table[above][c] - table[below][c]) + 0.5);
  }
  return color;
}

}  // namespace

Rgb8 ordered_color(double t) { return between(kOrdered, t); }

Rgb8 signed_color(double t) { return t < 0.0 ? between(kBelow, -t) : between(kAbove, t); }

Rgb8 distinct_color(std::uint32_t number) {
  // Bits mixed until neighbouring numbers have nothing in common (the finalizer of MurmurHash3, Appleby).
  std::uint32_t h = number + 1;
  h = (h ^ (h >> 16)) * 0x85ebca6bu;
  h = (h ^ (h >> 13)) * 0xc2b2ae35u;
  h ^= h >> 16;
  const auto channel = [h](int shift) {
    return static_cast<std::uint8_t>(64 + ((h >> shift) & 0xff) * 3 / 5);
  };
  return {channel(0), channel(8), channel(16)};
}

}  // namespace barrido::inspect
