// Texture environments: how a texel and the colour so far become the next colour, with one unit and with two.
#include "tests/golden/stage.h"

namespace barrido::golden {
namespace {

using raster::CombineFunction;
using raster::CombineOperand;
using raster::CombineSource;
using raster::TextureEnvMode;

/// A square coloured from orange to violet, blended over the background by its alpha.
Shape colored_square() {
  Shape shape = rectangle(-0.95f, -0.95f, 0.95f, 0.95f);
  shape.color = {
      {0.9f, 0.5f, 0.1f, 1}, {0.6f, 0.2f, 0.7f, 1}, {0.9f, 0.5f, 0.1f, 0.6f}, {0.6f, 0.2f, 0.7f, 0.6f}};
  return shape;
}

State unit_of(State state, const raster::Texture* texture, TextureEnvMode mode) {
  raster::TextureUnit& unit = state.texture_units[0];
  unit.texture = texture;
  unit.min_filter = raster::MinFilter::linear;
  unit.env_mode = mode;
  unit.env_color = {0.1f, 0.9f, 0.4f, 1};
  state.blend = {true, raster::BlendFactor::src_alpha, raster::BlendFactor::one_minus_src_alpha,
                 raster::BlendFactor::one, raster::BlendFactor::one_minus_src_alpha};
  return state;
}

/// Modulate, replace, add; decal, blend (with green), and no texture.
void modes(Stage& stage) {
  const raster::Texture* texture = stage.keep(letter());
  for (int cell = 0; cell < 6; ++cell) {
    State state = unit_of(in_cell(flat_view(), cell, 3, 2), texture, static_cast<TextureEnvMode>(cell % 5));
    if (cell == 5) state.texture_units[0].texture = nullptr;
    stage.draw(state, colored_square());
  }
}

/// Replace, modulate, add; add signed, interpolate, subtract of texture, colour and constant.
void combine_functions(Stage& stage) {
  const raster::Texture* texture = stage.keep(letter());
  for (int cell = 0; cell < 6; ++cell) {
    State state = unit_of(in_cell(flat_view(), cell, 3, 2), texture, TextureEnvMode::combine);
    raster::CombineState& combine = state.texture_units[0].combine;
    combine.rgb.function = static_cast<CombineFunction>(cell);
    combine.rgb.operand[2] = CombineOperand::color;
    combine.alpha.function = CombineFunction::replace;
    combine.alpha.source[0] = CombineSource::primary;
    stage.draw(state, colored_square());
  }
}

/// Operands colour, 1 − colour, alpha, 1 − alpha of the texture, as they are and twice as large.
void combine_operands(Stage& stage) {
  const raster::Texture* texture = stage.keep(letter());
  for (int cell = 0; cell < 8; ++cell) {
    State state = unit_of(in_cell(flat_view(), cell, 4, 2), texture, TextureEnvMode::combine);
    raster::CombineState& combine = state.texture_units[0].combine;
    combine.rgb.function = CombineFunction::modulate;
    combine.rgb.operand[0] = static_cast<CombineOperand>(cell % 4);
    combine.rgb.scale = cell < 4 ? 1.0f : 2.0f;
    combine.alpha.function = CombineFunction::replace;
    combine.alpha.source[0] = CombineSource::primary;
    stage.draw(state, colored_square());
  }
}

/// A letter laid over a checker by its alpha; a checker times a spot of light; and the sum of two textures.
void two_units(Stage& stage) {
  const raster::Texture* base = stage.keep(checker(32));
  const raster::Texture* f = stage.keep(letter());
  const raster::Texture* glow = stage.keep(texture_of(32, {}, [](int i, int j) -> glm::vec4 {
    const float x = static_cast<float>(i) / 15.5f - 1;
    const float y = static_cast<float>(j) / 15.5f - 1;
    const float light = std::max(0.1f, 1 - x * x - y * y);
    return {light, light, light, 1};
  }));
  for (int cell = 0; cell < 3; ++cell) {
    State state = unit_of(in_cell(flat_view(), cell, 3, 1), base, TextureEnvMode::replace);
    raster::TextureUnit& second = state.texture_units[1];
    second = state.texture_units[0];
    second.texture = cell == 1 ? glow : f;
    second.env_mode = cell == 1   ? TextureEnvMode::modulate
                      : cell == 2 ? TextureEnvMode::add
                                  : TextureEnvMode::combine;
    second.combine.rgb.function = CombineFunction::interpolate;
    second.combine.rgb.source = {CombineSource::texture, CombineSource::previous, CombineSource::texture};
    second.combine.alpha.function = CombineFunction::replace;
    second.combine.alpha.source[0] = CombineSource::previous;
    stage.draw(state, rectangle(-0.95f, -0.95f, 0.95f, 0.95f));
  }
}

}  // namespace

std::vector<Scene> environment_scenes() {
  return {{"environment_modes", modes},
          {"combine_functions", combine_functions},
          {"combine_operands", combine_operands},
          {"two_units", two_units}};
}

}  // namespace barrido::golden
