#include "models/tool/teapot.h"

#include <array>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "tests/models/mesh_checks.h"

namespace barrido::models {
namespace {

using Point = std::array<double, 3>;

Point point_of(const Vec3& v) { return {v.x, v.y, v.z}; }

TEST(Teapot, FiguresAreDistinctAndUsed) {
  const std::set<Point> distinct(kTeapotControlPoints.begin(), kTeapotControlPoints.end());
  EXPECT_EQ(distinct.size(), kTeapotControlPoints.size());
  std::set<int> used;
  for (const PatchIndices& patch : kTeapotPatches) used.insert(patch.begin(), patch.end());
  EXPECT_EQ(used.size(), kTeapotControlPoints.size());
}

TEST(Teapot, WindingNormalsAndTexture) {
  for (const int cells : {1, 4, 10}) {
    SCOPED_TRACE(cells);
    const Mesh teapot = make_teapot(cells);
    if (cells == 10) expect_sound(teapot);  // coarser facets turn away from their vertices' normals
    const auto side = static_cast<std::size_t>(cells) + 1;
    EXPECT_EQ(teapot.positions.size(), kTeapotPatchCount * side * side);
    // Eight patches end in a pole, where a row of triangles has no area.
    const auto n = static_cast<std::size_t>(cells);
    EXPECT_EQ(teapot.indices.size() / 3, 2 * kTeapotPatchCount * n * n - 8 * n);
  }
}

TEST(Teapot, StandsUpright) {
  const Mesh teapot = make_teapot(10);
  double lowest = 1e9, highest = -1e9, most_x = -1e9, least_x = 1e9;
  for (const Vec3& p : teapot.positions) {
    lowest = std::min(lowest, p.y);
    highest = std::max(highest, p.y);
    most_x = std::max(most_x, p.x);
    least_x = std::min(least_x, p.x);
  }
  EXPECT_NEAR(lowest, 0.0, 1e-6);
  EXPECT_NEAR(highest, 3.15, 1e-6);  // the knob's top, as published
  EXPECT_GT(most_x, 3.3);            // the spout reaches farther than the handle
  EXPECT_GT(least_x, -3.1);
}

TEST(Teapot, PolesHaveUprightNormals) {
  const Mesh teapot = make_teapot(10);
  int top = 0;
  int bottom = 0;
  for (std::size_t i = 0; i < teapot.positions.size(); ++i) {
    const Vec3& p = teapot.positions[i];
    if (p.x != 0.0 || p.z != 0.0) continue;
    if (p.y > 3.0) {
      ++top;
      EXPECT_NEAR(teapot.normals[i].y, 1.0, 1e-12);
    } else if (p.y < 0.1) {
      ++bottom;
      EXPECT_NEAR(teapot.normals[i].y, -1.0, 1e-12);
    }
  }
  EXPECT_EQ(top, 4 * 11);
  EXPECT_EQ(bottom, 4 * 11);
}

TEST(Teapot, BodyNormalsPointAwayFromTheAxis) {
  const Mesh teapot = make_teapot(10);
  constexpr std::size_t kPatchVertices = 11 * 11;
  for (std::size_t i = 4 * kPatchVertices; i < 12 * kPatchVertices; ++i) {
    const Vec3& p = teapot.positions[i];
    const Vec3& n = teapot.normals[i];
    EXPECT_GT(p.x * n.x + p.z * n.z, 0.0);
  }
}

TEST(Teapot, PatchesShareTheirEdgesExactly) {
  constexpr int kCells = 10;
  const Mesh teapot = make_teapot(kCells);
  std::map<std::pair<Point, Point>, int> directed;
  for (const Triangle& t : triangles_of(teapot)) {
    const std::array<Point, 3> p{point_of(teapot.positions[t.a]), point_of(teapot.positions[t.b]),
                                 point_of(teapot.positions[t.c])};
    for (std::size_t i = 0; i < 3; ++i) ++directed[{p[i], p[(i + 1) % 3]}];
  }
  int open = 0;
  for (const auto& [edge, count] : directed) {
    EXPECT_EQ(count, 1);
    if (!directed.contains({edge.second, edge.first})) ++open;
  }
  // Newell's surfaces are open at the rim's inner edge and the lid's edge (four patches each), and at both
  // ends of handle and spout (two patches each).
  EXPECT_EQ(open, (4 + 4 + 2 + 2 + 2 + 2) * kCells);
}

}  // namespace
}  // namespace barrido::models
