#include "pipeline/scene/reflection_maps.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/scene/cube_directions.h"
#include "pipeline/scene/studio.h"

namespace barrido::scene {
namespace {

/// White above the horizon, black below.
raster::Texture sky(raster::Encoding encoding) {
  constexpr int kSize = 32;
  std::array<std::vector<std::uint8_t>, 6> bytes;
  std::array<raster::Pixels8, 6> faces;
  for (int face = 0; face < 6; ++face) {
    std::vector<std::uint8_t>& rgba = bytes[static_cast<std::size_t>(face)];
    for (int j = 0; j < kSize; ++j) {
      for (int i = 0; i < kSize; ++i) {
        const bool up = cube_direction(face, texel_middle(i, kSize), texel_middle(j, kSize)).y > 0;
        const std::uint8_t c = up ? 255 : 0;
        rgba.insert(rgba.end(), {c, c, c, 255});
      }
    }
    faces[static_cast<std::size_t>(face)] = {kSize, kSize, rgba};
  }
  raster::TextureOptions options;
  options.encoding = encoding;
  return raster::Texture::make_cube(faces, options);
}

TEST(ReflectionMaps, ACosineLobeOverHalfASphereIsKnown) {
  // ∫ max(0, d·x) over the upper half, by all of it: (1 + cosθ)/2 for a d at the angle θ from upright.
  for (const raster::Encoding encoding : {raster::Encoding::srgb, raster::Encoding::linear}) {
    const raster::Texture blurred = blurred_cube(sky(encoding), 0, 8);
    for (int face = 0; face < 6; ++face) {
      for (int j = 0; j < 8; ++j) {
        for (int i = 0; i < 8; ++i) {
          const glm::dvec3 d = cube_direction(face, texel_middle(i, 8), texel_middle(j, 8));
          const double wanted = (1 + d.y / std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z)) / 2;
          // The horizon lies within the coarse map's texels; a byte of sRGB is up to 0.009 wide.
          EXPECT_NEAR(blurred.texel(0, face, i, j)[0], wanted, 0.02) << face << ' ' << i << ' ' << j;
        }
      }
    }
  }
}

TEST(ReflectionMaps, TheSmootherTheSurfaceTheSharperTheHorizon) {
  const raster::Texture map = sky(raster::Encoding::linear);
  ReflectionMaps maps;
  float last = 0.0f;
  for (const float exponent : {0.5f, 4.0f, 30.0f, 100.0f}) {
    const raster::Texture& blurred = maps.get(map, exponent);
    const int rows = blurred.height();
    // On +Z, t runs down: the contrast across the horizon within a quarter of the face.
    const float above = blurred.texel(0, 4, rows / 2, rows / 2 - rows / 8)[0];
    const float below = blurred.texel(0, 4, rows / 2, rows / 2 + rows / 8 - 1)[0];
    EXPECT_GT(above - below, last) << exponent;
    last = above - below;
  }
  EXPECT_EQ(&maps.get(map, 5000.0f), &map);
  EXPECT_EQ(&maps.get(map, 4.0f), &maps.get(map, 4.1f)) << "made once";
}

TEST(Studio, LooksAlikeInBothEncodings) {
  const raster::Texture linear = make_studio(raster::Encoding::linear);
  const raster::Texture srgb = make_studio(raster::Encoding::srgb);
  EXPECT_EQ(linear.level_rgba8(0, 4).size(), srgb.level_rgba8(0, 4).size());
  // The same bytes, understood as screen values or as codes of light.
  EXPECT_GT(linear.texel(0, 2, 32, 32)[0], srgb.texel(0, 2, 32, 32)[0]);
  EXPECT_GT(srgb.texel(0, 2, 32, 32)[0], srgb.texel(0, 3, 32, 32)[0])
      << "the ceiling is brighter than the floor";
}

}  // namespace
}  // namespace barrido::scene
