// Literal tables for the comparisons, the blend factors and equations, and rounding of stored colours.
#include "raster/reference/fragment_operations.h"

#include <gtest/gtest.h>

#include <limits>

namespace barrido::raster::reference {
namespace {

TEST(FragmentOperations, Compare) {
  // Results for incoming less than, equal to and greater than the stored value, and for NaN.
  const struct {
    Compare how;
    bool less, equal, greater, nan;
  } table[] = {
      {Compare::never, false, false, false, false},       {Compare::less, true, false, false, false},
      {Compare::equal, false, true, false, false},        {Compare::less_equal, true, true, false, false},
      {Compare::greater, false, false, true, false},      {Compare::not_equal, true, false, true, true},
      {Compare::greater_equal, false, true, true, false}, {Compare::always, true, true, true, true},
  };
  for (const auto& row : table) {
    EXPECT_EQ(compare(row.how, 0.25f, 0.5f), row.less) << static_cast<int>(row.how);
    EXPECT_EQ(compare(row.how, 0.5f, 0.5f), row.equal) << static_cast<int>(row.how);
    EXPECT_EQ(compare(row.how, 0.75f, 0.5f), row.greater) << static_cast<int>(row.how);
    EXPECT_EQ(compare(row.how, std::numeric_limits<float>::quiet_NaN(), 0.5f), row.nan)
        << static_cast<int>(row.how);
  }
}

// Values whose products and complements are exact in float.
constexpr Color kSource{0.25f, 0.5f, 0.75f, 0.625f};
constexpr Color kDestination{0.125f, 0.375f, 1.0f, 0.875f};
constexpr Color kConstant{0.0625f, 0.3125f, 0.5625f, 0.9375f};

TEST(FragmentOperations, BlendFactors) {
  const struct {
    BlendFactor factor;
    Color expected;
  } table[] = {
      {BlendFactor::zero, {0, 0, 0, 0}},
      {BlendFactor::one, {1, 1, 1, 1}},
      {BlendFactor::src_color, {0.25f, 0.5f, 0.75f, 0.625f}},
      {BlendFactor::one_minus_src_color, {0.75f, 0.5f, 0.25f, 0.375f}},
      {BlendFactor::dst_color, {0.125f, 0.375f, 1.0f, 0.875f}},
      {BlendFactor::one_minus_dst_color, {0.875f, 0.625f, 0.0f, 0.125f}},
      {BlendFactor::src_alpha, {0.625f, 0.625f, 0.625f, 0.625f}},
      {BlendFactor::one_minus_src_alpha, {0.375f, 0.375f, 0.375f, 0.375f}},
      {BlendFactor::dst_alpha, {0.875f, 0.875f, 0.875f, 0.875f}},
      {BlendFactor::one_minus_dst_alpha, {0.125f, 0.125f, 0.125f, 0.125f}},
      {BlendFactor::constant_color, {0.0625f, 0.3125f, 0.5625f, 0.9375f}},
      {BlendFactor::one_minus_constant_color, {0.9375f, 0.6875f, 0.4375f, 0.0625f}},
      {BlendFactor::constant_alpha, {0.9375f, 0.9375f, 0.9375f, 0.9375f}},
      {BlendFactor::one_minus_constant_alpha, {0.0625f, 0.0625f, 0.0625f, 0.0625f}},
      {BlendFactor::src_alpha_saturate, {0.125f, 0.125f, 0.125f, 1.0f}},
  };
  ASSERT_EQ(std::size(table), 15u);
  for (const auto& row : table) {
    EXPECT_EQ(blend_factor(row.factor, row.factor, kSource, kDestination, kConstant), row.expected)
        << static_cast<int>(row.factor);
    // Alpha has a factor of its own.
    Color mixed = row.expected;
    mixed[3] = 0.0f;
    EXPECT_EQ(blend_factor(row.factor, BlendFactor::zero, kSource, kDestination, kConstant), mixed);
  }
}

TEST(FragmentOperations, BlendEquations) {
  // Factors ½ and ¼ from the constant colour's channels would differ by channel; alpha factors are the same.
  const struct {
    BlendEquation equation;
    Color expected;
  } table[] = {
      {BlendEquation::add, {0.25f * 0.5f + 0.125f * 0.5f, 0.5f * 0.5f + 0.375f * 0.5f, 0.875f, 0.75f}},
      {BlendEquation::subtract, {0.0625f, 0.0625f, -0.125f, -0.125f}},
      {BlendEquation::reverse_subtract, {-0.0625f, -0.0625f, 0.125f, 0.125f}},
      {BlendEquation::min, {0.125f, 0.375f, 0.75f, 0.625f}},
      {BlendEquation::max, {0.25f, 0.5f, 1.0f, 0.875f}},
  };
  for (const auto& row : table) {
    BlendState state{true,
                     BlendFactor::constant_alpha,
                     BlendFactor::one_minus_constant_alpha,
                     BlendFactor::constant_alpha,
                     BlendFactor::one_minus_constant_alpha,
                     row.equation,
                     {0, 0, 0, 0.5f}};
    EXPECT_EQ(blend(state, kSource, kDestination), row.expected) << static_cast<int>(row.equation);
    state.enabled = false;
    EXPECT_EQ(blend(state, kSource, kDestination), kSource);
  }
}

TEST(FragmentOperations, Rgba8RoundsToNearestAndClamps) {
  EXPECT_EQ(pack_rgba8({0.0f, 1.0f, 0.5f, -3.0f}), 0x0080ff00u);
  EXPECT_EQ(pack_rgba8({2.0f, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(),
                        0.499f / 255.0f}),
            0x0000ffffu);
  // 0.1·255 is 25.5 and 0.3·255 is 76.5 in float: ties go to the even number.
  EXPECT_EQ(pack_rgba8({0.1f, 0.3f, 0.5f, 0.7f}), 0xb2804c1au);
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    const std::uint32_t packed = byte * 0x01010101u;
    EXPECT_EQ(pack_rgba8(unpack_rgba8(packed)), packed);
  }
}

TEST(FragmentOperations, Scissor) {
  const Scissor scissor{true, 2, 3, 4, 1};
  EXPECT_TRUE(is_inside_scissor(scissor, 2, 3));
  EXPECT_TRUE(is_inside_scissor(scissor, 5, 3));
  EXPECT_FALSE(is_inside_scissor(scissor, 6, 3));
  EXPECT_FALSE(is_inside_scissor(scissor, 1, 3));
  EXPECT_FALSE(is_inside_scissor(scissor, 2, 4));
  EXPECT_FALSE(is_inside_scissor(scissor, 2, 2));
  EXPECT_TRUE(is_inside_scissor({false, 2, 3, 4, 1}, 100, 100));
  constexpr int kHuge = std::numeric_limits<int>::max();
  EXPECT_TRUE(is_inside_scissor({true, 1, 1, kHuge, kHuge}, 5000, 5000));
  EXPECT_FALSE(is_inside_scissor({true, 1, 1, -kHuge, kHuge}, 5000, 5000));
}

}  // namespace
}  // namespace barrido::raster::reference
