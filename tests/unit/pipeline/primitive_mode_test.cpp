// The tables of OpenGL's primitive modes, written out by hand.
#include "pipeline/primitive_mode.h"

#include <vector>

#include <gtest/gtest.h>

namespace barrido::pipeline {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

std::vector<Triangle> triangles(PrimitiveMode mode, std::uint32_t elements) {
  std::vector<Triangle> all;
  for (std::uint32_t t = 0; t < triangle_count(mode, elements); ++t)
    all.push_back(triangle_elements(mode, t));
  return all;
}

std::vector<std::uint32_t> provoking(PrimitiveMode mode, std::uint32_t elements) {
  std::vector<std::uint32_t> all;
  for (std::uint32_t p = 0; p < polygon_count(mode, elements); ++p) all.push_back(provoking_element(mode, p));
  return all;
}

// OpenGL 1.3, figures 2.2 to 2.5.
TEST(PrimitiveMode, TrianglesOfEachMode) {
  EXPECT_EQ(triangles(PrimitiveMode::triangles, 7), (std::vector<Triangle>{{0, 1, 2}, {3, 4, 5}}));
  EXPECT_EQ(triangles(PrimitiveMode::triangle_strip, 6),
            (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}}));
  EXPECT_EQ(triangles(PrimitiveMode::triangle_fan, 5),
            (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
  EXPECT_EQ(triangles(PrimitiveMode::quads, 9),
            (std::vector<Triangle>{{0, 1, 3}, {1, 2, 3}, {4, 5, 7}, {5, 6, 7}}));
  EXPECT_EQ(triangles(PrimitiveMode::quad_strip, 7),
            (std::vector<Triangle>{{2, 0, 3}, {0, 1, 3}, {4, 2, 5}, {2, 3, 5}}));
  EXPECT_EQ(triangles(PrimitiveMode::polygon, 5), (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

// OpenGL 1.3, table 2.12 (which counts from 1).
TEST(PrimitiveMode, ProvokingVertexOfEachMode) {
  EXPECT_EQ(provoking(PrimitiveMode::triangles, 6), (std::vector<std::uint32_t>{2, 5}));
  EXPECT_EQ(provoking(PrimitiveMode::triangle_strip, 6), (std::vector<std::uint32_t>{2, 3, 4, 5}));
  EXPECT_EQ(provoking(PrimitiveMode::triangle_fan, 5), (std::vector<std::uint32_t>{2, 3, 4}));
  EXPECT_EQ(provoking(PrimitiveMode::quads, 8), (std::vector<std::uint32_t>{3, 7}));
  EXPECT_EQ(provoking(PrimitiveMode::quad_strip, 8), (std::vector<std::uint32_t>{3, 5, 7}));
  EXPECT_EQ(provoking(PrimitiveMode::polygon, 5), (std::vector<std::uint32_t>{0}));
}

TEST(PrimitiveMode, LinesOfEachMode) {
  const auto lines = [](PrimitiveMode mode, std::uint32_t elements) {
    std::vector<std::array<std::uint32_t, 2>> all;
    for (std::uint32_t i = 0; i < line_count(mode, elements); ++i) {
      all.push_back(line_elements(mode, i, elements));
    }
    return all;
  };
  using Lines = std::vector<std::array<std::uint32_t, 2>>;
  EXPECT_EQ(lines(PrimitiveMode::lines, 5), (Lines{{0, 1}, {2, 3}}));
  EXPECT_EQ(lines(PrimitiveMode::line_strip, 4), (Lines{{0, 1}, {1, 2}, {2, 3}}));
  EXPECT_EQ(lines(PrimitiveMode::line_loop, 4), (Lines{{0, 1}, {1, 2}, {2, 3}, {3, 0}}));
}

TEST(PrimitiveMode, TooFewElementsMakeNothing) {
  for (std::uint32_t elements = 0; elements < 3; ++elements) {
    for (int mode = static_cast<int>(PrimitiveMode::triangles);
         mode <= static_cast<int>(PrimitiveMode::polygon); ++mode) {
      EXPECT_EQ(triangle_count(static_cast<PrimitiveMode>(mode), elements), 0u) << mode << ' ' << elements;
    }
  }
  EXPECT_EQ(triangle_count(PrimitiveMode::quads, 3), 0u);
  EXPECT_EQ(triangle_count(PrimitiveMode::quad_strip, 3), 0u);
  EXPECT_EQ(line_count(PrimitiveMode::line_loop, 1), 0u);
}

TEST(PrimitiveMode, TrianglesOfAPolygonTurnTheSameWay) {
  // Corners of a square in polygon order; every triangle of it must turn as the square does.
  constexpr int kX[] = {0, 1, 1, 0}, kY[] = {0, 0, 1, 1};
  for (const PrimitiveMode mode : {PrimitiveMode::quads, PrimitiveMode::quad_strip, PrimitiveMode::polygon}) {
    int area = 0;
    for (const Triangle& t : triangles(mode, 4)) {
      std::array<int, 3> corner{};
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::uint32_t c = 0; c < 4; ++c) {
          if (polygon_corner(mode, 0, c) == t[k]) corner[k] = static_cast<int>(c);
        }
      }
      const int doubled = (kX[corner[1]] - kX[corner[0]]) * (kY[corner[2]] - kY[corner[0]]) -
                          (kX[corner[2]] - kX[corner[0]]) * (kY[corner[1]] - kY[corner[0]]);
      EXPECT_EQ(doubled, 1) << static_cast<int>(mode);
      area += doubled;
    }
    EXPECT_EQ(area, 2);
  }
}

}  // namespace
}  // namespace barrido::pipeline
