// Points, lines, and polygons drawn as outlines.
#include <gtest/gtest.h>

#include "drawn.h"

namespace barrido::pipeline {
namespace {

const std::vector<float> kSquare{-0.5f, -0.5f, 0, 0.5f, -0.5f, 0, 0.5f, 0.5f, 0, -0.5f, 0.5f, 0};

std::vector<std::array<std::uint32_t, 2>> lines_of(const Drawn& drawn) {
  std::vector<std::array<std::uint32_t, 2>> lines;
  for (const auto& p : drawn.primitives()) lines.push_back({p.vertex[0], p.vertex[1]});
  return lines;
}

TEST(Outline, EdgesOfAQuadAreFour) {
  State state;
  state.polygon_mode = PolygonMode::line;
  using Lines = std::vector<std::array<std::uint32_t, 2>>;
  const Drawn quad(state, geometry_of(kSquare, PrimitiveMode::quads));
  EXPECT_EQ(quad.chunks.at(0).topology, raster::Topology::lines);
  EXPECT_EQ(lines_of(quad), (Lines{{0, 1}, {1, 2}, {2, 3}, {3, 0}}));
  EXPECT_EQ(quad.counts.primitives, 4u);
  EXPECT_EQ(lines_of(Drawn(state, geometry_of(kSquare, PrimitiveMode::polygon))),
            (Lines{{0, 1}, {1, 2}, {2, 3}, {3, 0}}));
  EXPECT_EQ(lines_of(Drawn(state, geometry_of(kSquare, PrimitiveMode::triangle_strip))),
            (Lines{{0, 1}, {1, 2}, {2, 0}, {2, 1}, {1, 3}, {3, 2}}));
}

TEST(Outline, CornersOfAPolygonAsPoints) {
  State state;
  state.polygon_mode = PolygonMode::point;
  const Drawn drawn(state, geometry_of(kSquare, PrimitiveMode::quads));
  EXPECT_EQ(drawn.chunks.at(0).topology, raster::Topology::points);
  EXPECT_EQ(drawn.primitives().size(), 4u);
}

/// x and y of both ends in pixels of the 256 × 128 frame.
std::vector<std::array<double, 4>> ends_of(const Drawn& drawn) {
  std::vector<std::array<double, 4>> ends;
  for (const auto& p : drawn.primitives())
    ends.push_back({p.x[0] / 256.0, p.y[0] / 256.0, p.x[1] / 256.0, p.y[1] / 256.0});
  return ends;
}

TEST(Outline, EdgesThatClippingMakesCloseThePolygon) {
  State state;
  state.polygon_mode = PolygonMode::line;
  state.clip_planes = {{1, 0, 0, 0}};
  using Ends = std::vector<std::array<double, 4>>;
  EXPECT_EQ(ends_of(Drawn(state, geometry_of(kSquare, PrimitiveMode::quads))),
            (Ends{{128, 32, 192, 32}, {192, 32, 192, 96}, {192, 96, 128, 96}, {128, 96, 128, 32}}));
  // Two planes meet inside: each closing edge ends at the other.
  state.clip_planes.emplace_back(0, 1, 0, 0);
  EXPECT_EQ(ends_of(Drawn(state, geometry_of(kSquare, PrimitiveMode::polygon))),
            (Ends{{192, 64, 192, 96}, {192, 96, 128, 96}, {128, 96, 128, 64}, {128, 64, 192, 64}}));
}

TEST(Outline, CornersThatClippingMakesArePoints) {
  State state;
  state.polygon_mode = PolygonMode::point;
  state.clip_planes = {{1, 0, 0, 0}, {0, 1, 0, 0}};
  std::vector<std::array<double, 2>> points;
  for (const auto& p : Drawn(state, geometry_of(kSquare, PrimitiveMode::quads)).primitives())
    points.push_back({p.x[0] / 256.0, p.y[0] / 256.0});
  using Points = std::vector<std::array<double, 2>>;
  EXPECT_EQ(points, (Points{{192, 64}, {192, 96}, {128, 96}, {128, 64}}));
}

TEST(Outline, ClosingEdgesAreInterpolatedBetweenTheCutEdges) {
  State state;
  state.polygon_mode = PolygonMode::line;
  state.clip_planes = {{1, 0, 0, 0}};
  Geometry geometry = geometry_of(kSquare, PrimitiveMode::quads);
  const std::vector<float> colors{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  geometry.color = {colors.data(), 3, 3};
  const Drawn drawn(state, geometry);
  const int color = drawn.plan->fragment.varyings.at(raster::Meaning::color);
  const auto channel = [&](std::uint32_t vertex, int c) {
    const float* record = drawn.chunks[0].record(vertex, drawn.vertices.stride);
    return record[raster::kRecordVaryings + color + c] / record[raster::kRecordQ];
  };
  const raster::PrimitiveRecord edge = drawn.primitives().back();
  EXPECT_EQ(channel(edge.vertex[0], 0), 0.5f);  // between corners 2 and 3
  EXPECT_EQ(channel(edge.vertex[0], 1), 1.0f);
  EXPECT_EQ(channel(edge.vertex[1], 0), 0.5f);  // between corners 0 and 1
  EXPECT_EQ(channel(edge.vertex[1], 1), 0.0f);
}

TEST(Outline, TheSidesOfTheFrameCloseNothing) {
  State state;
  state.polygon_mode = PolygonMode::line;
  const std::vector<float> wide{-3, -0.5f, 0, 3, -0.5f, 0, 3, 0.5f, 0, -3, 0.5f, 0};
  EXPECT_EQ(Drawn(state, geometry_of(wide, PrimitiveMode::quads)).primitives().size(), 2u);
}

TEST(Outline, PolygonsAreCulledAsAWhole) {
  State state;
  state.polygon_mode = PolygonMode::line;
  state.cull_face = CullFace::front;
  const Drawn drawn(state, geometry_of(kSquare, PrimitiveMode::quads));
  EXPECT_TRUE(drawn.primitives().empty());
  EXPECT_EQ(drawn.counts.culled, 4u);
}

TEST(Outline, PolygonsThatReachBehindTheEyeAreCulledByTheirVisiblePart) {
  State state;
  state.polygon_mode = PolygonMode::line;
  state.clip_from_eye[2][3] = -1.0f;  // w = −z
  state.clip_from_eye[3][3] = 0.0f;
  state.clip_from_eye[2][2] = 0.0f;
  // A floor under the eye, counter-clockwise from above.
  const std::vector<float> floor{-1, -1, 5, 1, -1, 5, 1, -1, -5, -1, -1, -5};
  for (const CullFace cull : {CullFace::front, CullFace::back}) {
    state.cull_face = cull;
    const Drawn drawn(state, geometry_of(floor, PrimitiveMode::quads));
    EXPECT_EQ(drawn.primitives().empty(), cull == CullFace::front);
  }
}

TEST(Outline, PointsAreClippedByTheirMiddle) {
  State state;
  state.point_size = 9.0f;
  state.clip_planes = {{0, 1, 0, 0}};
  const std::vector<float> points{0.999f, 0, 0, 1.001f, 0, 0, 0, 0, -1.001f, 0, -0.001f, 0, 0, 0.001f, 0};
  const Drawn drawn(state, geometry_of(points, PrimitiveMode::points));
  ASSERT_EQ(drawn.primitives().size(), 2u);
  EXPECT_EQ(drawn.primitives()[0].vertex[0], 0u);
  EXPECT_EQ(drawn.primitives()[1].vertex[0], 4u);
  EXPECT_EQ(drawn.chunks[0].point_size, 9.0f);
}

TEST(Outline, LinesAreCutAtTheNearPlane) {
  const std::vector<float> line{0, 0, 0, 0.5f, 0.5f, -2};
  const Drawn drawn(State{}, geometry_of(line, PrimitiveMode::lines));
  ASSERT_EQ(drawn.primitives().size(), 1u);
  const raster::PrimitiveRecord p = drawn.primitives()[0];
  EXPECT_EQ(p.vertex[0], 0u);
  EXPECT_EQ(p.vertex[1], drawn.chunks[0].shared_count);
  EXPECT_EQ(p.x[1], static_cast<int>((0.25 * 0.5 + 0.5) * 256 * 256));
  EXPECT_EQ(drawn.chunks[0].record(p.vertex[1], drawn.vertices.stride)[raster::kRecordDepth], 0.0f);
  EXPECT_EQ(drawn.counts.clipped, 1u);
}

}  // namespace
}  // namespace barrido::pipeline
