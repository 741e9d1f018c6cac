// What is seen: depth, culling, clipping, the rules of coverage.
#include "tests/golden/stage.h"

namespace barrido::golden {
namespace {

constexpr glm::vec4 kRed{0.9f, 0.2f, 0.15f, 1};
constexpr glm::vec4 kGreen{0.2f, 0.75f, 0.3f, 1};
constexpr glm::vec4 kBlue{0.25f, 0.4f, 0.9f, 1};

/// Three triangles, each before the next: no order of painting could draw them.
void depth_buffer(Stage& stage) {
  const State state = view_from(3);
  stage.draw(state, triangle({-1, -0.7f, 0.5f}, {1, -0.9f, -0.5f}, {1, -0.5f, -0.5f}, kRed));
  stage.draw(state, triangle({0.7f, -1, 0.5f}, {0.3f, 1, -0.5f}, {0, 0.9f, -0.5f}, kGreen));
  stage.draw(state, triangle({0.4f, 1, 0.5f}, {-1, -0.9f, -0.5f}, {-0.7f, -1, -0.5f}, kBlue));
}

/// A grey square at depth 0; three bars before, in and behind its plane are compared with it: never, less,
/// equal, lequal, greater, notequal, gequal, always.
void depth_functions(Stage& stage) {
  for (int cell = 0; cell < 8; ++cell) {
    State state = in_cell(flat_view(), cell, 4, 2);
    state.depth.test = true;
    stage.draw(state, with_color(rectangle(-0.8f, -0.8f, 0.8f, 0.8f), {0.6f, 0.6f, 0.6f, 1}));
    state.depth.compare = static_cast<raster::Compare>(cell);
    stage.draw(state, with_color(rectangle(-0.7f, -0.95f, -0.3f, 0.95f, 0.5f), kRed));
    stage.draw(state, with_color(rectangle(-0.2f, -0.95f, 0.2f, 0.95f, 0.0f), kGreen));
    stage.draw(state, with_color(rectangle(0.3f, -0.95f, 0.7f, 0.95f, -0.5f), kBlue));
  }
}

/// A nearer square that does not write its depth is painted over by a farther one.
void depth_mask(Stage& stage) {
  State state = view_from(3);
  state.depth.write = false;
  stage.draw(state, with_color(rectangle(-1, -0.8f, 0.3f, 0.5f, 0.3f), kRed));
  state.depth.write = true;
  stage.draw(state, with_color(rectangle(-0.3f, -0.5f, 1, 0.8f, -0.3f), kBlue));
}

/// An open box with no, back and front faces left out, and with the other winding called front.
void culling(Stage& stage) {
  const State view = placed(placed(view_from(5), turned(25, {1, 0, 0})), turned(-30, {0, 1, 0}));
  constexpr pipeline::CullFace kCull[] = {pipeline::CullFace::none, pipeline::CullFace::back,
                                          pipeline::CullFace::front, pipeline::CullFace::back};
  for (int cell = 0; cell < 4; ++cell) {
    State state = in_cell(view, cell, 2, 2);
    state.cull_face = kCull[cell];
    if (cell == 3) state.front_face = pipeline::FrontFace::clockwise;
    stage.draw(state, open_box());
  }
}

/// Two clip planes cut a sphere; flat colours show that new vertices keep the polygon's.
void clip_planes(Stage& stage) {
  State state = view_from(3);
  state.shade_model = pipeline::ShadeModel::flat;
  state.clip_planes = {{1, 0.3f, 0, 0.2f}, {0, -1, 0.2f, 1.0f}};
  Shape ball = sphere(16, 10);
  for (const glm::vec3& n : ball.normal) ball.color.emplace_back(n * 0.45f + 0.5f, 1);
  stage.draw(state, ball);
}

/// The floor begins behind the eye: w changes its sign within the triangles.
void near_plane(Stage& stage) {
  State state = view_from(0);
  state.texture_units[0].texture = stage.keep(checker(32));
  state.texture_units[0].min_filter = raster::MinFilter::linear_mipmap_linear;
  stage.draw(state, ground(20, 10));
}

/// A box and a white strip that reach beyond the far plane: cut off, and drawn with the depth clamped.
void depth_clamp(Stage& stage) {
  State state = view_from(3);
  state.clip_from_eye = pipeline::perspective(0.8, 4.0 / 3.0, 0.1, 3.5);
  state.depth.compare = raster::Compare::less_equal;
  for (const int cell : {0, 1}) {
    State half = in_cell(state, cell, 2, 1);
    half.depth_clamp = cell == 1;
    stage.draw(half, with_color(open_box(), kRed * 0.5f));
    stage.draw(placed(half, turned(70, {0, 1, 0})), rectangle(-2, -0.6f, 2, 0.6f));
  }
}

/// Two depth ranges in one frame: what is drawn in [0, ½] is before all that is drawn in [½, 1].
void depth_range(Stage& stage) {
  State state = view_from(3);
  state.viewport.depth_near = 0.5f;
  stage.draw(state, with_color(rectangle(-1, -0.8f, 0.3f, 0.5f, 0.5f), kRed));
  state.viewport.depth_near = 0.0f;
  state.viewport.depth_far = 0.5f;
  stage.draw(state, with_color(rectangle(-0.3f, -0.5f, 1, 0.8f, -0.5f), kBlue));
}

/// A fan of translucent triangles about a pixel's centre with corners on others: a pixel drawn twice were
/// brighter, one left out darker.
void shared_edges(Stage& stage) {
  State state;
  state.clip_from_eye = pipeline::orthographic(0, kWidth, 0, kHeight, -1, 1);
  state.blend = {true, raster::BlendFactor::one, raster::BlendFactor::one, raster::BlendFactor::one,
                 raster::BlendFactor::one};
  stage.clear({0, 0, 0, 1});
  constexpr int kCorners = 24;
  const auto corner = [](int i) -> glm::vec3 {  // around a square, every one on a pixel's centre
    const int side = i / 6 % 4;
    const float along = -49.0f + 98.0f * static_cast<float>(i % 6) / 6.0f;
    const float a = static_cast<float>(static_cast<int>(along)) + 80.5f;
    const float b = static_cast<float>(static_cast<int>(along)) + 60.5f;
    if (side == 0) return {a, 11.5f, 0};
    if (side == 1) return {129.5f, b, 0};
    if (side == 2) return {161.0f - a, 109.5f, 0};
    return {31.5f, 121.0f - b, 0};
  };
  for (int i = 0; i < kCorners; ++i) {
    stage.draw(state, triangle({80.5f, 60.5f, 0}, corner(i), corner(i + 1), {0.4f, 0.45f, 0.5f, 1}));
  }
}

/// Colours are taken at a place before hidden parts are found: drawing front to back or back to front is the
/// same.
void painted_both_ways(Stage& stage) {
  for (const int cell : {0, 1}) {
    const State state = in_cell(view_from(3), cell, 2, 1);
    for (int i = 0; i < 5; ++i) {
      const int k = cell == 0 ? i : 4 - i;
      const float z = static_cast<float>(k) * 0.3f - 0.6f;
      const float shift = static_cast<float>(k) * 0.25f - 0.5f;
      stage.draw(state, with_color(rectangle(shift - 0.4f, shift - 0.4f, shift + 0.4f, shift + 0.4f, z),
                                   {0.2f * static_cast<float>(k) + 0.1f, 0.4f,
                                    0.9f - 0.2f * static_cast<float>(k), 1}));
    }
  }
}

/// Drawn only inside the rectangle; the second box in red and alpha alone.
void scissor_and_mask(Stage& stage) {
  const State view = placed(placed(view_from(4), turned(25, {1, 0, 0})), turned(-30, {0, 1, 0}));
  State state = in_cell(view, 0, 2, 1);
  state.scissor = {true, 20, 30, 41, 57};
  stage.draw(state, open_box());
  state = in_cell(view, 1, 2, 1);
  state.color_mask = {true, false, false, true};
  stage.draw(state, open_box());
}

/// A pattern in the plane of a tilted square: without offset their depths fight, with it the pattern wins.
void polygon_offset(Stage& stage) {
  for (const int cell : {0, 1}) {
    State state = placed(in_cell(view_from(3), cell, 2, 1), turned(50, {1, 0.4, 0}));
    stage.draw(state, with_color(plane(1), {0.3f, 0.4f, 0.7f, 1}));
    state.polygon_offset = {cell == 1, -1, -4};
    stage.draw(state, with_color(plane(7), {0.95f, 0.8f, 0.3f, 1}));
    state.polygon_offset = {cell == 1, -2, -8};
    stage.draw(state, triangle({-0.5f, -0.5f, 0}, {0.6f, -0.4f, 0}, {0, 0.7f, 0}, kRed));
  }
}

}  // namespace

std::vector<Scene> visibility_scenes() {
  return {{"depth_buffer", depth_buffer},
          {"depth_functions", depth_functions},
          {"depth_mask", depth_mask},
          {"culling", culling},
          {"clip_planes", clip_planes},
          {"near_plane", near_plane},
          {"depth_clamp", depth_clamp},
          {"depth_range", depth_range},
          {"shared_edges", shared_edges},
          {"painted_both_ways", painted_both_ways},
          {"scissor_and_mask", scissor_and_mask},
          {"polygon_offset", polygon_offset}};
}

}  // namespace barrido::golden
