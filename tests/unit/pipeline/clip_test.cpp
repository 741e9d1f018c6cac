// Clipping in homogeneous coordinates; above all that both sides of a shared edge get the same points.
#include "pipeline/clip.h"

#include <gtest/gtest.h>

#include "pipeline/bounded.h"
#include "random.h"

namespace barrido::pipeline {
namespace {

VertexTransform identity_transform() {
  VertexTransform t;
  t.window_scale = {128, 64, 0.5f};
  t.window_offset = {128, 64, 0.5f};
  return t;
}

ClipPolygon polygon_of(const VertexTransform& t, const std::array<glm::vec4, 3>& corners) {
  ClipPolygon polygon;
  polygon.count = 3;
  for (std::size_t i = 0; i < 3; ++i) polygon.vertices[i] = clip_vertex(t, corners[i], static_cast<int>(i));
  return polygon;
}

bool operator==(const ClipVertex& a, const ClipVertex& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w;
}

TEST(Clip, WhatIsInsideStaysAsItIs) {
  const VertexTransform t = identity_transform();
  ClipPolygon p = polygon_of(t, {{{0, 0, 0, 1}, {30, 0, 0, 1}, {0, -20, 0.5f, 1}}});  // inside the guard band
  clip_polygon(t, p);
  ASSERT_EQ(p.count, 3);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(p.vertices[static_cast<std::size_t>(i)].corner, i);
}

TEST(Clip, WhatIsOutsideVanishes) {
  const VertexTransform t = identity_transform();
  ClipPolygon p = polygon_of(t, {{{0, 0, 2, 1}, {1, 0, 3, 1}, {0, 1, 4, 1}}});
  clip_polygon(t, p);
  EXPECT_EQ(p.count, 0);
  p = polygon_of(t, {{{0, 0, 0, -1}, {1, 0, 0, -1}, {0, 1, 0, -2}}});
  clip_polygon(t, p);
  EXPECT_EQ(p.count, 0);
}

TEST(Clip, CutsAtTheNearPlane) {
  const VertexTransform t = identity_transform();
  ClipPolygon p = polygon_of(t, {{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, -3, 1}}});
  clip_polygon(t, p);
  ASSERT_EQ(p.count, 4);
  const ClipVertex& cut = p.vertices[2];
  EXPECT_EQ(cut.corner, -1);
  EXPECT_DOUBLE_EQ(cut.z, -cut.w);
  EXPECT_DOUBLE_EQ(cut.weight[1], 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(cut.weight[2], 1.0 / 3.0);
  EXPECT_EQ(cut.weight[0], 0.0);
}

TEST(Clip, DepthClampLeavesNearAndFarAlone) {
  VertexTransform t = identity_transform();
  t.depth_clamp = true;
  ClipPolygon p = polygon_of(t, {{{0, 0, -9, 1}, {1, 0, 9, 1}, {0, 1, 0, 1}}});
  clip_polygon(t, p);
  EXPECT_EQ(p.count, 3);
  p = polygon_of(t, {{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, -1}}});
  clip_polygon(t, p);
  EXPECT_GE(p.count, 3);
  for (int i = 0; i < p.count; ++i) EXPECT_GT(p.vertices[static_cast<std::size_t>(i)].w, 0.0);
}

TEST(Clip, UserPlanesKeepTheirPositiveSide) {
  VertexTransform t = identity_transform();
  t.plane_count = 2;
  t.planes[0] = {1, 0, 0, -0.25f};  // x ≥ ¼
  t.planes[1] = {0, -1, 0, 0.5f};   // y ≤ ½
  ClipPolygon p = polygon_of(t, {{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}}});
  clip_polygon(t, p);
  ASSERT_GE(p.count, 3);
  for (int i = 0; i < p.count; ++i) {
    const ClipVertex& v = p.vertices[static_cast<std::size_t>(i)];
    EXPECT_GE(v.x, 0.25 - 1e-12);
    EXPECT_LE(v.y, 0.5 + 1e-12);
  }
}

glm::vec4 random_corner(Random& random) {
  glm::vec4 p = random.vec4(-2, 2);
  if (random.chance(0.3)) p *= random.in(1, 1000);  // beyond the guard band
  if (random.chance(0.3)) p.w = -p.w;
  return p;
}

/// The points of the clipped polygon that lie on the edge between two corners.
std::vector<ClipVertex> points_on_edge(const ClipPolygon& p, int a, int b) {
  const auto other = static_cast<std::size_t>(3 - a - b);
  std::vector<ClipVertex> points;
  for (int i = 0; i < p.count; ++i) {
    const ClipVertex& v = p.vertices[static_cast<std::size_t>(i)];
    if (v.weight[other] == 0.0) points.push_back(v);
  }
  return points;
}

// Two triangles share an edge, run through in either direction and with any third corner: every point of the
// first on that edge must be a point of the second, to the last bit.
TEST(Clip, SharedEdgesGetTheSamePointsFromBothSides) {
  VertexTransform t = identity_transform();
  t.plane_count = 2;
  t.planes[0] = {0.3f, -0.8f, 0.2f, 0.4f};
  t.planes[1] = {-0.5f, 0.1f, 0.9f, 0.6f};
  Random random(7);
  int shared_cuts = 0;
  for (int n = 0; n < 100000; ++n) {
    const glm::vec4 a = random_corner(random), b = random_corner(random);
    ClipPolygon left = polygon_of(t, {a, b, random_corner(random)});
    ClipPolygon right = polygon_of(t, {random_corner(random), b, a});
    clip_polygon(t, left);
    clip_polygon(t, right);
    const auto on_left = points_on_edge(left, 0, 1);
    const auto on_right = points_on_edge(right, 1, 2);
    ASSERT_EQ(on_left.size(), on_right.size()) << "pair " << n;
    for (const ClipVertex& v : on_left) {
      bool found = false;
      for (const ClipVertex& w : on_right) found = found || v == w;
      ASSERT_TRUE(found) << "pair " << n;
      shared_cuts += v.corner < 0;
    }
  }
  EXPECT_GT(shared_cuts, 10000);
}

TEST(Clip, EveryCornerThatIsLeftHasAPlaceInTheGuardBand) {
  VertexTransform t = identity_transform();
  Random random(8);
  for (int n = 0; n < 20000; ++n) {
    t.depth_clamp = n % 2 == 1;
    ClipPolygon p = polygon_of(t, {random_corner(random), random_corner(random), random_corner(random)});
    clip_polygon(t, p);
    for (int i = 0; i < p.count; ++i) {
      const ClipVertex& v = p.vertices[static_cast<std::size_t>(i)];
      ASSERT_GE(v.w, static_cast<double>(kMinW));
      ASSERT_LE(std::abs(v.x / v.w * 128 + 128), kGuardLimitPixels + 2);
      ASSERT_LE(std::abs(v.y / v.w * 64 + 64), kGuardLimitPixels + 2);
      ASSERT_NEAR(v.weight[0] + v.weight[1] + v.weight[2], 1.0, 1e-9);
    }
  }
}

TEST(Clip, LinesAreCutAtBothEnds) {
  const VertexTransform t = identity_transform();
  ClipVertex a = clip_vertex(t, {0, 0, -3, 1}, 0);
  ClipVertex b = clip_vertex(t, {0, 0, 5, 1}, 1);
  ASSERT_TRUE(clip_line(t, a, b));
  EXPECT_DOUBLE_EQ(a.z, -1.0);
  EXPECT_DOUBLE_EQ(b.z, 1.0);
  EXPECT_NEAR(a.weight[1], 0.25, 1e-12);
  a = clip_vertex(t, {0, 0, -3, 1}, 0);
  b = clip_vertex(t, {0, 0, -2, 1}, 1);
  EXPECT_FALSE(clip_line(t, a, b));
}

}  // namespace
}  // namespace barrido::pipeline
