// Pictures in 256 colours: few colours stay as they are, many are near to what they were.
#include "pipeline/pictures/palette.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace barrido::scene {
namespace {

std::array<std::uint8_t, 3> color_at(const IndexedPicture& picture, std::size_t pixel) {
  const std::size_t at = 3 * std::size_t{picture.indices[pixel]};
  return {picture.palette[at], picture.palette[at + 1], picture.palette[at + 2]};
}

TEST(Palette, FewColoursStayAsTheyAre) {
  std::vector<std::uint8_t> rgba;
  for (int i = 0; i < 1000; ++i) {
    const auto c = static_cast<std::uint8_t>(i % 256);
    rgba.insert(rgba.end(), {c, static_cast<std::uint8_t>(c ^ 0x55), 7, 255});
  }
  const IndexedPicture picture = index_colors(rgba);
  EXPECT_EQ(picture.transparent, -1);
  for (std::size_t i = 0; i < 1000; ++i) {
    EXPECT_EQ(color_at(picture, i), (std::array<std::uint8_t, 3>{rgba[4 * i], rgba[4 * i + 1], 7})) << i;
  }
}

TEST(Palette, WhatLetsMostThroughIsTransparent) {
  std::vector<std::uint8_t> rgba;
  for (int i = 0; i < 512; ++i) {
    rgba.insert(rgba.end(), {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i / 2), 0,
                             static_cast<std::uint8_t>(i < 256 ? 127 : 128)});
  }
  const IndexedPicture picture = index_colors(rgba);
  ASSERT_GE(picture.transparent, 0);
  for (std::size_t i = 0; i < 512; ++i) EXPECT_EQ(picture.indices[i] == picture.transparent, i < 256) << i;
}

/// A ramp in two dimensions has 65536 colours: 256 boxes of equal worth are 16 × 16 each, and nothing is
/// farther from its mean than half of that, but for where the first bins are cut.
TEST(Palette, ManyColoursAreNear) {
  std::vector<std::uint8_t> rgba;
  for (int y = 0; y < 256; ++y) {
    for (int x = 0; x < 256; ++x) {
      rgba.insert(rgba.end(), {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 128, 255});
    }
  }
  const IndexedPicture picture = index_colors(rgba);
  int worst = 0;
  for (std::size_t i = 0; i < picture.indices.size(); ++i) {
    const auto color = color_at(picture, i);
    for (std::size_t c = 0; c < 3; ++c) worst = std::max(worst, std::abs(color[c] - rgba[4 * i + c]));
  }
  EXPECT_LE(worst, 12);
  EXPECT_GE(worst, 7);
}

TEST(Palette, ARareColourFarFromAllOthersIsKept) {
  std::mt19937 bits(3);
  std::vector<std::uint8_t> rgba;
  for (int i = 0; i < 20000; ++i) {
    const auto c = [&] { return static_cast<std::uint8_t>(bits() % 128); };
    rgba.insert(rgba.end(), {c(), c(), c(), 255});
  }
  for (int i = 0; i < 200; ++i) rgba.insert(rgba.end(), {255, 0, 0, 255});
  const auto color = color_at(index_colors(rgba), 20100);
  EXPECT_GT(color[0], 230);
  EXPECT_LT(color[1], 25);
}

}  // namespace
}  // namespace barrido::scene
