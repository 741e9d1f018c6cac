// Two pictures as one: along the divider, and as a heat map with its figures.
#include "viewer/view/picture.h"

#include <gtest/gtest.h>

namespace barrido::view {
namespace {

Picture filled(int width, int height, std::uint32_t rgba) {
  return {width, height, std::vector<std::uint32_t>(static_cast<std::size_t>(width * height), rgba)};
}

TEST(Picture, SidesMeetAtTheDivider) {
  const Picture left = filled(10, 3, 1), right = filled(10, 3, 2);
  for (const auto& [divider, column] : {std::pair{0.0, 0}, {0.5, 5}, {0.24, 2}, {1.0, 10}}) {
    const Picture both = side_by_side(left, right, divider);
    for (int i = 0; i < 30; ++i) {
      EXPECT_EQ(both.rgba[static_cast<std::size_t>(i)], i % 10 < column ? 1u : 2u) << divider << " " << i;
    }
  }
}

TEST(Picture, DifferenceHasMaximumAndMean) {
  Picture a = filled(2, 2, 0xff000000u), b = a;
  EXPECT_EQ(difference_of(a, b).largest, 0);
  b.rgba[1] = 0x00000a14u;  // red 20, green 10; alpha does not count
  b.rgba[2] = 0xff1e0000u;  // blue 30
  const Difference difference = difference_of(a, b);
  EXPECT_EQ(difference.largest, 30);
  EXPECT_EQ(difference.pixels, 2u);
  EXPECT_EQ(difference.beyond_rounding, 2u);
  EXPECT_DOUBLE_EQ(difference.mean, 60.0 / 12.0);
  const Picture map = heat_map(a, b, difference);
  EXPECT_EQ(map.rgba[0], heat_color(0.0));
  EXPECT_EQ(map.rgba[1], heat_color(20.0 / 30.0));
  EXPECT_EQ(map.rgba[2], heat_color(1.0));
}

TEST(Picture, HeatBeginsBlackAndEndsWhite) {
  EXPECT_EQ(heat_color(0.0), 0xff000000u);
  EXPECT_EQ(heat_color(1.0), 0xffffffffu);
  EXPECT_EQ(heat_color(-1.0), heat_color(0.0));
  EXPECT_EQ(heat_color(2.0), heat_color(1.0));
}

}  // namespace
}  // namespace barrido::view
