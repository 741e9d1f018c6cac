// Float colours as they are shown: exposure, tone reproduction, sRGB, each against the formula in double.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "raster/reference/canvas.h"

namespace barrido::raster::reference {
namespace {

std::uint32_t red(std::uint32_t packed) { return packed & 255u; }
std::uint32_t alpha(std::uint32_t packed) { return packed >> 24; }

TEST(Display, ClampKeepsExposedValues) {
  const DisplayTransform display{2.0f, ToneMap::clamp, false};
  EXPECT_EQ(red(display_color(display, {0.25f, 0, 0, 1})), 128u);
  EXPECT_EQ(red(display_color(display, {7.0f, 0, 0, 1})), 255u);
  EXPECT_EQ(red(display_color(display, {-7.0f, 0, 0, 1})), 0u);
}

TEST(Display, ReinhardCompresses) {
  const DisplayTransform display{1.0f, ToneMap::reinhard, false};
  EXPECT_EQ(red(display_color(display, {1.0f, 0, 0, 1})), 128u);
  EXPECT_EQ(red(display_color(display, {3.0f, 0, 0, 1})), 191u);
  EXPECT_EQ(red(display_color(display, {-0.5f, 0, 0, 1})), 0u);
}

TEST(Display, SrgbIsTheStandardsFormula) {
  const DisplayTransform display{1.0f, ToneMap::clamp, true};
  for (int k = 0; k <= 4096; ++k) {
    const float c = static_cast<float>(k) / 4096.0f;
    const double encoded =
        c <= 0.0031308f ? 12.92 * c : 1.055 * std::pow(static_cast<double>(c), 1.0 / 2.4) - 0.055;
    EXPECT_NEAR(red(display_color(display, {c, 0, 0, 1})), encoded * 255.0, 0.5001) << c;
  }
}

TEST(Display, AlphaIsLeftAlone) {
  const DisplayTransform display{4.0f, ToneMap::reinhard, true};
  EXPECT_EQ(alpha(display_color(display, {0, 0, 0, 0.5f})), 128u);
  EXPECT_EQ(alpha(display_color(display, {0, 0, 0, 1.5f})), 255u);
}

TEST(Display, NumbersThatAreNoneGiveBytes) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const ToneMap tone_map : {ToneMap::clamp, ToneMap::reinhard}) {
    const DisplayTransform display{1.0f, tone_map, true};
    EXPECT_EQ(display_color(display, {nan, -nan, nan, 1.0f}), 0xff000000u);
  }
}

}  // namespace
}  // namespace barrido::raster::reference
