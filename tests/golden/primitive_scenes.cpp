// OpenGL's primitive modes, which vertex gives a flat polygon its colour, points, lines and outlined
// polygons.
#include "tests/golden/stage.h"

namespace barrido::golden {
namespace {

/// Eight vertices along two rows, each in a colour of its own, as all ten modes (fan and polygon around an
/// octagon).
Shape eight_vertices(PrimitiveMode mode) {
  Shape shape;
  shape.mode = mode;
  const bool ring = mode == PrimitiveMode::polygon || mode == PrimitiveMode::triangle_fan ||
                    mode == PrimitiveMode::line_loop || mode == PrimitiveMode::quads;
  constexpr glm::vec2 kRing[] = {{0.8f, -0.3f}, {0.8f, 0.3f},   {0.3f, 0.8f},   {-0.3f, 0.8f},
                                 {-0.8f, 0.3f}, {-0.8f, -0.3f}, {-0.3f, -0.8f}, {0.3f, -0.8f}};
  for (int i = 0; i < 8; ++i) {
    const glm::vec2 row(-0.8f + 0.53f * static_cast<float>(i / 2), i % 2 == 0 ? 0.6f : -0.6f);
    shape.position.emplace_back(ring ? kRing[i] : row, 0.0f, 1.0f);
    shape.color.emplace_back((i & 1) != 0 ? 0.9f : 0.2f, (i & 2) != 0 ? 0.9f : 0.25f,
                             (i & 4) != 0 ? 0.9f : 0.3f, 1.0f);
  }
  return shape;
}

void draw_modes(Stage& stage, pipeline::ShadeModel shade_model) {
  for (int mode = 0; mode < 10; ++mode) {
    State state = in_cell(flat_view(), mode, 4, 3);
    state.shade_model = shade_model;
    state.point_size = 5;
    state.line_width = 2;
    stage.draw(state, eight_vertices(static_cast<PrimitiveMode>(mode)));
  }
}

void modes_smooth(Stage& stage) { draw_modes(stage, pipeline::ShadeModel::gouraud); }
void modes_flat(Stage& stage) { draw_modes(stage, pipeline::ShadeModel::flat); }

/// The six polygonal modes without their backs, and below without their fronts: where strips turn round every
/// other triangle, nothing is missing above and nothing is left below.
void modes_culled(Stage& stage) {
  for (int cell = 0; cell < 12; ++cell) {
    State state = in_cell(flat_view(), cell, 6, 2);
    state.cull_face = cell < 6 ? pipeline::CullFace::back : pipeline::CullFace::front;
    Shape shape = eight_vertices(static_cast<PrimitiveMode>(4 + cell % 6));
    if (shape.mode == PrimitiveMode::triangles) shape.indices = {0, 1, 2, 3, 5, 4};
    stage.draw(state, shape);
  }
}

/// Sizes 1 to 12; a size is rounded to whole pixels.
void points(Stage& stage) {
  State state;
  state.clip_from_eye = pipeline::orthographic(0, kWidth, 0, kHeight, -1, 1);
  for (int size = 1; size <= 12; ++size) {
    Shape shape;
    shape.mode = PrimitiveMode::points;
    for (int row = 0; row < 5; ++row) {  // places within a pixel
      const float within = 0.25f * static_cast<float>(row);
      const auto at = static_cast<float>(12 * size);
      shape.position.emplace_back(at - 4 + within, 12 + 22 * static_cast<float>(row) + within, 0, 1);
      shape.color.emplace_back(0.9f, 0.2f * static_cast<float>(row), 0.3f, 1);
    }
    state.point_size = static_cast<float>(size);
    stage.draw(state, shape);
  }
}

/// A star of lines 1, 2, 3 and 5 pixels wide: x-major and y-major, in both directions.
void lines(Stage& stage) {
  constexpr float kWidths[] = {1, 2, 3, 5};
  constexpr glm::vec2 kEnds[] = {{9, 0},  {9, 4},   {8, 8},   {3, 9},   {0, 9},  {-4, 9}, {-9, 9}, {-9, 2},
                                 {-9, 0}, {-9, -5}, {-8, -8}, {-1, -9}, {0, -9}, {2, -9}, {9, -9}, {9, -3}};
  for (int cell = 0; cell < 4; ++cell) {
    State state = in_cell(flat_view(), cell, 2, 2);
    state.line_width = kWidths[cell];
    Shape shape;
    shape.mode = PrimitiveMode::lines;
    for (const glm::vec2& end : kEnds) {
      shape.position.emplace_back(end * 0.03f, 0, 1);
      shape.position.emplace_back(end * 0.1f, 0, 1);
      shape.color.emplace_back(1, 1, 1, 1);
      shape.color.emplace_back(0.9f, 0.4f, 0.1f, 1);
    }
    stage.draw(state, shape);
  }
}

/// One box as faces, edges and corners. Edges are those of the quads, without a diagonal.
void polygon_modes(Stage& stage) {
  const State view = placed(placed(view_from(5), turned(25, {1, 0, 0})), turned(-30, {0, 1, 0}));
  for (int cell = 0; cell < 4; ++cell) {
    State state = in_cell(view, cell, 2, 2);
    state.polygon_mode = static_cast<pipeline::PolygonMode>(cell % 3);
    state.point_size = 3;
    if (cell == 3) {  // outline over faces, of the front only
      state.cull_face = pipeline::CullFace::back;
      stage.draw(state, open_box());
      state.polygon_mode = pipeline::PolygonMode::line;
      state.depth.compare = raster::Compare::less_equal;
      state.line_width = 2;
      stage.draw(state, with_color(open_box(), {0, 0, 0, 1}));
      continue;
    }
    stage.draw(state, open_box());
  }
}

/// Outlined squares that a clip plane and the near plane cut: the cut is an edge as well.
void clipped_outlines(Stage& stage) {
  State state = in_cell(view_from(3), 0, 2, 1);
  state.polygon_mode = pipeline::PolygonMode::line;
  state.clip_planes = {{1, 0.5f, 0, 0.3f}};
  stage.draw(state, plane(3));
  state = view_from(0.4f);
  state.clip_from_eye = pipeline::perspective(1, 4.0 / 3.0, 0.6, 10);
  state = in_cell(state, 1, 2, 1);
  state.polygon_mode = pipeline::PolygonMode::line;
  stage.draw(placed(state, pipeline::product(translation(-0.2f, 0, -0.5f), turned(70, {0, 1, 0}))), plane(3));
}

}  // namespace

std::vector<Scene> primitive_scenes() {
  return {{"modes_smooth", modes_smooth},
          {"modes_flat", modes_flat},
          {"modes_culled", modes_culled},
          {"points", points},
          {"lines", lines},
          {"polygon_modes", polygon_modes},
          {"clipped_outlines", clipped_outlines}};
}

}  // namespace barrido::golden
