// Literal tables for the texture environment: OpenGL 1.3, tables 3.22 and 3.23 (RGBA textures), and the
// combine functions, sources and operands.
#include "raster/reference/texture_environment.h"

#include <gtest/gtest.h>

namespace barrido::raster::reference {
namespace {

// Exact in float, so that the expected values can be written down.
constexpr Color kTexture{0.5f, 0.25f, 1.0f, 0.75f};
constexpr Color kPrimary{0.125f, 1.0f, 0.0f, 0.5f};
constexpr Color kPrevious{0.5f, 0.5f, 0.25f, 0.25f};
constexpr Color kEnvironment{1.0f, 0.0f, 0.5f, 0.375f};
constexpr UnitInputs kInputs{kTexture, kPrimary, kPrevious};

TEST(TextureEnvironment, FixedModes) {
  const struct {
    TextureEnvMode mode;
    Color expected;
  } table[] = {
      {TextureEnvMode::modulate, {0.25f, 0.125f, 0.25f, 0.1875f}},
      {TextureEnvMode::replace, {0.5f, 0.25f, 1.0f, 0.75f}},
      {TextureEnvMode::add, {1.0f, 0.75f, 1.25f, 0.1875f}},
      {TextureEnvMode::decal, {0.5f, 0.3125f, 0.8125f, 0.25f}},
      {TextureEnvMode::blend, {0.75f, 0.375f, 0.5f, 0.1875f}},
  };
  for (const auto& row : table) {
    TextureUnit unit;
    unit.env_mode = row.mode;
    unit.env_color = kEnvironment;
    EXPECT_EQ(apply_texture_environment(unit, kInputs), row.expected) << static_cast<int>(row.mode);
  }
}

TextureUnit combine_unit(CombineFunction function) {
  TextureUnit unit;
  unit.env_mode = TextureEnvMode::combine;
  unit.env_color = kEnvironment;
  for (CombineChannel* channel : {&unit.combine.rgb, &unit.combine.alpha}) {
    channel->function = function;
    channel->source = {CombineSource::texture, CombineSource::previous, CombineSource::constant};
  }
  unit.combine.rgb.operand = {CombineOperand::color, CombineOperand::color, CombineOperand::color};
  return unit;
}

TEST(TextureEnvironment, CombineFunctions) {
  const struct {
    CombineFunction function;
    Color expected;
  } table[] = {
      {CombineFunction::replace, {0.5f, 0.25f, 1.0f, 0.75f}},
      {CombineFunction::modulate, {0.25f, 0.125f, 0.25f, 0.1875f}},
      {CombineFunction::add, {1.0f, 0.75f, 1.25f, 1.0f}},
      {CombineFunction::add_signed, {0.5f, 0.25f, 0.75f, 0.5f}},
      {CombineFunction::interpolate, {0.5f, 0.5f, 0.625f, 0.4375f}},
      {CombineFunction::subtract, {0.0f, -0.25f, 0.75f, 0.5f}},
  };
  for (const auto& row : table) {
    TextureUnit unit = combine_unit(row.function);
    EXPECT_EQ(apply_texture_environment(unit, kInputs), row.expected) << static_cast<int>(row.function);
    unit.combine.rgb.scale = 4.0f;
    unit.combine.alpha.scale = 2.0f;
    const Color& e = row.expected;
    EXPECT_EQ(apply_texture_environment(unit, kInputs), (Color{e[0] * 4, e[1] * 4, e[2] * 4, e[3] * 2}));
  }
}

TEST(TextureEnvironment, CombineSourcesAndOperands) {
  const struct {
    CombineSource source;
    Color color;
  } sources[] = {{CombineSource::texture, kTexture},
                 {CombineSource::constant, kEnvironment},
                 {CombineSource::primary, kPrimary},
                 {CombineSource::previous, kPrevious}};
  for (const auto& [source, color] : sources) {
    const float a = color[3];
    const struct {
      CombineOperand operand;
      Color expected;
    } operands[] = {{CombineOperand::color, color},
                    {CombineOperand::one_minus_color, {1 - color[0], 1 - color[1], 1 - color[2], 1 - a}},
                    {CombineOperand::alpha, {a, a, a, a}},
                    {CombineOperand::one_minus_alpha, {1 - a, 1 - a, 1 - a, 1 - a}}};
    for (const auto& [operand, expected] : operands) {
      TextureUnit unit = combine_unit(CombineFunction::replace);
      unit.combine.rgb.source[0] = unit.combine.alpha.source[0] = source;
      unit.combine.rgb.operand[0] = unit.combine.alpha.operand[0] = operand;
      EXPECT_EQ(apply_texture_environment(unit, kInputs), expected)
          << static_cast<int>(source) << " " << static_cast<int>(operand);
    }
  }
}

}  // namespace
}  // namespace barrido::raster::reference
