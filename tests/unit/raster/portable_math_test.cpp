// The portable elementary functions against the C library's in double precision: the errors that their
// documentation promises, and what they do with numbers that are none.
#include "raster/base/portable_math.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace barrido {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A number in [low, high) from raw bits.
double uniform(std::mt19937_64& bits, double low, double high) {
  return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
}

TEST(PortableMath, Log2) {
  std::mt19937_64 bits(1);
  for (int k = 0; k < 200000; ++k) {
    const auto x = static_cast<float>(std::exp2(uniform(bits, -126.0, 127.9)));
    const double exact = std::log2(static_cast<double>(x));
    // Relative near 1, absolute where the exponent dominates.
    ASSERT_NEAR(portable_log2(x), exact, 2e-7 * std::max(std::fabs(exact), 0.5)) << x;
    const auto near_one = static_cast<float>(uniform(bits, 0.75, 1.4));
    const double exact_near = std::log2(static_cast<double>(near_one));
    ASSERT_NEAR(portable_log2(near_one), exact_near, 2.5e-7 * std::fabs(exact_near)) << near_one;
  }
  EXPECT_EQ(portable_log2(1.0f), 0.0f);
  EXPECT_EQ(portable_log2(1024.0f), 10.0f);
  EXPECT_EQ(portable_log2(0.0f), -126.0f);
  EXPECT_EQ(portable_log2(-3.0f), -126.0f);
  EXPECT_EQ(portable_log2(kNaN), -126.0f);
}

TEST(PortableMath, Turn) {
  std::mt19937_64 bits(5);
  for (int k = 0; k < 200000; ++k) {
    const auto x = static_cast<float>(uniform(bits, -2.0, 2.0));
    const auto y = static_cast<float>(uniform(bits, -2.0, 2.0));
    const double exact = std::atan2(static_cast<double>(y), static_cast<double>(x)) / (2.0 * kPi);
    ASSERT_NEAR(portable_turn(y, x), exact, 4e-8) << y << " " << x;
  }
  EXPECT_EQ(portable_turn(0.0f, 1.0f), 0.0f);
  EXPECT_EQ(portable_turn(1.0f, 0.0f), 0.25f);
  EXPECT_EQ(portable_turn(0.0f, -1.0f), 0.5f);
  EXPECT_EQ(portable_turn(-1.0f, 0.0f), -0.25f);
  EXPECT_EQ(portable_turn(0.0f, 0.0f), 0.0f);
}

TEST(PortableMath, Exp2) {
  std::mt19937_64 bits(2);
  for (int k = 0; k < 200000; ++k) {
    const auto x = static_cast<float>(uniform(bits, -126.0, 127.49));
    const double exact = std::exp2(static_cast<double>(x));
    ASSERT_NEAR(portable_exp2(x) / exact, 1.0, 2e-7) << x;
  }
  for (int n = -126; n <= 127; ++n) EXPECT_EQ(portable_exp2(static_cast<float>(n)), std::ldexp(1.0f, n));
  EXPECT_EQ(portable_exp2(127.75f), portable_exp2(127.49f));
  EXPECT_EQ(portable_exp2(-127.0f), 0.0f);
  EXPECT_EQ(portable_exp2(-kInfinity), 0.0f);
  EXPECT_TRUE(std::isfinite(portable_exp2(kInfinity)));
  EXPECT_TRUE(std::isfinite(portable_exp2(kNaN)));
}

TEST(PortableMath, Pow) {
  std::mt19937_64 bits(3);
  for (int k = 0; k < 100000; ++k) {
    const auto x = static_cast<float>(uniform(bits, 0.01, 1.0));
    const auto n = static_cast<float>(uniform(bits, 0.1, 200.0));
    const double exact = std::pow(static_cast<double>(x), static_cast<double>(n));
    // The error of n·log2 x grows with its size: up to half an ulp of 1400 in the exponent.
    if (exact < 1e-30) continue;
    ASSERT_NEAR(portable_pow(x, n) / exact, 1.0, exact > 1.0 / 1024 ? 2e-6 : 5e-5) << x << "^" << n;
  }
  EXPECT_EQ(portable_pow(0.0f, 0.0f), 1.0f);
  EXPECT_EQ(portable_pow(0.0f, 5.0f), 0.0f);
  EXPECT_EQ(portable_pow(-1.0f, 2.0f), 0.0f);
  EXPECT_EQ(portable_pow(1.0f, 200.0f), 1.0f);
  EXPECT_EQ(portable_pow(kNaN, 2.0f), 0.0f);
}

TEST(PortableMath, SineAndCosine) {
  std::mt19937_64 bits(4);
  for (const double range : {1.0, 10.0, 1000.0, 1e6}) {
    for (int k = 0; k < 100000; ++k) {
      const double x = uniform(bits, -range, range);
      ASSERT_NEAR(portable_sin(x), std::sin(x), 1e-15) << x;
      ASSERT_NEAR(portable_cos(x), std::cos(x), 1e-15) << x;
    }
  }
  EXPECT_EQ(portable_sin(0.0), 0.0);
  EXPECT_EQ(portable_cos(0.0), 1.0);
  EXPECT_TRUE(std::isfinite(portable_sin(kInfinity)));
  EXPECT_TRUE(std::isfinite(portable_cos(kNaN)));
}

TEST(PortableMath, ArcFunctions) {
  std::mt19937_64 bits(5);
  for (int k = 0; k < 100000; ++k) {
    const double x = uniform(bits, -10.0, 10.0);
    const double y = uniform(bits, -10.0, 10.0);
    ASSERT_NEAR(portable_atan2(y, x), std::atan2(y, x), 2e-15) << y << " " << x;
    const double c = uniform(bits, -1.0, 1.0);
    ASSERT_NEAR(portable_acos(c), std::acos(c), 2e-15) << c;
    ASSERT_NEAR(portable_asin(c), std::asin(c), 2e-15) << c;
  }
  EXPECT_EQ(portable_atan2(0.0, 0.0), 0.0);
  EXPECT_NEAR(portable_atan2(0.0, -1.0), kPi, 1e-15);
  EXPECT_NEAR(portable_atan2(-1.0, 0.0), -kPi / 2, 1e-15);
  EXPECT_EQ(portable_acos(2.0), 0.0);
  EXPECT_NEAR(portable_acos(-2.0), kPi, 1e-15);
}

}  // namespace
}  // namespace barrido
