// The texture unit of the reference: choice of filter and level by literal tables, wrap modes by hand,
// bilinear filtering against double precision, cube faces, and coordinates that are no numbers.
#include "raster/reference/sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "random_texels.h"
#include "raster/reference/fragment_operations.h"

namespace barrido::raster::reference {
namespace {

using raster::testing::random_rgba;

/// 8 × 8 with four levels of one colour each: level k is 40·k in all channels.
Texture staircase() {
  std::array<std::vector<std::uint8_t>, 4> rgba;
  std::array<Pixels8, 4> levels;
  for (std::size_t k = 0; k < 4; ++k) {
    const int side = 8 >> k;
    rgba[k].assign(static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * 4,
                   static_cast<std::uint8_t>(40 * k));
    levels[k] = {side, side, rgba[k]};
  }
  return Texture::make_2d_levels(levels, {});
}

/// The level, as a number with 1/256 steps, that a unit samples of the staircase at λ.
double sampled_level(const TextureUnit& unit, float lod) {
  const Color color = sample_texture(unit, TexcoordKind::plain, {0.3f, 0.6f, 0.0f}, lod);
  return static_cast<double>(color[0]) * 255.0 / 40.0;
}

TEST(Sampling, LevelsByFilterAndLod) {
  const Texture texture = staircase();
  const struct {
    MinFilter filter;
    float lod;
    double level;
  } table[] = {
      {MinFilter::nearest, 2.7f, 0},
      {MinFilter::linear, 2.7f, 0},
      {MinFilter::nearest_mipmap_nearest, 0.50f, 0},
      {MinFilter::nearest_mipmap_nearest, 0.51f, 1},
      {MinFilter::nearest_mipmap_nearest, 1.50f, 1},
      {MinFilter::nearest_mipmap_nearest, 1.51f, 2},
      {MinFilter::nearest_mipmap_nearest, 99.0f, 3},
      {MinFilter::linear_mipmap_nearest, -3.0f, 0},
      {MinFilter::linear_mipmap_nearest, 0.25f, 0},
      {MinFilter::linear_mipmap_nearest, 0.75f, 1},
      {MinFilter::nearest_mipmap_linear, 0.5f, 0},  // magnified: the limit is ½
      {MinFilter::nearest_mipmap_linear, 0.75f, 0.75},
      {MinFilter::linear_mipmap_linear, 0.5f, 0.5},
      {MinFilter::linear_mipmap_linear, 1.0f, 1.0},
      {MinFilter::linear_mipmap_linear, 2.25f, 2.25},
      {MinFilter::linear_mipmap_linear, 3.0f, 3.0},
      {MinFilter::linear_mipmap_linear, 50.0f, 3.0},
      {MinFilter::linear_mipmap_linear, std::numeric_limits<float>::infinity(), 3.0},
  };
  for (const auto& row : table) {
    TextureUnit unit;
    unit.texture = &texture;
    unit.min_filter = row.filter;
    EXPECT_NEAR(sampled_level(unit, row.lod), row.level, 1e-3)
        << static_cast<int>(row.filter) << " " << row.lod;
    unit.lod_bias = -1.25f;
    EXPECT_NEAR(sampled_level(unit, row.lod + 1.25f), row.level, 1e-3) << "biased";
  }
}

TEST(Sampling, TheMagnificationLimitNeedsALinearMagnificationFilter) {
  const Texture texture = staircase();
  TextureUnit unit;
  unit.texture = &texture;
  unit.min_filter = MinFilter::nearest_mipmap_linear;
  unit.mag_filter = MagFilter::nearest;
  EXPECT_NEAR(sampled_level(unit, 0.5f), 0.5, 1e-3);
  EXPECT_NEAR(sampled_level(unit, 0.0f), 0.0, 1e-3);
}

TEST(Sampling, OneColourComesOutUnchanged) {
  for (const Encoding encoding : {Encoding::linear, Encoding::srgb}) {
    for (int byte = 0; byte < 256; ++byte) {
      const std::vector<std::uint8_t> rgba(16 * 16 * 4, static_cast<std::uint8_t>(byte));
      TextureOptions options;
      options.encoding = encoding;
      const Texture texture = Texture::make_2d({16, 16, rgba}, options);
      TextureUnit unit;
      unit.texture = &texture;
      unit.min_filter = MinFilter::linear_mipmap_linear;
      const Color exact = sample_texture(unit, TexcoordKind::plain, {0.03125f, 0.03125f, 0}, -1.0f);
      EXPECT_NEAR(exact[0], texture.texel(0, 0, 0, 0)[0], 1e-7);
      for (int k = 0; k < 20; ++k) {
        const float t = static_cast<float>(k) * 0.37f;
        EXPECT_EQ(sample_texture(unit, TexcoordKind::plain, {t, 1.0f - t, 0}, t), exact) << byte << " " << t;
      }
    }
  }
}

TEST(Sampling, WrapModesWithNearest) {
  // Texels 0, 50, 100, 150 in a row; the border is 255.
  const std::uint8_t row[16] = {0, 0, 0, 0, 50, 0, 0, 0, 100, 0, 0, 0, 150, 0, 0, 0};
  const struct {
    Wrap wrap;
    float u;
    int expected;
  } table[] = {
      {Wrap::repeat, 0.1f, 0},
      {Wrap::repeat, 1.3f, 50},
      {Wrap::repeat, -0.1f, 150},
      {Wrap::repeat, -3.9f, 0},
      {Wrap::mirrored_repeat, 1.1f, 150},
      {Wrap::mirrored_repeat, -0.3f, 50},
      {Wrap::mirrored_repeat, 2.3f, 50},
      {Wrap::mirrored_repeat, 1.0f, 150},
      {Wrap::clamp_to_edge, -5.0f, 0},
      {Wrap::clamp_to_edge, 5.0f, 150},
      {Wrap::clamp, -5.0f, 0},
      {Wrap::clamp, 1.0f, 150},
      {Wrap::clamp_to_border, -0.01f, 255},
      {Wrap::clamp_to_border, 1.0f, 255},
      {Wrap::clamp_to_border, 0.99f, 150},
      {Wrap::clamp_to_border, -7.0f, 255},
  };
  for (const auto& entry : table) {
    TextureOptions options;
    options.wrap_s = entry.wrap;
    options.border_color = {1, 1, 1, 1};
    const Texture texture = Texture::make_2d({4, 1, row}, options);
    TextureUnit unit;
    unit.texture = &texture;
    unit.mag_filter = MagFilter::nearest;
    const Color color = sample_texture(unit, TexcoordKind::plain, {entry.u, 0.5f, 0}, -1.0f);
    EXPECT_NEAR(color[0] * 255.0f, entry.expected, 1e-3) << static_cast<int>(entry.wrap) << " " << entry.u;
  }
}

/// The texel at any place, wrapped in plain integers.
double wrapped_texel(const Texture& texture, int i, int j, std::size_t c) {
  const int w = texture.width();
  const int h = texture.height();
  return texture.texel(0, 0, ((i % w) + w) % w, ((j % h) + h) % h)[c];
}

TEST(Sampling, BilinearAgreesWithDoublePrecision) {
  std::mt19937_64 bits(6);
  for (const Encoding encoding : {Encoding::linear, Encoding::srgb}) {
    const auto rgba = random_rgba(13, 7, 77);
    TextureOptions options;
    options.encoding = encoding;
    const Texture texture = Texture::make_2d({13, 7, rgba}, options);
    TextureUnit unit;
    unit.texture = &texture;
    for (int k = 0; k < 20000; ++k) {
      const float u = static_cast<float>(bits() % 4096) / 1024.0f - 2.0f;
      const float v = static_cast<float>(bits() % 4096) / 1024.0f - 2.0f;
      const Color color = sample_texture(unit, TexcoordKind::plain, {u, v, 0}, -1.0f);
      const double x = u * 13.0 - 0.5;
      const double y = v * 7.0 - 0.5;
      const int i = static_cast<int>(std::floor(x));
      const int j = static_cast<int>(std::floor(y));
      for (std::size_t c = 0; c < 4; ++c) {
        const double lower =
            wrapped_texel(texture, i, j, c) * (1 - (x - i)) + wrapped_texel(texture, i + 1, j, c) * (x - i);
        const double upper = wrapped_texel(texture, i, j + 1, c) * (1 - (x - i)) +
                             wrapped_texel(texture, i + 1, j + 1, c) * (x - i);
        // Weights have 8 bits: 1/256 of the largest difference in each direction.
        ASSERT_NEAR(color[c], lower * (1 - (y - j)) + upper * (y - j), 2.1 / 256) << u << " " << v;
      }
    }
  }
}

TEST(Sampling, ProjectiveDivides) {
  const auto rgba = random_rgba(8, 8, 5);
  const Texture texture = Texture::make_2d({8, 8, rgba}, {});
  TextureUnit unit;
  unit.texture = &texture;
  EXPECT_EQ(sample_texture(unit, TexcoordKind::projective, {1.0f, 3.0f, 4.0f}, -1.0f),
            sample_texture(unit, TexcoordKind::plain, {0.25f, 0.75f, 0.0f}, -1.0f));
}

Texture numbered_cube() {
  std::array<std::vector<std::uint8_t>, kCubeFaces> rgba;
  std::array<Pixels8, kCubeFaces> faces;
  for (std::size_t f = 0; f < kCubeFaces; ++f) {
    rgba[f].assign(4 * 4 * 4, static_cast<std::uint8_t>(40 * f));
    // The texel at the lowest s and t of each face is marked in green.
    rgba[f][1] = 255;
    faces[f] = {4, 4, rgba[f]};
  }
  return Texture::make_cube(faces, {});
}

TEST(Sampling, CubeFacesByMajorAxis) {
  const Texture cube = numbered_cube();
  TextureUnit unit;
  unit.texture = &cube;
  unit.mag_filter = MagFilter::nearest;
  const struct {
    float direction[3];
    int face;
    bool marked;  ///< The direction of the face's texel (0, 0): table 3.19 of OpenGL 1.3.
  } table[] = {
      {{1, 0, 0}, 0, false},        {{-1, 0, 0}, 1, false},       {{0, 1, 0}, 2, false},
      {{0, -1, 0}, 3, false},       {{0, 0, 1}, 4, false},        {{0, 0, -1}, 5, false},
      {{1, 0.9f, 0.9f}, 0, true},   {{-1, 0.9f, -0.9f}, 1, true}, {{-0.9f, 1, -0.9f}, 2, true},
      {{-0.9f, -1, 0.9f}, 3, true}, {{-0.9f, 0.9f, 1}, 4, true},  {{0.9f, 0.9f, -1}, 5, true},
      {{2, 2, 2}, 0, true},         {{-2, 2, 2}, 1, false},       {{0.5f, 2, 2}, 2, false},
      {{0, 0, 0}, 0, false},        {{-0.0f, 0, 0}, 0, false},
  };
  for (const auto& row : table) {
    const Color color = sample_texture(unit, TexcoordKind::direct, row.direction, -1.0f);
    EXPECT_NEAR(color[0] * 255.0f, 40 * row.face, 1e-3);
    EXPECT_EQ(color[1] > 0.99f, row.marked)
        << row.direction[0] << " " << row.direction[1] << " " << row.direction[2];
  }
}

TEST(Sampling, CoordinatesThatAreNoNumbersCountAsZero) {
  const auto rgba = random_rgba(8, 8, 5);
  const Texture texture = Texture::make_2d({8, 8, rgba}, {});
  const Texture cube = numbered_cube();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (const MinFilter filter : {MinFilter::nearest, MinFilter::linear_mipmap_linear}) {
    TextureUnit unit;
    unit.texture = &texture;
    unit.min_filter = filter;
    const Color zero = sample_texture(unit, TexcoordKind::plain, {0, 0, 0}, 1.0f);
    for (const float bad : {nan, infinity, -infinity, 4194304.0f, -1e38f}) {
      EXPECT_EQ(sample_texture(unit, TexcoordKind::plain, {bad, bad, 0}, 1.0f), zero);
    }
    EXPECT_EQ(sample_texture(unit, TexcoordKind::projective, {1, 1, 0}, 1.0f), zero);
    unit.texture = &cube;
    sample_texture(unit, TexcoordKind::direct, {nan, infinity, 0}, 1.0f);
    sample_texture(unit, TexcoordKind::direct, {infinity, infinity, infinity}, nan);
  }
}

}  // namespace
}  // namespace barrido::raster::reference
