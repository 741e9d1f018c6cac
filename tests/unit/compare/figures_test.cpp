// Figures of small pictures, reckoned by hand; thresholds at their borders.
#include "viewer/compare/figures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/compare/pictures.h"

namespace barrido::compare::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

scene::StoredPicture floats(std::vector<float> rgba) {
  return {static_cast<int>(rgba.size() / 4), 1, 3, true, false, std::move(rgba)};
}

TEST(Figures, OfEqualPicturesAreZero) {
  const auto picture = picture_of(7, 5, [](int x, int y, int c) { return x * 30 + y * 5 + c; });
  const Figures figures = measure(picture, picture, {});
  EXPECT_EQ(figures.mean, 0.0);
  EXPECT_EQ(figures.rms, 0.0);
  EXPECT_EQ(figures.max, 0.0);
  EXPECT_EQ(figures.psnr(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(figures.pixels, 35u);
  EXPECT_EQ(figures.over_fail + figures.over_warn + figures.over_zero, 0u);
  EXPECT_EQ(judge(figures, {}), Verdict::same);
}

TEST(Figures, AreTheMeansOfAllValues) {
  // Of 4 × 2 pixels two differ: one in green by 51/255, one in red by −102/255 and in blue by 102/255.
  const auto expected = flat(4, 2, 102);
  const auto actual = picture_of(4, 2, [](int x, int y, int c) {
    if (x == 1 && y == 0) return c == 1 ? 153 : 102;
    if (x == 3 && y == 1) return c == 0 ? 0 : c == 2 ? 204 : 102;
    return 102;
  });
  Thresholds thresholds;
  thresholds.fail = 0.3;
  const Figures figures = measure(expected, actual, thresholds);
  EXPECT_EQ(figures.channels, 3);
  EXPECT_NEAR(figures.mean, (0.2 + 0.4 + 0.4) / 24, 1e-8);
  EXPECT_NEAR(figures.rms, std::sqrt((0.04 + 0.16 + 0.16) / 24), 1e-8);
  EXPECT_NEAR(figures.psnr(), -20 * std::log10(figures.rms), 1e-9);
  EXPECT_NEAR(figures.max, 0.4, 1e-7);
  EXPECT_EQ(figures.worst.x, 3);
  EXPECT_EQ(figures.worst.y, 1);
  EXPECT_EQ(figures.worst.channel, 0) << "the first of equal ones";
  EXPECT_FLOAT_EQ(figures.worst.expected[0], 0.4f);
  EXPECT_FLOAT_EQ(figures.worst.actual[0], 0.0f);
  EXPECT_EQ(figures.over_warn, 2u);
  EXPECT_EQ(figures.over_fail, 1u);
}

TEST(Figures, CompareTheChannelsThatAreStored) {
  auto grey = flat(2, 2, 255), grey_darker = flat(2, 2, 204);
  grey.channels = grey_darker.channels = 1;
  const Figures one = measure(grey, grey_darker, {});
  EXPECT_EQ(one.channels, 1);
  EXPECT_NEAR(one.mean, 0.2, 1e-7);

  auto with_alpha = flat(2, 2, 255);
  with_alpha.channels = 4;
  with_alpha.rgba[3] = 0.5f;  // of the first pixel
  const Figures alpha = measure(grey, with_alpha, {});
  EXPECT_EQ(alpha.channels, 4) << "grey meets RGBA: all are compared, grey as R, G and B, opaque";
  EXPECT_NEAR(alpha.mean, 0.5 / 16, 1e-9);
  EXPECT_EQ(alpha.worst.channel, 3);
}

TEST(Figures, WhatASmallerPictureLacksCountsAsZero) {
  const Figures figures = measure(flat(4, 3, 255), flat(2, 5, 255), {});
  EXPECT_EQ(figures.pixels, 20u);
  // (2..3, 0..2) is only in the first, (0..1, 3..4) only in the second; the rest of the 4 × 5 in neither.
  EXPECT_EQ(figures.over_fail, 10u);
  EXPECT_NEAR(figures.mean, 0.5, 1e-9);
  EXPECT_EQ(figures.worst.x, 2);
  EXPECT_EQ(figures.worst.y, 0);
}

TEST(Figures, PeakIsTheGreatestValueOfFloats) {
  const Figures figures = measure(floats({4, 1, 1, 1, 0, 0, 0, 1}), floats({4, 1, 1, 1, 1, 0, 0, 1}), {});
  EXPECT_EQ(figures.peak, 4.0);
  EXPECT_NEAR(figures.psnr(), 20 * std::log10(4 / std::sqrt(1.0 / 6)), 1e-9);
}

TEST(Figures, ValuesThatAreNoNumbers) {
  const auto same = floats({kNan, kInfinity, -kInfinity, 1});
  EXPECT_EQ(measure(same, same, {}).max, 0.0);
  for (const float other : {1.0f, kInfinity, -kInfinity}) {
    const Figures figures = measure(floats({kNan, 0.5f, 0, 1}), floats({other, 0.25f, 0, 1}), {});
    EXPECT_EQ(figures.max, kInfinity);
    EXPECT_EQ(figures.worst.channel, 0);
    EXPECT_EQ(figures.over_fail, 1u);
    EXPECT_EQ(figures.incomparable, 1u);
    EXPECT_TRUE(std::isnan(figures.mean) && std::isnan(figures.rms) && std::isnan(figures.psnr()));
    EXPECT_EQ(judge(figures, {}), Verdict::different);
  }
  EXPECT_EQ(measure(floats({kInfinity, 0, 0, 1}), floats({-kInfinity, 0, 0, 1}), {}).max, kInfinity);
}

Figures figures_with(std::uint64_t over_fail, std::uint64_t over_warn, double max) {
  Figures figures;
  figures.pixels = 1000;
  figures.over_fail = over_fail;
  figures.over_warn = over_warn;
  figures.max = max;
  return figures;
}

TEST(Judge, PixelsMayFailUpToThePercentage) {
  Thresholds thresholds;
  thresholds.fail_percent = 1.0;
  thresholds.warn_percent = 5.0;
  EXPECT_EQ(judge(figures_with(10, 50, 1), thresholds), Verdict::same);
  EXPECT_EQ(judge(figures_with(10, 51, 1), thresholds), Verdict::warning);
  EXPECT_EQ(judge(figures_with(11, 11, 1), thresholds), Verdict::different);
}

TEST(Judge, OrUpToANumber) {
  Thresholds thresholds;
  thresholds.allow_failures = 3;
  thresholds.warn_percent = 100;
  EXPECT_EQ(judge(figures_with(3, 3, 1), thresholds), Verdict::same);
  EXPECT_EQ(judge(figures_with(4, 4, 1), thresholds), Verdict::different);
}

TEST(Judge, HardThresholdsAllowNoPixel) {
  Thresholds thresholds;
  thresholds.fail_percent = thresholds.warn_percent = 100;
  thresholds.hard_fail = 0.5;
  thresholds.hard_warn = 0.25;
  EXPECT_EQ(judge(figures_with(1, 1, 0.25), thresholds), Verdict::same);
  EXPECT_EQ(judge(figures_with(1, 1, 0.26), thresholds), Verdict::warning);
  EXPECT_EQ(judge(figures_with(1, 1, 0.51), thresholds), Verdict::different);
}

}  // namespace
}  // namespace barrido::compare::test
