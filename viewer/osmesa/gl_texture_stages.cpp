#include "viewer/osmesa/gl_texture_stages.h"

#include <stdexcept>

#include "viewer/osmesa/gl_procedures.h"
#include "viewer/osmesa/gl_state.h"

namespace barrido::osmesa {
namespace {

using raster::CombineChannel;
using raster::CombineFunction;
using raster::CombineOperand;
using raster::CombineSource;

bool is_reflected(const pipeline::TextureCoordinates& coordinates) {
  const auto& rules = coordinates.generation;
  const bool none = !rules[0].enabled && !rules[1].enabled && !rules[2].enabled && !rules[3].enabled;
  if (none) return false;
  for (std::size_t c = 0; c < 3; ++c) {
    if (!rules[c].enabled || rules[c].mode != pipeline::TexGenMode::reflection_map) {
      throw std::runtime_error("the reference programs know no generated coordinates but reflection maps");
    }
  }
  return true;
}

std::string source_of(CombineSource source, const std::string& unit) {
  switch (source) {
    case CombineSource::texture:
      return "t" + unit;
    case CombineSource::constant:
      return "gl_TextureEnvColor[" + unit + "]";
    case CombineSource::primary:
      return "first";
    case CombineSource::previous:
      return "c";
  }
  return "c";
}

/// An argument of a combination, as a vec3 or, for the alpha, a float.
std::string argument(const CombineChannel& channel, std::size_t i, const std::string& unit, bool alpha) {
  const std::string from = source_of(channel.source[i], unit);
  const CombineOperand operand = channel.operand[i];
  const bool inverted =
      operand == CombineOperand::one_minus_color || operand == CombineOperand::one_minus_alpha;
  const bool of_color = operand == CombineOperand::color || operand == CombineOperand::one_minus_color;
  std::string value = from + (alpha ? ".a" : ".rgb");
  if (!alpha && !of_color) value = "vec3(" + from + ".a)";
  return inverted ? "(1.0 - " + value + ")" : value;
}

std::string combined(const CombineChannel& channel, const std::string& unit, bool alpha) {
  const std::string a = argument(channel, 0, unit, alpha);
  const std::string b = argument(channel, 1, unit, alpha);
  const std::string scale = " * " + std::to_string(channel.scale);
  switch (channel.function) {
    case CombineFunction::replace:
      return "(" + a + ")" + scale;
    case CombineFunction::modulate:
      return "(" + a + " * " + b + ")" + scale;
    case CombineFunction::add:
      return "(" + a + " + " + b + ")" + scale;
    case CombineFunction::add_signed:
      return "(" + a + " + " + b + " - 0.5)" + scale;
    case CombineFunction::interpolate: {
      const std::string weight = argument(channel, 2, unit, alpha);
      return "(" + a + " * " + weight + " + " + b + " * (1.0 - " + weight + "))" + scale;
    }
    case CombineFunction::subtract:
      return "(" + a + " - " + b + ")" + scale;
    case CombineFunction::dot3_rgb:
    case CombineFunction::dot3_rgba:
      return "vec3(4.0 * dot(" + a + " - 0.5, " + b + " - 0.5))" + scale;
  }
  return a;
}

std::string combined_alpha(const raster::CombineState& combine, const std::string& unit) {
  if (combine.rgb.function != CombineFunction::dot3_rgba) return combined(combine.alpha, unit, true);
  CombineChannel product = combine.rgb;
  product.scale = combine.alpha.scale;
  return "(" + combined(product, unit, false) + ").r";
}

/// A statement that turns c, the colour so far, into that after the unit.
std::string environment(const raster::TextureUnit& unit, const std::string& index) {
  const std::string texel = "t" + index;
  switch (unit.env_mode) {
    case raster::TextureEnvMode::modulate:
      return "c *= " + texel + ";\n";
    case raster::TextureEnvMode::replace:
      return "c = " + texel + ";\n";
    case raster::TextureEnvMode::add:
      return "c = vec4(min(c.rgb + " + texel + ".rgb, 1.0), c.a * " + texel + ".a);\n";
    case raster::TextureEnvMode::combine:
      return "c = clamp(vec4(" + combined(unit.combine.rgb, index, false) + ", " +
             combined_alpha(unit.combine, index) + "), 0.0, 1.0);\n";
    default:
      throw std::runtime_error("the reference programs do not know the texture environments decal and blend");
  }
}

bool is_on(const raster::TextureUnit& unit) { return unit.texture != nullptr || unit.procedure != nullptr; }

bool is_textured(const pipeline::State& state) {
  for (const raster::TextureUnit& unit : state.texture_units) {
    if (is_on(unit)) return true;
  }
  return false;
}

}  // namespace

std::string vertex_texture_stages(const pipeline::State& state) {
  std::string text = "void make_texture_coordinates(vec3 n, vec3 p) {\n";
  for (std::size_t i = 0; i < state.texture_units.size(); ++i) {
    if (!is_on(state.texture_units[i])) continue;
    const std::string unit = std::to_string(i);
    const std::string given = is_reflected(state.texture_coordinates[i])
                                  ? std::string("vec4(reflect(normalize(p), n), 1.0)")
                                  : "gl_MultiTexCoord" + unit;
    text += "  gl_TexCoord[" + unit + "] = gl_TextureMatrix[" + unit + "] * " + given + ";\n";
  }
  return text + "}\n";
}

std::string fragment_texture_stages(const pipeline::State& state) {
  std::string samplers, functions, fetches, stages;
  for (std::size_t i = 0; i < state.texture_units.size(); ++i) {
    const raster::TextureUnit& unit = state.texture_units[i];
    const bool is_shine = unit.role == raster::TextureRole::shine;
    if (!is_on(unit) || !(is_shine || unit.role == raster::TextureRole::environment)) continue;
    const std::string index = std::to_string(i);
    const std::string at = "gl_TexCoord[" + index + "]";
    functions += procedure_functions(unit, index);
    stages += "  " + (is_shine ? "secondary *= t" + index + ".rgb;\n" : environment(unit, index));
    if (unit.procedure != nullptr) {
      fetches += "  vec4 t" + index + " = " + procedure_texel(unit, index, at + ".xyz") + ";\n";
      continue;
    }
    const bool cube = unit.texture->is_cube();
    samplers += std::string("uniform ") + (cube ? "samplerCube" : "sampler2D") + " tex" + index + ";\n";
    const bool is_mapped = unit.mapping.surface != raster::MappingSurface::none;
    const std::string place = is_mapped ? mapped_place(index, at + ".xyz") : at + (cube ? ".xyz" : "");
    fetches += "  vec4 t" + index + " = " +
               (cube        ? "textureCube"
                : is_mapped ? "texture2D"
                            : "texture2DProj") +
               "(tex" + index + ", " + place + ");\n";
  }
  const bool separate = state.lighting.separate_specular && is_textured(state);
  return samplers + functions + "vec4 finish(vec4 primary, vec3 secondary) {\n" +
         (separate ? "  vec4 c = clamp(primary, 0.0, 1.0);\n  secondary = clamp(secondary, 0.0, 1.0);\n"
                   : "  vec4 c = clamp(vec4(primary.rgb + secondary, primary.a), 0.0, 1.0);\n") +
         "  vec4 first = c;\n" + fetches + stages +
         (separate ? "  c.rgb = clamp(c.rgb + secondary, 0.0, 1.0);\n" : "") + "  return c;\n}\n";
}

void set_samplers(unsigned program, const pipeline::State& state) {
  for (std::size_t i = 0; i < state.texture_units.size(); ++i) {
    if (state.texture_units[i].texture == nullptr) continue;
    gl().Uniform1i(gl().GetUniformLocation(program, ("tex" + std::to_string(i)).c_str()),
                   static_cast<GLint>(i));
  }
}

}  // namespace barrido::osmesa
