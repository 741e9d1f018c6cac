// Whole draws: pixels, counts, refusals, and independence from the number of threads.
#include "pipeline/renderer.h"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "drawn.h"
#include "pipeline/matrix.h"
#include "random.h"

namespace barrido::pipeline {
namespace {

const std::vector<float> kFullFrame{-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};

struct Rgb {
  int r, g, b;
  bool operator==(const Rgb&) const = default;
};

Rgb pixel(const raster::Framebuffer& frame, int x, int y) {
  const std::uint32_t c = frame.color8()[frame.index(x, y)];
  return {static_cast<int>(c & 255), static_cast<int>(c >> 8 & 255), static_cast<int>(c >> 16 & 255)};
}

raster::FramebufferOptions small_frame() {
  raster::FramebufferOptions options;
  options.width = 64;
  options.height = 32;
  return options;
}

struct Picture {
  raster::Framebuffer frame{small_frame()};
  Renderer renderer{frame};

  Picture() { renderer.clear({}); }
  void draw(const State& state, const Geometry& geometry) {
    renderer.draw(state, geometry);
    renderer.finish();
  }
};

TEST(Renderer, DrawsASquareOfOneColor) {
  Picture picture;
  Geometry geometry = geometry_of(kFullFrame, PrimitiveMode::quads);
  geometry.constant_color = {1, 0.5f, 0, 1};
  picture.draw(State{}, geometry);
  EXPECT_EQ(pixel(picture.frame, 0, 0), (Rgb{255, 128, 0}));
  EXPECT_EQ(pixel(picture.frame, 63, 31), (Rgb{255, 128, 0}));
}

TEST(Renderer, ViewportBoundsTrianglesAndScissorBoundsBoth) {
  Picture picture;
  State state;
  state.viewport = {8, 4, 16, 8};
  const std::vector<float> huge{-9, -9, 0, 20, -9, 0, 0, 30, 0};
  picture.draw(state, geometry_of(huge));
  EXPECT_EQ(pixel(picture.frame, 8, 4), (Rgb{255, 255, 255}));
  EXPECT_EQ(pixel(picture.frame, 23, 11), (Rgb{255, 255, 255}));
  EXPECT_EQ(pixel(picture.frame, 7, 4), (Rgb{0, 0, 0}));
  EXPECT_EQ(pixel(picture.frame, 24, 11), (Rgb{0, 0, 0}));
  EXPECT_EQ(pixel(picture.frame, 8, 12), (Rgb{0, 0, 0}));
  state.scissor = {true, 10, 0, 4, 100};
  picture.renderer.clear({});
  picture.draw(state, geometry_of(huge));
  EXPECT_EQ(pixel(picture.frame, 9, 5), (Rgb{0, 0, 0}));
  EXPECT_EQ(pixel(picture.frame, 10, 5), (Rgb{255, 255, 255}));
  EXPECT_EQ(pixel(picture.frame, 10, 3), (Rgb{0, 0, 0}));
  EXPECT_EQ(pixel(picture.frame, 14, 5), (Rgb{0, 0, 0}));
}

TEST(Renderer, AllShadingModesLightAFlatSurfaceAlike) {
  for (int model = 0; model < static_cast<int>(kShadingModeCount); ++model) {
    for (const FlatAt at : {FlatAt::provoking_vertex, FlatAt::centroid}) {
      Picture picture;
      State state;
      state.shade_model = static_cast<ShadeModel>(model);
      state.flat_at = at;
      state.lighting.enabled = true;
      state.lighting.ambient = {0, 0, 0, 1};
      state.lighting.lights.emplace_back().position = {0, 0.6f, 0.8f, 0};
      state.lighting.front.diffuse = {1, 0.5f, 0.25f, 1};
      picture.draw(state, geometry_of(kFullFrame, PrimitiveMode::quads));
      EXPECT_EQ(pixel(picture.frame, 5, 5), (Rgb{204, 102, 51})) << "model " << model;
    }
  }
}

TEST(Renderer, CountsTheWork) {
  Picture picture;
  State state;
  state.lighting.enabled = true;
  state.lighting.lights.resize(2);
  state.lighting.front.specular = {1, 1, 1, 1};
  state.lighting.front.shininess = 10;
  const Geometry geometry = geometry_of(kFullFrame, PrimitiveMode::quads);
  picture.draw(state, geometry);
  const Statistics gouraud = picture.renderer.statistics();
  EXPECT_EQ(gouraud.draws, 1u);
  EXPECT_EQ(gouraud.vertices, 4u);
  EXPECT_EQ(gouraud.primitives_in, 2u);
  EXPECT_EQ(gouraud.illuminations_vertex, 8u);
  EXPECT_EQ(gouraud.illuminations_fragment, 0u);
  EXPECT_EQ(gouraud.powers, 8u);
  EXPECT_EQ(gouraud.raster.fragments_covered, 64u * 32u);
  state.shade_model = ShadeModel::phong;
  picture.renderer.clear({});
  picture.draw(state, geometry);
  const Statistics both = picture.renderer.statistics();
  EXPECT_EQ(both.illuminations_vertex, 8u);
  EXPECT_EQ(both.illuminations_fragment, 2u * 64 * 32);
  EXPECT_EQ(both.powers, 8u + 2u * 64 * 32);
}

TEST(Renderer, OnlyTheVerticesThatAreUsedAreTransformed) {
  Picture picture;
  std::vector<float> positions(3 * 1000, 0.0f);
  positions.insert(positions.end(), kFullFrame.begin(), kFullFrame.end());
  Geometry geometry = geometry_of(positions, PrimitiveMode::quads);
  const std::vector<std::uint32_t> indices{1000, 1001, 1002, 1003};
  geometry.indices = indices;
  picture.draw(State{}, geometry);
  EXPECT_EQ(picture.renderer.statistics().vertices, 4u);
  EXPECT_EQ(pixel(picture.frame, 3, 3), (Rgb{255, 255, 255}));
}

TEST(Renderer, RefusesIndicesThatPointNowhere) {
  Picture picture;
  Geometry geometry = geometry_of(kFullFrame);
  std::vector<std::uint32_t> indices(100000, 1);
  indices[77777] = 4;
  geometry.indices = indices;
  EXPECT_THROW(picture.renderer.draw(State{}, geometry), std::out_of_range);
  geometry.vertex_count = 0;
  EXPECT_THROW(picture.renderer.draw(State{}, geometry), std::out_of_range);
  picture.renderer.finish();
  EXPECT_EQ(picture.renderer.statistics().draws, 0u);
  EXPECT_EQ(pixel(picture.frame, 3, 3), (Rgb{0, 0, 0}));
}

TEST(Renderer, NothingToDrawIsNoError) {
  Picture picture;
  picture.renderer.draw(State{}, Geometry{});
  picture.draw(State{}, geometry_of({}));
  std::vector<float> two(6, 0.0f);
  picture.draw(State{}, geometry_of(two));
  EXPECT_EQ(picture.renderer.statistics().primitives_in, 0u);
}

TEST(Renderer, RefusesImpossibleStates) {
  Picture picture;
  const Geometry geometry = geometry_of(kFullFrame, PrimitiveMode::quads);
  const auto refuses = [&](const auto& change) {
    State state;
    Geometry changed = geometry;
    change(state, changed);
    EXPECT_THROW(picture.renderer.draw(state, changed), std::invalid_argument);
  };
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  refuses([](State& s, Geometry&) { s.clip_planes.resize(kMaxClipPlanes + 1); });
  refuses([](State& s, Geometry&) { s.point_size = 0.0f; });
  refuses([](State& s, Geometry&) { s.line_width = kNan; });
  refuses([](State& s, Geometry&) { s.viewport.width = -1; });
  refuses([](State& s, Geometry&) { s.viewport.x = 20000; });
  refuses([](State& s, Geometry&) { s.viewport.depth_far = 1.5f; });
  refuses([](State& s, Geometry&) { s.viewport.depth_near = kNan; });
  refuses([](State& s, Geometry&) { s.scissor = {true, 0, 0, -1, 1}; });
  refuses([](State& s, Geometry&) {
    s.lighting.enabled = true;
    s.lighting.lights.resize(raster::kMaxLights + 1);
  });
  refuses([](State&, Geometry& g) { g.position.data = nullptr; });
  refuses([](State&, Geometry& g) { g.position.components = 5; });
  refuses([](State&, Geometry& g) { g.position.stride = -3; });
  refuses([](State&, Geometry& g) { g.color = {kFullFrame.data(), 2, 2}; });
  refuses([](State&, Geometry& g) { g.vertex_count = 0xffffffffu; });
}

TEST(Renderer, AnyNumberOfThreadsDrawsTheSame) {
  Random random(41);
  std::vector<float> positions, colors;
  for (int i = 0; i < 3 * 20000; ++i) {
    const glm::vec3 p = random.vec3(-1.2, 1.2), c = random.vec3(0, 1);
    positions.insert(positions.end(), {p.x, p.y, p.z});
    colors.insert(colors.end(), {c.x, c.y, c.z});
  }
  Geometry geometry = geometry_of(positions);
  geometry.color = {colors.data(), 3, 3};
  State state;
  state.blend.enabled = true;  // so that the order matters
  state.blend.src_rgb = raster::BlendFactor::constant_alpha;
  state.blend.dst_rgb = raster::BlendFactor::one_minus_constant_alpha;
  state.blend.constant = {0, 0, 0, 0.5f};
  raster::PixelArray<std::uint32_t> expected;
  for (const std::size_t threads : {1, 2, 4}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    Picture picture;
    picture.draw(state, geometry);
    if (threads == 1) expected = picture.frame.color8();
    EXPECT_EQ(picture.frame.color8(), expected) << threads << " threads";
  }
}

TEST(Renderer, ClearForgetsWhatWasDrawn) {
  Picture picture;
  picture.renderer.draw(State{}, geometry_of(kFullFrame, PrimitiveMode::quads));
  picture.renderer.clear({{0, 0, 1, 1}, 1});
  picture.renderer.finish();
  EXPECT_EQ(pixel(picture.frame, 3, 3), (Rgb{0, 0, 255}));
}

}  // namespace
}  // namespace barrido::pipeline
