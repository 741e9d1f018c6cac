// Two-dimensional textures: mip chains against a box filter in double precision, aprons against the wrap
// modes, sRGB decoding against the standard's formula, and messages for pictures that cannot be.
#include "raster/textures/texture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "random_texels.h"
#include "raster/textures/texture_srgb.h"

namespace barrido::raster {
namespace {

using testing::byte_texel;
using testing::random_rgba;
using testing::texel_of;

/// Mean of channel c over [x0, x1) × [y0, y1) of a level, by overlap of areas.
double area_mean(const Texture& texture, int level, double x0, double x1, double y0, double y1,
                 std::size_t c) {
  const MipLevel& size = texture.level(level);
  double sum = 0.0;
  for (int j = 0; j < size.height; ++j) {
    const double overlap_y = std::min(y1, j + 1.0) - std::max(y0, static_cast<double>(j));
    if (overlap_y <= 0.0) continue;
    for (int i = 0; i < size.width; ++i) {
      const double overlap_x = std::min(x1, i + 1.0) - std::max(x0, static_cast<double>(i));
      if (overlap_x > 0.0) sum += overlap_x * overlap_y * texture.texel(level, 0, i, j)[c];
    }
  }
  return sum / ((x1 - x0) * (y1 - y0));
}

/// Every level must be the box filter of the one above, to half a step of its format.
void expect_box_filtered(const Texture& texture, double step) {
  for (int level = 1; level < texture.level_count(); ++level) {
    const MipLevel& above = texture.level(level - 1);
    const MipLevel& here = texture.level(level);
    ASSERT_EQ(here.width, std::max(1, above.width / 2));
    ASSERT_EQ(here.height, std::max(1, above.height / 2));
    const double scale_x = static_cast<double>(above.width) / here.width;
    const double scale_y = static_cast<double>(above.height) / here.height;
    for (int j = 0; j < here.height; ++j) {
      for (int i = 0; i < here.width; ++i) {
        for (std::size_t c = 0; c < 4; ++c) {
          const double expected = area_mean(texture, level - 1, i * scale_x, (i + 1) * scale_x, j * scale_y,
                                            (j + 1) * scale_y, c);
          ASSERT_NEAR(texture.texel(level, 0, i, j)[c], expected, 0.51 * step)
              << "level " << level << " texel " << i << ", " << j << " channel " << c;
        }
      }
    }
  }
}

struct SizeCase {
  int width, height, levels;
};

class MipChain : public ::testing::TestWithParam<SizeCase> {};

TEST_P(MipChain, IsTheAreaWeightedBoxFilter) {
  const auto [width, height, levels] = GetParam();
  const auto rgba = random_rgba(width, height, 7);
  TextureOptions options;
  const Texture linear = Texture::make_2d({width, height, rgba}, options);
  EXPECT_EQ(linear.level_count(), levels);
  expect_box_filtered(linear, 1.0 / 255);
  options.encoding = Encoding::srgb;
  expect_box_filtered(Texture::make_2d({width, height, rgba}, options), 1.0 / 65535);
}

INSTANTIATE_TEST_SUITE_P(Sizes, MipChain,
                         ::testing::Values(SizeCase{1, 1, 1}, SizeCase{5, 3, 3}, SizeCase{1, 9, 4},
                                           SizeCase{7, 1, 3}, SizeCase{6, 5, 3}, SizeCase{64, 64, 7},
                                           SizeCase{37, 20, 6}));

TEST(Texture, OddMipValuesByHand) {
  // 3 × 1 → 1 × 1: the mean of all three. 5 × 1 → 2 × 1: weights 2, 2, 1 and 1, 2, 2 of 5.
  const std::uint8_t three[12] = {30, 0, 0, 255, 60, 3, 0, 255, 90, 255, 2, 0};
  const Texture small = Texture::make_2d({3, 1, three}, {});
  EXPECT_EQ(byte_texel(small, 1, 0, 0, 0), (std::array<int, 4>{60, 86, 1, 170}));
  const std::uint8_t five[20] = {10, 0, 0, 0, 20, 0, 0, 0, 50, 0, 0, 0, 100, 0, 0, 0, 200, 0, 0, 0};
  const Texture wide = Texture::make_2d({5, 1, five}, {});
  EXPECT_EQ(byte_texel(wide, 1, 0, 0, 0)[0], (2 * 10 + 2 * 20 + 50 + 2) / 5);
  EXPECT_EQ(byte_texel(wide, 1, 0, 1, 0)[0], (50 + 2 * 100 + 2 * 200 + 2) / 5);
}

TEST(Texture, CheckerOf256BecomesGreyAndStaysGrey) {
  std::vector<std::uint8_t> rgba(256 * 256 * 4);
  for (std::size_t k = 0; k < rgba.size(); ++k) rgba[k] = ((k / 4 + k / 1024) % 2) != 0 ? 255 : 0;
  const Texture texture = Texture::make_2d({256, 256, rgba}, {});
  ASSERT_EQ(texture.level_count(), 9);
  for (int level = 1; level < 9; ++level) {
    const std::vector<std::uint8_t> bytes = texture.level_rgba8(level);
    EXPECT_TRUE(std::all_of(bytes.begin(), bytes.end(), [](std::uint8_t b) { return b == 128; })) << level;
  }
}

TEST(Texture, NoMipmapsMeansOneLevel) {
  const auto rgba = random_rgba(16, 8, 3);
  TextureOptions options;
  options.mipmaps = false;
  const Texture texture = Texture::make_2d({16, 8, rgba}, options);
  EXPECT_EQ(texture.level_count(), 1);
  EXPECT_EQ(texture.level_rgba8(0), rgba);
}

TEST(Texture, LevelsGivenByTheCallerAreKept) {
  const auto base = random_rgba(5, 2, 1);
  const auto half = random_rgba(2, 1, 2);
  const auto last = random_rgba(1, 1, 3);
  const Pixels8 levels[] = {{5, 2, base}, {2, 1, half}, {1, 1, last}};
  const Texture texture = Texture::make_2d_levels(levels, {});
  ASSERT_EQ(texture.level_count(), 3);
  EXPECT_EQ(texture.level_rgba8(0), base);
  EXPECT_EQ(texture.level_rgba8(1), half);
  EXPECT_EQ(texture.level_rgba8(2), last);
}

// What stands at −1 and at n: literal, so that a mistake in the wrap arithmetic cannot hide in its own test.
struct WrapCase {
  Wrap wrap;
  int before;  ///< Texel 0..4 of a row of five, or -1 for the border colour.
  int after;
};

class Apron : public ::testing::TestWithParam<WrapCase> {};

TEST_P(Apron, HoldsWhatTheWrapModeSays) {
  const WrapCase& expected = GetParam();
  const std::array<int, 4> border{255, 51, 0, 102};
  for (const Encoding encoding : {Encoding::linear, Encoding::srgb}) {
    const auto rgba = random_rgba(5, 5, 11);
    TextureOptions options;
    options.encoding = encoding;
    options.border_color = {1.0f, 0.2f, 0.0f, 0.4f};
    options.mipmaps = false;
    const auto source = [&](int place, int i, int j) {
      return place < 0 ? border : byte_texel(Texture::make_2d({5, 5, rgba}, options), 0, 0, i, j);
    };
    options.wrap_s = expected.wrap;
    options.wrap_t = Wrap::repeat;
    const Texture across = Texture::make_2d({5, 5, rgba}, options);
    EXPECT_EQ(byte_texel(across, 0, 0, -1, 2), source(expected.before, expected.before, 2));
    EXPECT_EQ(byte_texel(across, 0, 0, 5, 2), source(expected.after, expected.after, 2));
    // Corners: t repeats, so the row above the last is row 0.
    EXPECT_EQ(byte_texel(across, 0, 0, -1, 5), source(expected.before, expected.before, 0));
    EXPECT_EQ(byte_texel(across, 0, 0, 5, -1), source(expected.after, expected.after, 4));
    options.wrap_s = Wrap::repeat;
    options.wrap_t = expected.wrap;
    const Texture down = Texture::make_2d({5, 5, rgba}, options);
    EXPECT_EQ(byte_texel(down, 0, 0, 3, -1), source(expected.before, 3, expected.before));
    EXPECT_EQ(byte_texel(down, 0, 0, 3, 5), source(expected.after, 3, expected.after));
  }
}

INSTANTIATE_TEST_SUITE_P(Wraps, Apron,
                         ::testing::Values(WrapCase{Wrap::repeat, 4, 0},
                                           WrapCase{Wrap::mirrored_repeat, 0, 4},
                                           WrapCase{Wrap::clamp_to_edge, 0, 4},
                                           WrapCase{Wrap::clamp_to_border, -1, -1},
                                           WrapCase{Wrap::clamp, -1, -1}));

TEST(Texture, ApronOfOneTexel) {
  const std::uint8_t texel[4] = {1, 2, 3, 4};
  const Texture texture = Texture::make_2d({1, 1, texel}, {});
  for (int j = -1; j <= 1; ++j) {
    for (int i = -1; i <= 1; ++i) {
      EXPECT_EQ(byte_texel(texture, 0, 0, i, j), (std::array<int, 4>{1, 2, 3, 4}));
    }
  }
}

TEST(Texture, SrgbTableIsTheStandardsFormula) {
  for (int b = 0; b < 256; ++b) {
    const double c = b / 255.0;
    const double linear = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    EXPECT_EQ(kLinear16FromSrgb8[static_cast<std::size_t>(b)], std::lround(linear * 65535.0)) << b;
  }
}

TEST(Texture, SrgbDecodesColoursAndNotAlpha) {
  const std::uint8_t texel[4] = {188, 0, 255, 188};
  TextureOptions options;
  options.encoding = Encoding::srgb;
  const Texture texture = Texture::make_2d({1, 1, texel}, options);
  EXPECT_EQ(texture.format(), TexelFormat::rgba16);
  const std::array<float, 4> color = texture.texel(0, 0, 0, 0);
  EXPECT_NEAR(color[0], 0.50289f, 1e-5f);
  EXPECT_EQ(color[1], 0.0f);
  EXPECT_EQ(color[2], 1.0f);
  EXPECT_NEAR(color[3], 188.0f / 255.0f, 1e-7f);
  EXPECT_EQ(texture.level_rgba8(0), (std::vector<std::uint8_t>{128, 0, 255, 188}));
}

TEST(Texture, ImpossiblePicturesAreRefusedWithTheReason) {
  const auto rgba = random_rgba(4, 4, 5);
  const auto message_of = [](auto make) -> std::string {
    try {
      make();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(message_of([&] {
              Texture::make_2d({0, 4, rgba}, {});
            }),
            "texture of 0 × 4 texels: each side must be in 1..16384");
  EXPECT_EQ(message_of([&] {
              Texture::make_2d({4, 16385, rgba}, {});
            }),
            "texture of 4 × 16385 texels: each side must be in 1..16384");
  EXPECT_EQ(message_of([&] {
              Texture::make_2d({4, 5, rgba}, {});
            }),
            "texture of 4 × 5 texels: 64 bytes given, 80 needed");
  const Pixels8 wrong[] = {{4, 4, rgba}, {4, 4, rgba}};
  EXPECT_EQ(message_of([&] { Texture::make_2d_levels(wrong, {}); }),
            "texture level 1 of 4 × 4 texels: 2 × 2 texels expected");
  EXPECT_EQ(message_of([&] { Texture::make_2d_levels({}, {}); }), "texture without levels");
}

}  // namespace
}  // namespace barrido::raster
