// Float pixels as they are shown: exposure, tone reproduction, sRGB, each against the formula in double; and
// the rows of the kernel against the reference, bit for bit.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "raster/base/simd_target.h"
#include "raster/kernels/kernels.h"
#include "raster/reference/resolve.h"

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

constexpr int kPixels = 96;
constexpr int kRoom = 16;  ///< Elements that whole vectors may reach past the pixels.

/// Colours of every kind: usual ones, very bright ones, and any bits at all, NaNs and infinities among them.
void fill(std::mt19937& random, float (&channels)[4][kPixels + kRoom]) {
  std::uniform_real_distribution<float> usual(-0.25f, 4.0f);
  for (float(&channel)[kPixels + kRoom] : channels) {
    for (float& c : channel) {
      const unsigned kind = random() % 4;
      c = kind == 0 ? std::bit_cast<float>(static_cast<std::uint32_t>(random())) : usual(random);
      if (kind == 1) c *= 1e5f;
    }
  }
}

TEST(Resolve, RowsOfTheKernelAreTheReference) {
  std::mt19937 random(14);
  alignas(64) float channels[4][kPixels + kRoom];
  alignas(64) std::uint32_t shown[kPixels + kRoom];
  for (int k = 0; k < 200; ++k) {
    fill(random, channels);
    const DisplayTransform display{std::exp2(static_cast<float>(k % 9 - 4)),
                                   k % 2 == 0 ? ToneMap::clamp : ToneMap::reinhard, k % 4 < 2};
    const int count = 1 + static_cast<int>(random() % kPixels);
    for (const SimdTarget target : available_simd_targets()) {
      set_simd_target(target);
      display_row({{channels[0], channels[1], channels[2], channels[3]}, count}, display, shown);
      for (int i = 0; i < count; ++i) {
        const Color color{channels[0][i], channels[1][i], channels[2][i], channels[3][i]};
        ASSERT_EQ(shown[i], display_color(display, color)) << name_of(target) << " " << k << " " << i;
      }
    }
  }
  set_simd_target(SimdTarget::automatic);
}

TEST(Resolve, FloatRowsAreKeptAsTheyAre) {
  std::mt19937 random(15);
  alignas(64) float channels[4][kPixels + kRoom];
  fill(random, channels);
  for (const SimdTarget target : available_simd_targets()) {
    set_simd_target(target);
    for (int count = 1; count <= kPixels; ++count) {
      std::vector<float> kept(static_cast<std::size_t>(count) * 4 + 1, -1.0f);
      store_float_row({{channels[0], channels[1], channels[2], channels[3]}, count}, kept.data());
      for (std::size_t i = 0; i < static_cast<std::size_t>(count) * 4; ++i) {
        ASSERT_EQ(std::bit_cast<std::uint32_t>(kept[i]),
                  std::bit_cast<std::uint32_t>(channels[i % 4][i / 4]));
      }
      ASSERT_EQ(kept.back(), -1.0f) << "written past the row";
    }
  }
  set_simd_target(SimdTarget::automatic);
}

}  // namespace
}  // namespace barrido::raster::reference
