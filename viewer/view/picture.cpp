#include "viewer/view/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace barrido::view {
namespace {

std::array<int, 3> channels_of(std::uint32_t rgba) {
  return {static_cast<int>(rgba & 255), static_cast<int>(rgba >> 8 & 255),
          static_cast<int>(rgba >> 16 & 255)};
}

}  // namespace

int divider_column(int width, double divider) {
  return std::clamp(static_cast<int>(std::floor(divider * width + 0.5)), 0, width);
}

Picture side_by_side(const Picture& left, const Picture& right, double divider) {
  Picture both = right;
  const auto width = static_cast<std::ptrdiff_t>(left.width);
  const std::ptrdiff_t column = divider_column(left.width, divider);
  for (std::ptrdiff_t row = 0; row < left.height; ++row) {
    std::copy_n(left.rgba.begin() + row * width, column, both.rgba.begin() + row * width);
  }
  return both;
}

Difference difference_of(const Picture& a, const Picture& b) {
  Difference difference;
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    const auto p = channels_of(a.rgba[i]), q = channels_of(b.rgba[i]);
    int largest = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const int apart = std::abs(p[c] - q[c]);
      largest = std::max(largest, apart);
      sum += static_cast<std::uint64_t>(apart);
    }
    difference.largest = std::max(difference.largest, largest);
    difference.pixels += largest > 0;
    difference.beyond_rounding += largest > 1;
  }
  if (!a.rgba.empty())
    difference.mean = static_cast<double>(sum) / (3.0 * static_cast<double>(a.rgba.size()));
  return difference;
}

std::uint32_t heat_color(double value) {
  constexpr std::array<std::array<double, 3>, 5> kStops{
      {{0, 0, 0}, {90, 0, 130}, {220, 30, 40}, {255, 205, 30}, {255, 255, 255}}};
  const double place = std::clamp(value, 0.0, 1.0) * (kStops.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
  const double share = place - static_cast<double>(below);
  std::uint32_t rgba = 0xff000000u;
  for (std::size_t c = 0; c < 3; ++c) {
    const double channel = kStops[below][c] * (1.0 - share) + kStops[below + 1][c] * share;
    rgba |= static_cast<std::uint32_t>(channel + 0.5) << (8 * c);
  }
  return rgba;
}

Picture heat_map(const Picture& a, const Picture& b, const Difference& difference) {
  Picture map{a.width, a.height, std::vector<std::uint32_t>(a.rgba.size())};
  std::array<std::uint32_t, 256> colors{};
  for (std::size_t i = 0; i < colors.size(); ++i) {
    colors[i] = heat_color(static_cast<double>(i) / std::max(1, difference.largest));
  }
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    const auto p = channels_of(a.rgba[i]), q = channels_of(b.rgba[i]);
    int largest = 0;
    for (std::size_t c = 0; c < 3; ++c) largest = std::max(largest, std::abs(p[c] - q[c]));
    map.rgba[i] = colors[static_cast<std::size_t>(largest)];
  }
  return map;
}

}  // namespace barrido::view
