// Planes through vertex records: exact at the vertices of simple triangles, polygon offset, lines and points.
#include "raster/reference/planes.h"

#include <gtest/gtest.h>

namespace barrido::raster::reference {
namespace {

/// A chunk with one varying whose vertices carry (depth, q, varying) = `values`.
struct Fixture {
  FragmentState state;
  PrimitiveChunk chunk;

  Fixture(Topology topology, const std::vector<std::array<float, 3>>& values) {
    state.varyings.add({Meaning::fog, 1});
    chunk.state = &state;
    chunk.topology = topology;
    const auto stride = static_cast<std::size_t>(record_stride(1));
    chunk.own_records.resize(values.size() * stride);
    for (std::size_t v = 0; v < values.size(); ++v) {
      for (std::size_t k = 0; k < 3; ++k) chunk.own_records[v * stride + k] = values[v][k];
    }
  }
};

PrimitiveRecord at(std::initializer_list<std::array<int, 2>> pixels) {
  PrimitiveRecord record{};
  std::uint32_t k = 0;
  for (const auto& [x, y] : pixels) {
    record.x[k] = x * kSubpixelUnits;
    record.y[k] = y * kSubpixelUnits;
    record.vertex[k] = k;
    ++k;
  }
  return record;
}

TEST(Planes, TriangleHasTheSlopesOfItsVertices) {
  const Fixture f(Topology::triangles, {{0.25f, 1, 8}, {0.75f, 1, 8}, {0.25f, 0.5f, 24}});
  const PlaneSet set = make_planes(f.chunk, at({{0, 0}, {16, 0}, {0, 8}}));
  ASSERT_EQ(set.planes.size(), 3u);
  EXPECT_EQ(set.planes[0].ddx, 0.03125);
  EXPECT_EQ(set.planes[0].ddy, 0.0);
  EXPECT_EQ(set.planes[1].ddy, -0.0625);
  EXPECT_EQ(set.planes[2].ddy, 2.0);

  const SpanQuantities along = quantities_along(set, {3, 2, 6});
  EXPECT_EQ(along.anchor, 2);
  EXPECT_EQ(along.last, 5);
  EXPECT_EQ(along.quantities[0].at(0), 0.25f + 2.5f * 0.03125f);
  EXPECT_EQ(along.quantities[0].at(3), 0.25f + 5.5f * 0.03125f);
  EXPECT_EQ(along.quantities[2].at(1), 8.0f + 3.5f * 2.0f);
}

TEST(Planes, PolygonOffsetTakesTheSteepestSlope) {
  Fixture f(Topology::triangles, {{0.25f, 1, 0}, {0.75f, 1, 0}, {-0.75f, 1, 0}});
  const PrimitiveRecord triangle = at({{0, 0}, {16, 0}, {0, 8}});
  f.state.polygon_offset = {true, 2.0f, 4.0f};
  const double expected = 0.25 + (2.0 * 0.125 + 4.0 * 0x1p-24);
  EXPECT_EQ(make_planes(f.chunk, triangle).planes[0].f0, expected);
  f.state.polygon_offset.enabled = false;
  EXPECT_EQ(make_planes(f.chunk, triangle).planes[0].f0, 0.25);
}

TEST(Planes, LinesVaryAlongTheirMajorAxisOnly) {
  const Fixture f(Topology::lines, {{0.5f, 1, 0}, {1.0f, 1, 16}});
  const PlaneSet wide = make_planes(f.chunk, at({{0, 0}, {16, 8}}));
  EXPECT_EQ(wide.planes[2].ddx, 1.0);
  EXPECT_EQ(wide.planes[2].ddy, 0.0);
  const PlaneSet tall = make_planes(f.chunk, at({{0, 8}, {4, 0}}));
  EXPECT_EQ(tall.planes[2].ddx, 0.0);
  EXPECT_EQ(tall.planes[2].ddy, -2.0);
}

TEST(Planes, PointsDoNotVary) {
  const Fixture f(Topology::points, {{0.5f, 1, 3}});
  const SpanQuantities along = quantities_along(make_planes(f.chunk, at({{7, 7}})), {9, 4, 11});
  EXPECT_EQ(along.quantities[2].at(6), 3.0f);
  EXPECT_EQ(along.quantities[0].at(2), 0.5f);
}

}  // namespace
}  // namespace barrido::raster::reference
