// Filters that follow the pixel's footprint, of the reference (the kernels are compared with it in
// tests/kernels): Catmull's mean against the closed form on the infinite checker and against mip levels,
// Crow's corners by hand, the number of anisotropic samples by the extension's formula.
#include "raster/reference/wide_filters.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "random_texels.h"

namespace barrido::raster::reference {
namespace {

using raster::testing::random_rgba;

/// 2 × 2 texels: 1 where ⌊x⌋ + ⌊y⌋ is odd, repeated.
Texture checker() {
  const std::vector<std::uint8_t> rgba{0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 255};
  TextureOptions options;
  options.mipmaps = false;
  return Texture::make_2d({2, 2, rgba}, options);
}

/// i(x) of the closed form (Íñigo Quílez): the mean of the checker under a box of side w about (x, y) is
/// ½ − ½ i(x) i(y).
double box_integral(double x, double w) {
  const auto fraction = [](double v) { return v - std::floor(v); };
  return 2.0 * (std::abs(fraction((x - w / 2) / 2) - 0.5) - std::abs(fraction((x + w / 2) / 2) - 0.5)) / w;
}

TextureUnit footprint_unit(const Texture& texture) {
  TextureUnit unit;
  unit.texture = &texture;
  unit.min_filter = MinFilter::footprint;
  return unit;
}

/// An upright box of w × h texels about (x, y), in texels.
WideSample box(const TextureUnit& unit, double x, double y, double w, double h) {
  const double width = unit.texture->width(), height = unit.texture->height();
  CoordinateSlopes slopes;
  slopes.ux = static_cast<float>(w / width);
  slopes.vy = static_cast<float>(h / height);
  const float place[3] = {static_cast<float>(x / width), static_cast<float>(y / height), 0};
  return sample_wide(unit, TexcoordKind::plain, place, 1.0f, slopes);
}

TEST(FootprintMean, IsTheClosedFormOnTheInfiniteChecker) {  // T18
  const Texture texture = checker();
  const TextureUnit unit = footprint_unit(texture);
  const struct {
    double x, y, w, mean;
  } published[] = {{.25, .25, 1, .375}, {.25, .75, 1.5, .444444}, {.3, .6, 3, .473333},
                   {1, .5, .5, .5},     {.1, .7, 2, .5},          {1.3, 0.2, 2, .5}};
  for (const auto& row : published) {
    EXPECT_NEAR(box(unit, row.x, row.y, row.w, row.w).color[0], row.mean, 1e-5) << row.x << " " << row.w;
  }
  for (int k = 0; k < 400; ++k) {
    const double x = 0.013 * k, y = 0.37 + 0.029 * k, w = 0.1 + 0.035 * k, h = 0.2 + 0.021 * k;
    const double mean = 0.5 - 0.5 * box_integral(x, w) * box_integral(y, h);
    EXPECT_NEAR(box(unit, x, y, w, h).color[0], mean, 4e-5) << x << " " << y << " " << w << " " << h;
  }
}

TEST(FootprintMean, ReadsEachTexelOfAWholeFootprintOnceAndIsTheMipLevel) {  // T18, T20
  for (const Encoding encoding : {Encoding::linear, Encoding::srgb}) {
    TextureOptions options;
    options.encoding = encoding;
    const Texture texture = Texture::make_2d({64, 64, random_rgba(64, 64, 3)}, options);
    const TextureUnit unit = footprint_unit(texture);
    for (int level = 1; level <= 4; ++level) {
      const int side = 1 << level;
      for (int i = 0; i < 64 / side; ++i) {
        const WideSample sample = box(unit, (i + 0.5) * side, side * 0.5, side, side);
        EXPECT_EQ(sample.texels, static_cast<std::uint32_t>(side * side));
        const Color texel = texture.texel(level, 0, i, 0);
        // The levels' own rounding, once a level.
        const double step = encoding == Encoding::linear ? 255.0 : 65535.0;
        for (std::size_t c = 0; c < 4; ++c)
          EXPECT_NEAR(sample.color[c], texel[c], (0.5 * level + 0.01) / step);
      }
    }
    // Larger ones are sums over the level that has 16 texels a side, so of the same texels.
    const WideSample all = box(unit, 32, 32, 64, 64);
    EXPECT_EQ(all.texels, 256u);
    EXPECT_NEAR(all.color[1], texture.texel(6, 0, 0, 0)[1], 3.5 / 255.0);
  }
}

TEST(FootprintMean, OfOneColourIsThatColour) {
  std::vector<std::uint8_t> rgba;
  for (int k = 0; k < 13 * 7; ++k) rgba.insert(rgba.end(), {77, 1, 254, 200});
  const Texture texture = Texture::make_2d({13, 7, rgba}, {});
  const TextureUnit unit = footprint_unit(texture);
  for (int k = 1; k < 100; ++k) {
    CoordinateSlopes slopes{0.01f * static_cast<float>(k), 0.4f, -0.003f, 0.02f * static_cast<float>(k)};
    const float place[3] = {0.1f * static_cast<float>(k), 0.3f, 0};
    const Color color = sample_wide(unit, TexcoordKind::plain, place, 1.0f, slopes).color;
    EXPECT_EQ(color, (Color{77 * (1.0f / 255.0f), 1 * (1.0f / 255.0f), 254 * (1.0f / 255.0f),
                            200 * (1.0f / 255.0f)}));
  }
}

/// The share of each texel that lies under a slanted footprint, by 400 × 400 points of it.
double brute_force(const Texture& texture, double x, double y, const CoordinateSlopes& texels) {
  double sum = 0;
  constexpr int kPoints = 400;
  for (int a = 0; a < kPoints; ++a) {
    for (int b = 0; b < kPoints; ++b) {
      const double s = (a + 0.5) / kPoints - 0.5, t = (b + 0.5) / kPoints - 0.5;
      const auto i = static_cast<int>(std::floor(x + s * texels.ux + t * texels.uy));
      const auto j = static_cast<int>(std::floor(y + s * texels.vx + t * texels.vy));
      const auto wrapped = [](int k, int n) { return (k % n + n) % n; };
      sum += texture.texel(0, 0, wrapped(i, texture.width()), wrapped(j, texture.height()))[0];
    }
  }
  return sum / kPoints / kPoints;
}

TEST(FootprintMean, FollowsASlantedFootprint) {
  const Texture texture = Texture::make_2d({32, 16, random_rgba(32, 16, 5)}, {});
  const TextureUnit unit = footprint_unit(texture);
  const CoordinateSlopes shapes[] = {
      {6, 2, 1, 5}, {8, -3, 8, 3}, {3, 3, -5, 5}, {12, 0.5f, 6, 1}, {0.5f, 9, 0, 4}};
  for (const CoordinateSlopes& texels : shapes) {
    const CoordinateSlopes slopes{texels.ux / 32, texels.uy / 32, texels.vx / 16, texels.vy / 16};
    const float place[3] = {9.3f / 32, 4.8f / 16, 0};
    const double mean = sample_wide(unit, TexcoordKind::plain, place, 1.0f, slopes).color[0];
    EXPECT_NEAR(mean, brute_force(texture, 9.3, 4.8, texels), 2e-3) << texels.ux << " " << texels.uy;
  }
}

TEST(Corners, AreTheMeanOfFourTexels) {  // T19
  const Texture texture = Texture::make_2d({16, 16, random_rgba(16, 16, 9)}, {});
  TextureUnit unit;
  unit.texture = &texture;
  unit.min_filter = MinFilter::corners;
  CoordinateSlopes slopes{4.0f / 16, 0, 0, 6.0f / 16};
  const float place[3] = {8.5f / 16, 7.5f / 16, 0};
  const WideSample sample = sample_wide(unit, TexcoordKind::plain, place, 1.0f, slopes);
  EXPECT_EQ(sample.texels, 4u);
  for (std::size_t c = 0; c < 4; ++c) {
    const double mean = (double{texture.texel(0, 0, 6, 4)[c]} + texture.texel(0, 0, 10, 4)[c] +
                         texture.texel(0, 0, 6, 10)[c] + texture.texel(0, 0, 10, 10)[c]) /
                        4;
    EXPECT_NEAR(sample.color[c], mean, 1e-6);
  }
  unit.mag_filter = MagFilter::nearest;
  const Color magnified = sample_wide(unit, TexcoordKind::plain, place, -1.0f, slopes).color;
  EXPECT_NEAR(magnified[0], texture.texel(0, 0, 8, 7)[0], 1e-6);
}

/// N of EXT_texture_filter_anisotropic, by the number of texels that are read.
int samples(int most, float px, float py) {
  static const Texture texture = Texture::make_2d({256, 256, random_rgba(256, 256, 1)}, {});
  TextureUnit unit;
  unit.texture = &texture;
  unit.min_filter = MinFilter::nearest_mipmap_nearest;
  unit.mag_filter = MagFilter::nearest;
  unit.max_anisotropy = most;
  const CoordinateSlopes slopes{px / 256, 0, 0, py / 256};
  const float place[3] = {0.4f, 0.4f, 0};
  return static_cast<int>(sample_wide(unit, TexcoordKind::plain, place, 3.0f, slopes).texels);
}

TEST(Anisotropy, TakesSamplesByTheRatioOfTheSides) {
  EXPECT_EQ(samples(16, 8, 8), 1);
  EXPECT_EQ(samples(16, 8, 4), 2);
  EXPECT_EQ(samples(16, 8, 3.9f), 3);
  EXPECT_EQ(samples(16, 3, 24), 8);
  EXPECT_EQ(samples(4, 3, 24), 4);
  EXPECT_EQ(samples(16, 1, 64), 16);
  EXPECT_EQ(samples(16, 5, 0), 16);
}

TEST(Anisotropy, ReadsTheLevelOfTheShorterSideAndSamplesAlongTheLonger) {
  // Each level of one colour: 40 a level. The ramp of level 0 would show where samples lie.
  const Texture texture = Texture::make_2d({256, 256, random_rgba(256, 256, 1)}, {});
  TextureUnit unit;
  unit.texture = &texture;
  unit.min_filter = MinFilter::nearest_mipmap_nearest;
  unit.max_anisotropy = 4;
  const CoordinateSlopes slopes{0.5f / 256, 8.0f / 256, 0, 0};
  const float place[3] = {100.5f / 256, 40.5f / 256, 0};
  SampleTrace trace;
  const Color color =
      sample_wide(unit, TexcoordKind::plain, place, 3.0f, slopes, &trace).color;  // λ' = log2(8/4) = 1
  ASSERT_EQ(trace.levels.size(), 4u);
  ASSERT_TRUE(trace.footprint.has_value());
  EXPECT_EQ(trace.footprint->probes, 4);
  double sum = 0;
  for (int k = 0; k < 4; ++k) {
    const LevelTrace& level = trace.levels[static_cast<std::size_t>(k)];
    EXPECT_EQ(level.level, 1);
    // u + 8·((k + 1)/5 − ½) texels of level 0, half as many of level 1.
    const int i = static_cast<int>(std::floor((100.5 + 8 * ((k + 1) / 5.0 - 0.5)) / 2));
    EXPECT_EQ(level.texels[0].i, i);
    sum += double{texture.texel(1, 0, i, 20)[0]} / 4;
  }
  EXPECT_NEAR(color[0], sum, 1e-6);
}

TEST(WideFilters, SurviveNumbersThatAreNone) {
  const Texture texture = Texture::make_2d({8, 8, random_rgba(8, 8, 2)}, {});
  const float bad[] = {std::nanf(""), INFINITY, -INFINITY, 1e38f, 0.0f};
  for (const MinFilter filter : {MinFilter::footprint, MinFilter::corners, MinFilter::linear}) {
    TextureUnit unit;
    unit.texture = &texture;
    unit.min_filter = filter;
    unit.max_anisotropy = 16;
    for (const float a : bad) {
      for (const float b : bad) {
        const float place[3] = {a, 0.5f, 0};
        const WideSample sample = sample_wide(unit, TexcoordKind::plain, place, b, {a, b, b, a});
        EXPECT_LE(sample.texels, 34u * 34u);
        for (const float c : sample.color) EXPECT_TRUE(c >= 0.0f && c <= 1.0f) << a << " " << b;
      }
    }
  }
}

}  // namespace
}  // namespace barrido::raster::reference
