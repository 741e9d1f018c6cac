#include "raster/reference/texture_environment.h"

namespace barrido::raster::reference {
namespace {

constexpr std::size_t kAlpha = 3;

const Color& source_color(CombineSource source, const TextureUnit& unit, const UnitInputs& inputs) {
  switch (source) {
    case CombineSource::texture:
      return inputs.texture;
    case CombineSource::constant:
      return unit.env_color;
    case CombineSource::primary:
      return inputs.primary;
    case CombineSource::previous:
      break;
  }
  return inputs.previous;
}

float operand_value(CombineOperand operand, const Color& color, std::size_t channel) {
  switch (operand) {
    case CombineOperand::color:
      return color[channel];
    case CombineOperand::one_minus_color:
      return 1.0f - color[channel];
    case CombineOperand::alpha:
      return color[kAlpha];
    case CombineOperand::one_minus_alpha:
      break;
  }
  return 1.0f - color[kAlpha];
}

float combine(const CombineChannel& how, const TextureUnit& unit, const UnitInputs& inputs,
              std::size_t channel) {
  float a[3];
  for (std::size_t k = 0; k < 3; ++k) {
    a[k] = operand_value(how.operand[k], source_color(how.source[k], unit, inputs), channel);
  }
  float value = 0.0f;
  switch (how.function) {
    case CombineFunction::replace:
      value = a[0];
      break;
    case CombineFunction::modulate:
      value = a[0] * a[1];
      break;
    case CombineFunction::add:
      value = a[0] + a[1];
      break;
    case CombineFunction::add_signed:
      value = (a[0] + a[1]) - 0.5f;
      break;
    case CombineFunction::interpolate:
      value = a[0] * a[2] + a[1] * (1.0f - a[2]);
      break;
    case CombineFunction::subtract:
      value = a[0] - a[1];
      break;
    case CombineFunction::dot3_rgb:  // see combine_all
    case CombineFunction::dot3_rgba:
      break;
  }
  return value * how.scale;
}

/// 4 Σ (a − ½)(b − ½) (OpenGL 1.3, table 3.24).
float dot3(const CombineChannel& how, const TextureUnit& unit, const UnitInputs& inputs) {
  const auto product = [&](std::size_t channel) {
    const auto argument = [&](std::size_t k) {
      return operand_value(how.operand[k], source_color(how.source[k], unit, inputs), channel);
    };
    return (argument(0) - 0.5f) * (argument(1) - 0.5f);
  };
  return ((product(0) + product(1)) + product(2)) * 4.0f;
}

Color combine_all(const TextureUnit& unit, const UnitInputs& inputs) {
  const CombineChannel &rgb = unit.combine.rgb, &alpha = unit.combine.alpha;
  const bool to_alpha = rgb.function == CombineFunction::dot3_rgba;
  if (to_alpha || rgb.function == CombineFunction::dot3_rgb) {
    const float value = dot3(rgb, unit, inputs);
    const float color = value * rgb.scale;
    return {color, color, color, to_alpha ? value * alpha.scale : combine(alpha, unit, inputs, kAlpha)};
  }
  Color result{};
  for (std::size_t c = 0; c < kAlpha; ++c) result[c] = combine(rgb, unit, inputs, c);
  result[kAlpha] = combine(alpha, unit, inputs, kAlpha);
  return result;
}

/// One colour channel of the modes with a fixed formula: cp previous, ct texture, cc constant.
float fixed_color(TextureEnvMode mode, float cp, float ct, float at, float cc) {
  switch (mode) {
    case TextureEnvMode::replace:
      return ct;
    case TextureEnvMode::add:
      return cp + ct;
    case TextureEnvMode::decal:
      return cp * (1.0f - at) + ct * at;
    case TextureEnvMode::blend:
      return cp * (1.0f - ct) + cc * ct;
    case TextureEnvMode::modulate:
    case TextureEnvMode::combine:
      break;
  }
  return cp * ct;
}

float fixed_alpha(TextureEnvMode mode, float ap, float at) {
  if (mode == TextureEnvMode::replace) return at;
  if (mode == TextureEnvMode::decal) return ap;
  return ap * at;
}

}  // namespace

Color apply_texture_environment(const TextureUnit& unit, const UnitInputs& inputs) {
  if (unit.env_mode == TextureEnvMode::combine) return combine_all(unit, inputs);
  Color result{};
  for (std::size_t c = 0; c < kAlpha; ++c) {
    result[c] = fixed_color(unit.env_mode, inputs.previous[c], inputs.texture[c], inputs.texture[kAlpha],
                            unit.env_color[c]);
  }
  result[kAlpha] = fixed_alpha(unit.env_mode, inputs.previous[kAlpha], inputs.texture[kAlpha]);
  return result;
}

}  // namespace barrido::raster::reference
