// Pictures as the window shows them, and how two become one: side by side along a divider, or as a heat map
// of their difference. Enters and leaves: RGBA bytes, top row first. Knows no model and no window.
#pragma once

#include <cstdint>
#include <vector>

namespace barrido::view {

struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> rgba;  ///< R, G, B, A bytes in memory order, top row first.
};

struct Costs {
  double draw_ms = 0.0;
  double osmesa_ms = 0.0;       ///< Of OSMesa's picture, where one is shown.
  std::uint64_t triangles = 0;  ///< Primitives assembled.
  std::uint64_t fragments = 0;  ///< Shaded.
  std::uint64_t illuminations = 0;
  std::uint64_t powers = 0;
};

/// How far two pictures are apart, in steps of 1/255 of a channel; alpha does not count.
struct Difference {
  int largest = 0;
  double mean = 0.0;                  ///< Over all pixels and channels
  std::uint64_t pixels = 0;           ///< That differ at all
  std::uint64_t beyond_rounding = 0;  ///< That differ by more than 1
};

/// Columns left of `divider` (a part of the width) from `left`, the others from `right`; sizes are the same.
Picture side_by_side(const Picture& left, const Picture& right, double divider);

/// First column of the right picture.
int divider_column(int width, double divider);

Difference difference_of(const Picture& a, const Picture& b);

/// Each pixel's largest channel difference as a colour from heat_color, `difference.largest` being 1.
Picture heat_map(const Picture& a, const Picture& b, const Difference& difference);

/// Black, violet, red, yellow, white for 0 … 1, as RGBA bytes.
std::uint32_t heat_color(double value);

}  // namespace barrido::view
