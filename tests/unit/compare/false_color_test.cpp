// Colours of errors: told apart by lightness alone.
#include "viewer/compare/false_color.h"

#include <gtest/gtest.h>

#include "pipeline/pictures/transfer.h"

namespace barrido::compare {
namespace {

double luminance_of(float error) {
  const auto color = false_color(error);
  return 0.2126 * static_cast<double>(scene::linear_from_srgb8(color[0])) +
         0.7152 * static_cast<double>(scene::linear_from_srgb8(color[1])) +
         0.0722 * static_cast<double>(scene::linear_from_srgb8(color[2]));
}

TEST(FalseColor, GoesFromBlackToPaleYellow) {
  EXPECT_EQ(false_color(0.0f), (std::array<std::uint8_t, 3>{0, 0, 0}));
  const auto last = false_color(1.0f);
  EXPECT_GT(last[0], 240);
  EXPECT_GT(last[1], 240);
  EXPECT_LT(last[2], last[0] - 20);
  EXPECT_EQ(false_color(-1.0f), false_color(0.0f));
  EXPECT_EQ(false_color(7.0f), last);
}

TEST(FalseColor, LightnessRisesSteadily) {
  // Within what bytes can say, L* is 98 times the error: no colour of the map is cut off by the limits of
  // sRGB.
  for (int i = 1; i <= 255; ++i) {
    const float error = static_cast<float>(i) / 255.0f;
    EXPECT_GT(luminance_of(error), luminance_of(static_cast<float>(i - 1) / 255.0f) - 1e-3) << i;
    const double y = luminance_of(error);
    const double lightness = y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
    EXPECT_NEAR(lightness, 98.0 * static_cast<double>(error), 1.5) << i;
  }
}

}  // namespace
}  // namespace barrido::compare
