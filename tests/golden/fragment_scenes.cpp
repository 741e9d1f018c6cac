// What happens to fragments: fog, alpha test, blending.
#include "tests/golden/stage.h"

namespace barrido::golden {
namespace {

using raster::BlendEquation;
using raster::BlendFactor;

/// Alpha runs from 0 on the left to 1 on the right.
Shape alpha_ramp() {
  Shape shape = rectangle(-0.95f, -0.95f, 0.95f, 0.95f);
  for (const glm::vec4& p : shape.position) shape.color.emplace_back(0.9f, 0.7f, 0.3f, p.x > 0 ? 1.0f : 0.0f);
  return shape;
}

/// Never, less, equal, lequal, greater, notequal, gequal and always 0.5: a ramp of alpha without blending.
void alpha_functions(Stage& stage) {
  for (int cell = 0; cell < 8; ++cell) {
    State state = in_cell(flat_view(), cell, 4, 2);
    state.alpha_test = {true, static_cast<raster::Compare>(cell), 0.5f};
    stage.draw(state, alpha_ramp());
  }
}

/// Holes by alpha test let see what is behind, whatever the order, for they write no depth.
void alpha_holes(Stage& stage) {
  raster::TextureOptions options;
  const raster::Texture* holes = stage.keep(texture_of(32, options, [](int i, int j) -> glm::vec4 {
    const int x = i % 16 - 8;
    const int y = j % 16 - 8;
    return {0.9f, 0.85f, 0.7f, x * x + y * y < 30 ? 0.0f : 1.0f};
  }));
  State state = placed(view_from(3), turned(25, {0, 1, 0}));
  state.texture_units[0].texture = holes;
  state.texture_units[0].min_filter = raster::MinFilter::linear;
  state.alpha_test = {true, raster::Compare::greater_equal, 0.5f};
  stage.draw(state, with_color(rectangle(-1, -1, 1, 1, 0.4f), {1, 0.6f, 0.5f, 1}));
  stage.draw(state, with_color(rectangle(-1, -1, 1, 1, -0.4f, 2), {0.5f, 0.7f, 1, 1}));
}

/// Under each cell stripes of four colours, one translucent; over them a ramp of alpha.
void under(Stage& stage, const State& state) {
  constexpr glm::vec4 kStripes[] = {
      {0.1f, 0.1f, 0.6f, 1}, {0.9f, 0.9f, 0.9f, 0.5f}, {0.8f, 0.2f, 0.2f, 0}, {0.2f, 0.7f, 0.3f, 1}};
  for (int i = 0; i < 4; ++i) {
    const float y = -1 + 0.5f * static_cast<float>(i);
    stage.draw(state, with_color(rectangle(-1, y, 1, y + 0.5f), kStripes[i]));
  }
}

/// All fifteen factors of the source, added to half of the destination.
void source_factors(Stage& stage) {
  for (int cell = 0; cell < 15; ++cell) {
    State state = in_cell(flat_view(), cell, 5, 3);
    under(stage, state);
    const auto factor = static_cast<BlendFactor>(cell);
    state.blend = {true, factor, BlendFactor::constant_color, factor, BlendFactor::constant_color};
    state.blend.constant = {0.5f, 0.4f, 0.3f, 0.5f};
    stage.draw(state, alpha_ramp());
  }
}

/// The fourteen factors of the destination, with half of the source.
void destination_factors(Stage& stage) {
  for (int cell = 0; cell < 14; ++cell) {
    State state = in_cell(flat_view(), cell, 5, 3);
    under(stage, state);
    const auto factor = static_cast<BlendFactor>(cell);
    state.blend = {true, BlendFactor::constant_alpha, factor, BlendFactor::constant_alpha, factor};
    state.blend.constant = {0.5f, 0.4f, 0.3f, 0.5f};
    stage.draw(state, alpha_ramp());
  }
}

/// Add, subtract, reverse subtract; min, max.
void equations(Stage& stage) {
  for (int cell = 0; cell < 5; ++cell) {
    State state = in_cell(flat_view(), cell, 3, 2);
    under(stage, state);
    state.blend = {true, BlendFactor::src_alpha, BlendFactor::one, BlendFactor::one, BlendFactor::one};
    state.blend.equation = static_cast<BlendEquation>(cell);
    stage.draw(state, alpha_ramp());
  }
}

/// Stained glass: each pane multiplies what is behind by its colour (t as a colour), in a frame of float and
/// of 8 bits alike.
void stained_glass(Stage& stage) {
  State state = view_from(3);
  state.texture_units[0].texture = stage.keep(checker(32));
  state.texture_units[0].min_filter = raster::MinFilter::linear_mipmap_linear;
  stage.draw(state, rectangle(-1.5f, -1.1f, 1.5f, 1.1f, -0.5f));
  state.texture_units[0].texture = nullptr;
  state.depth.write = false;
  state.blend = {true, BlendFactor::zero, BlendFactor::src_color, BlendFactor::zero, BlendFactor::one};
  stage.draw(state, with_color(rectangle(-0.9f, -0.7f, 0.3f, 0.6f), {0.9f, 0.25f, 0.2f, 1}));
  stage.draw(state, with_color(rectangle(-0.3f, -0.5f, 0.9f, 0.8f, 0.2f), {0.25f, 0.5f, 0.95f, 1}));
}

/// I = t I_front + (1 − t) I_behind with t = 0.2, 0.5, 0.8 for three panes one before the other.
void translucent_panes(Stage& stage) {
  State state = view_from(3);
  state.blend = {true, BlendFactor::src_alpha, BlendFactor::one_minus_src_alpha, BlendFactor::one,
                 BlendFactor::one_minus_src_alpha};
  for (int i = 0; i < 3; ++i) {
    const float x = 0.5f * static_cast<float>(i) - 0.9f;
    stage.draw(state, with_color(rectangle(x, x * 0.6f - 0.3f, x + 0.8f, x * 0.6f + 0.7f,
                                           0.2f * static_cast<float>(i)),
                                 {i == 0 ? 0.9f : 0.1f, i == 1 ? 0.8f : 0.2f, i == 2 ? 0.9f : 0.1f,
                                  0.2f + 0.3f * static_cast<float>(i)}));
  }
}

/// A checkered floor in linear, exponential and squared exponential fog, and in linear fog that begins
/// farther away.
void fogs(Stage& stage) {
  const raster::Texture* texture = stage.keep(checker(64));
  stage.clear({0.65f, 0.7f, 0.75f, 1});
  for (int cell = 0; cell < 4; ++cell) {
    State state = in_cell(view_from(0), cell, 2, 2);
    state.texture_units[0].texture = texture;
    state.texture_units[0].min_filter = raster::MinFilter::linear_mipmap_linear;
    state.fog.enabled = true;
    state.fog.mode = static_cast<raster::FogMode>(cell % 3);
    state.fog.density = 0.18f;
    state.fog.start = cell == 3 ? 6.0f : 1.0f;
    state.fog.end = 15;
    state.fog.color = {0.65f, 0.7f, 0.75f, 1};
    stage.draw(state, ground(40, 20));
  }
}

/// Fog changes colours but no alpha: the translucent half stays translucent.
void fog_and_alpha(Stage& stage) {
  State state = view_from(3);
  stage.draw(state, with_color(rectangle(-1.3f, -0.2f, 1.3f, 0.2f, -0.3f), {0.9f, 0.3f, 0.2f, 1}));
  state.fog.enabled = true;
  state.fog.density = 0.3f;
  state.fog.color = {0.3f, 0.9f, 0.9f, 1};
  state.blend = {true, BlendFactor::src_alpha, BlendFactor::one_minus_src_alpha, BlendFactor::one,
                 BlendFactor::one_minus_src_alpha};
  stage.draw(state, with_color(rectangle(-1, -0.8f, 0, 0.8f), {0.2f, 0.2f, 0.2f, 0.4f}));
  stage.draw(state, with_color(rectangle(0.1f, -0.8f, 1, 0.8f), {0.2f, 0.2f, 0.2f, 1}));
}

}  // namespace

std::vector<Scene> fragment_scenes() {
  return {{"alpha_functions", alpha_functions},
          {"alpha_holes", alpha_holes},
          {"source_factors", source_factors},
          {"destination_factors", destination_factors},
          {"equations", equations},
          {"stained_glass", stained_glass},
          {"translucent_panes", translucent_panes},
          {"fogs", fogs},
          {"fog_and_alpha", fog_and_alpha}};
}

}  // namespace barrido::golden
