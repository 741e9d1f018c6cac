// Culling, clipping, flat colours and chunks, seen in what assembly hands to the rasterizer.
#include "pipeline/assembly.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <gtest/gtest.h>

#include "drawn.h"
#include "pipeline/primitive_mode.h"
#include "random.h"

namespace barrido::pipeline {
namespace {

std::int64_t doubled_area(const raster::PrimitiveRecord& p) {
  return static_cast<std::int64_t>(p.x[1] - p.x[0]) * (p.y[2] - p.y[0]) -
         static_cast<std::int64_t>(p.x[2] - p.x[0]) * (p.y[1] - p.y[0]);
}

const std::vector<float> kTriangle{-0.5f, -0.5f, 0, 0.5f, -0.5f, 0, 0, 0.5f, 0};

TEST(Assembly, KeepsWhatFacesTheRightWay) {
  struct Row {
    CullFace cull;
    FrontFace front;
    bool seen;  // of a counter-clockwise triangle
  };
  for (const Row& row :
       {Row{CullFace::none, FrontFace::counter_clockwise, true},
        Row{CullFace::back, FrontFace::counter_clockwise, true},
        Row{CullFace::front, FrontFace::counter_clockwise, false},
        Row{CullFace::back, FrontFace::clockwise, false}, Row{CullFace::front, FrontFace::clockwise, true},
        Row{CullFace::front_and_back, FrontFace::clockwise, false}}) {
    State state;
    state.cull_face = row.cull;
    state.front_face = row.front;
    const Drawn drawn(state, geometry_of(kTriangle));
    EXPECT_EQ(drawn.primitives().size(), row.seen ? 1u : 0u);
    EXPECT_EQ(drawn.counts.culled, row.seen ? 0u : 1u);
  }
}

TEST(Assembly, DropsTrianglesThatMissEveryCentreOrHaveNoArea) {
  // Window 256 × 128: a pixel is 1/128 wide in x. Centres are at odd multiples of 1/256.
  const float p = 1.0f / 128;
  const std::vector<float> positions{
      0.1f * p, 0, 0, 0.4f * p, 0, 0, 0.1f * p, 0.5f, 0,  // between two columns of centres
      0,        0, 0, 0.5f,     0, 0, 1,        0,    0,  // no area
      0.1f * p, 0, 0, 0.9f * p, 0, 0, 0.1f * p, 0.5f, 0,  // holds centres
  };
  const Drawn drawn(State{}, geometry_of(positions));
  EXPECT_EQ(drawn.primitives().size(), 1u);
  EXPECT_EQ(drawn.counts.culled, 2u);
  EXPECT_EQ(drawn.counts.primitives, 3u);
}

/// A triangle in the window, in 1/256 pixel.
struct Corners {
  std::array<int, 3> x{}, y{};
};

/// Whether a centre is inside, or on a left or lower edge.
bool covers(const Corners& t, int centre_x, int centre_y) {
  const raster::PrimitiveRecord record{{t.x[0], t.x[1], t.x[2]}, {t.y[0], t.y[1], t.y[2]}, {}, {}};
  const std::int64_t sign = doubled_area(record) < 0 ? -1 : 1;
  for (std::size_t e = 0; e < 3; ++e) {
    const std::size_t next = (e + 1) % 3;
    const std::int64_t dx = sign * (t.x[next] - t.x[e]);
    const std::int64_t dy = sign * (t.y[next] - t.y[e]);
    const std::int64_t side = dx * (centre_y - t.y[e]) - dy * (centre_x - t.x[e]);
    const bool owns = dy < 0 || (dy == 0 && dx > 0);
    if (side < 0 || (side == 0 && !owns)) return false;
  }
  return doubled_area(record) != 0;
}

/// Columns or rows of centres between the least and the greatest coordinate.
int centres_between(const std::array<int, 3>& v) {
  const auto [least, most] = std::minmax({v[0], v[1], v[2]});
  return (most + 127) / 256 - (least + 127) / 256;
}

bool covers_any(const Corners& t) {
  const int column = (*std::min_element(t.x.begin(), t.x.end()) + 127) / 256;
  const int row = (*std::min_element(t.y.begin(), t.y.end()) + 127) / 256;
  for (int y = row; y < row + centres_between(t.y); ++y) {
    for (int x = column; x < column + centres_between(t.x); ++x) {
      if (covers(t, 256 * x + 128, 256 * y + 128)) return true;
    }
  }
  return false;
}

TEST(Assembly, KeepsSmallTrianglesThatCoverACentreAndNoOthers) {
  // The window of `Drawn` is 256 × 128 pixels; corners on halves of pixels often meet centres.
  Random random(22);
  int kept = 0, dropped = 0;
  for (int n = 0; n < 600; ++n) {
    std::vector<Corners> triangles(20);
    std::vector<float> positions;
    for (Corners& t : triangles) {
      const int step = random.below(2) == 0 ? 128 : 1;
      const int size = random.below(4) == 0 ? 2560 : 640;
      for (std::size_t k = 0; k < 3; ++k) {
        t.x[k] = 20480 + random.below(size / step) * step;
        t.y[k] = 10240 + random.below(size / step) * step;
        positions.insert(positions.end(),
                         {static_cast<float>(t.x[k]) / 32768 - 1, static_cast<float>(t.y[k]) / 16384 - 1, 0});
      }
    }
    const Drawn drawn(State{}, geometry_of(positions));
    std::size_t next = 0;
    for (const Corners& t : triangles) {
      const bool is_drawn = next < drawn.primitives().size() &&
                            std::equal(t.x.begin(), t.x.end(), drawn.primitives()[next].x) &&
                            std::equal(t.y.begin(), t.y.end(), drawn.primitives()[next].y);
      next += is_drawn;
      kept += is_drawn;
      dropped += !is_drawn;
      if (covers_any(t)) {
        EXPECT_TRUE(is_drawn);
      } else if (centres_between(t.x) <= 2 && centres_between(t.y) <= 2) {
        EXPECT_FALSE(is_drawn);
      }
    }
    EXPECT_EQ(next, drawn.primitives().size());
  }
  EXPECT_GT(kept, 5000);
  EXPECT_GT(dropped, 2000);
}

TEST(Assembly, SignOfTheAreaIsExact) {
  // Slivers of area ±1 and 0 (in units of 1/65536 pixel²) that span the frame.
  State state;
  state.cull_face = CullFace::back;
  Random random(21);
  for (int n = 0; n < 2000; ++n) {
    std::vector<float> positions;
    const int dx = 20000 + random.below(20000), dy = 10000 + random.below(10000);
    // (0, 0), (dx, dy), (x, y) with dx·y − dy·x close to 0
    const int x = random.below(dx);
    const int y = static_cast<int>(static_cast<std::int64_t>(dy) * x / dx) + random.below(3) - 1;
    const auto add = [&](int px, int py) {
      positions.insert(positions.end(),
                       {static_cast<float>(px) / 32768 - 1, static_cast<float>(py) / 16384 - 1, 0});
    };
    add(0, 0);
    add(dx, dy);
    add(x, y);
    const Drawn drawn(state, geometry_of(positions));
    const std::int64_t area = static_cast<std::int64_t>(dx) * y - static_cast<std::int64_t>(x) * dy;
    if (area <= 0) {
      EXPECT_TRUE(drawn.primitives().empty());
    } else if (!drawn.primitives().empty()) {
      EXPECT_EQ(doubled_area(drawn.primitives()[0]), area);
    }
  }
}

TEST(Assembly, TrianglesThatCrossTheFrameAreNotClipped) {
  const std::vector<float> positions{-9, -9, 0, 20, -9, 0, 0, 30, 0};
  const Drawn drawn(State{}, geometry_of(positions));
  EXPECT_EQ(drawn.primitives().size(), 1u);
  EXPECT_EQ(drawn.counts.clipped, 0u);
  EXPECT_TRUE(drawn.chunks[0].own_records.empty());
}

TEST(Assembly, TrianglesOutsideTheViewAreDropped) {
  State state;
  state.clip_planes = {{1, 0, 0, 0}};
  const std::vector<float> positions{2,    0, 0, 3,     0, 0, 2,     1,    0,  // right of the view
                                     0,    0, 2, 1,     0, 2, 0,     1,    2,  // behind the far plane
                                     -1,   0, 0, -0.5f, 0, 0, -0.5f, 0.5f, 0,  // behind the user's plane
                                     0.1f, 0, 0, 0.5f,  0, 0, 0.5f,  0.5f, 0};
  const Drawn drawn(state, geometry_of(positions));
  EXPECT_EQ(drawn.primitives().size(), 1u);
  EXPECT_EQ(drawn.counts.culled, 3u);
  EXPECT_EQ(drawn.counts.clipped, 0u);
}

TEST(Assembly, ClippedTrianglesInterpolateTheirVaryings) {
  State state;
  state.clip_from_eye[2][3] = -1.0f;  // w = −z, so that z = −w·… : perspective without depth
  state.clip_from_eye[3][3] = 0.0f;
  state.clip_from_eye[2][2] = 0.0f;
  state.clip_planes = {{1, 0, 0, 0}};  // x ≥ 0
  std::vector<float> positions{-1, 0, -2, 3, 0, -4, 3, 1, -4};
  const std::vector<float> colors{0, 0, 0, 1, 1, 0, 0, 1, 1, 0, 1, 1};
  Geometry geometry = geometry_of(positions);
  geometry.color = {colors.data(), 4, 4};
  const Drawn drawn(state, geometry);
  EXPECT_EQ(drawn.counts.clipped, 1u);
  const raster::PrimitiveChunk& chunk = drawn.chunks.at(0);
  EXPECT_EQ(chunk.primitives.size(), 2u);
  EXPECT_EQ(chunk.own_records.size(), 2u * static_cast<std::size_t>(drawn.vertices.stride));
  const float* cut = chunk.record(chunk.shared_count, drawn.vertices.stride);
  // A quarter of the way from the first corner to the second: w = 2.5, red = ¼.
  EXPECT_FLOAT_EQ(cut[raster::kRecordQ], 0.4f);
  EXPECT_FLOAT_EQ(cut[raster::kRecordVaryings], 0.25f * 0.4f);
  for (const raster::PrimitiveRecord& p : chunk.primitives) {
    EXPECT_GT(doubled_area(p), 0);
    for (const std::int32_t x : p.x) EXPECT_GE(x, 128 * 256);
  }
}

TEST(Assembly, FlatColorOfTheProvokingVertex) {
  // A ribbon that works for all modes; colour i is i/16 in red.
  std::vector<float> positions, colors;
  for (int i = 0; i < 12; ++i) {
    positions.insert(positions.end(),
                     {-0.9f + 0.15f * static_cast<float>(i / 2), i % 2 == 0 ? -0.5f : 0.5f, 0});
    colors.insert(colors.end(), {static_cast<float>(i) / 16, 0, 0, 1});
  }
  for (const PrimitiveMode mode :
       {PrimitiveMode::points, PrimitiveMode::lines, PrimitiveMode::line_loop, PrimitiveMode::line_strip,
        PrimitiveMode::triangles, PrimitiveMode::triangle_strip, PrimitiveMode::quad_strip}) {
    State state;
    state.shade_model = ShadeModel::flat;
    Geometry geometry = geometry_of(positions, mode);
    geometry.color = {colors.data(), 4, 4};
    const Drawn drawn(state, geometry);
    ASSERT_EQ(drawn.chunks.size(), 1u);
    const raster::PrimitiveChunk& chunk = drawn.chunks[0];
    for (std::uint32_t i = 0; i < chunk.primitives.size(); ++i) {
      std::uint32_t expected = i;
      if (mode == PrimitiveMode::lines) expected = 2 * i + 1;
      if (mode == PrimitiveMode::line_strip) expected = i + 1;
      if (mode == PrimitiveMode::line_loop) expected = (i + 1) % 12;
      if (is_polygonal(mode)) expected = provoking_element(mode, polygon_of_triangle(mode, i));
      const auto& p = chunk.primitives[i];
      EXPECT_EQ(chunk.flat[p.flat_and_facing].color[0], static_cast<float>(expected) / 16)
          << "mode " << static_cast<int>(mode) << ", primitive " << i;
    }
  }
}

TEST(Assembly, FlatColorOfTheCentroid) {
  // Without lighting the mean of the colours; with it, the model at the mean point.
  const std::vector<float> positions{-0.5f, -0.5f, 0, 0.5f, -0.5f, 0, 0.5f, 0.5f, 0, -0.5f, 0.5f, 0};
  const std::vector<float> colors{0, 0, 0, 1, 1, 0, 0, 1, 1, 1, 0, 1, 0, 0, 1, 0};
  Geometry geometry = geometry_of(positions, PrimitiveMode::quads);
  geometry.color = {colors.data(), 4, 4};
  State state;
  state.shade_model = ShadeModel::flat;
  state.flat_at = FlatAt::centroid;
  const Drawn unlit(state, geometry);
  ASSERT_EQ(unlit.chunks.at(0).primitives.size(), 2u);
  EXPECT_EQ(unlit.chunks[0].flat.size(), 1u) << "both triangles of the quad share it";
  const raster::FlatColors& flat = unlit.chunks[0].flat[0];
  EXPECT_FLOAT_EQ(flat.color[0], 0.5f);
  EXPECT_FLOAT_EQ(flat.color[2], 0.25f);
  EXPECT_FLOAT_EQ(flat.color[3], 0.75f);

  state.lighting.enabled = true;
  state.lighting.ambient = {0, 0, 0, 1};
  state.lighting.front.diffuse = {1, 1, 1, 1};
  Light light;
  light.position = {0, 0, 1, 1};  // straight above the centroid, at distance 1
  light.constant_attenuation = 0.0f;
  light.quadratic_attenuation = 2.0f;
  state.lighting.lights = {light};
  const Drawn lit(state, geometry);
  EXPECT_FLOAT_EQ(lit.chunks.at(0).flat.at(0).color[0], 0.5f);
  EXPECT_EQ(lit.counts.illuminations, 1u);
}

TEST(Assembly, TwoSidedLightingTakesTheBackSide) {
  State state;
  state.lighting.enabled = true;
  state.lighting.two_sided = true;
  state.lighting.ambient = {1, 1, 1, 1};
  state.lighting.front.ambient = {1, 0, 0, 1};
  state.lighting.back.ambient = {0, 1, 0, 1};
  const std::vector<float> positions{-0.5f, -0.5f, 0, 0.5f, -0.5f, 0, 0, 0.5f, 0};
  Geometry geometry = geometry_of(positions);
  for (const bool back : {false, true}) {
    state.front_face = back ? FrontFace::clockwise : FrontFace::counter_clockwise;
    state.shade_model = ShadeModel::gouraud;
    const Drawn gouraud(state, geometry);
    const raster::PrimitiveRecord p = gouraud.primitives().at(0);
    EXPECT_EQ(p.flat_and_facing & raster::kBackFacing, 0u);
    const float* record = gouraud.chunks[0].record(p.vertex[0], gouraud.vertices.stride);
    EXPECT_EQ(record[raster::kRecordVaryings + (back ? 1 : 0)], 1.0f);
    EXPECT_EQ(record[raster::kRecordVaryings + (back ? 0 : 1)], 0.0f);

    state.shade_model = ShadeModel::phong;
    EXPECT_EQ((Drawn(state, geometry).primitives().at(0).flat_and_facing & raster::kBackFacing) != 0, back);

    state.shade_model = ShadeModel::flat;
    for (const FlatAt at : {FlatAt::provoking_vertex, FlatAt::centroid}) {
      state.flat_at = at;
      const Drawn flat(state, geometry);
      EXPECT_EQ(flat.chunks.at(0).flat.at(0).color[back ? 1 : 0], 1.0f);
    }
  }
}

TEST(Assembly, BigDrawsAreCutIntoChunksInOrder) {
  std::vector<float> positions;
  Random random(22);
  for (int i = 0; i < 3 * 10000; ++i) {
    positions.insert(positions.end(), {random.in(-1, 1), random.in(-1, 1), random.in(-1.5, 1)});
  }
  State state;
  state.clip_planes = {{1, 0, 0, 0.5f}, {0, 1, 0, 0.5f}, {-1, -1, 0, 1}};
  const Drawn drawn(state, geometry_of(positions));
  EXPECT_GT(drawn.counts.clipped, 1000u);
  std::uint64_t primitives = 0;
  std::uint32_t last_shared = 0;
  for (const raster::PrimitiveChunk& chunk : drawn.chunks) {
    EXPECT_LE(chunk.primitives.size(), static_cast<std::size_t>(raster::kMaxChunkPrimitives));
    EXPECT_FALSE(chunk.primitives.empty());
    primitives += chunk.primitives.size();
    const auto own = chunk.own_records.size() / static_cast<std::size_t>(drawn.vertices.stride);
    for (const raster::PrimitiveRecord& p : chunk.primitives) {
      for (const std::uint32_t vertex : p.vertex) {
        ASSERT_LT(vertex, chunk.shared_count + own);
        if (vertex >= chunk.shared_count) continue;
        ASSERT_GE(vertex / 3, last_shared / 3);
        last_shared = vertex;
      }
    }
  }
  EXPECT_GE(primitives, drawn.counts.primitives - drawn.counts.culled);
}

}  // namespace
}  // namespace barrido::pipeline
