#include "viewer/osmesa/gl_map_stages.h"

#include <algorithm>
#include <stdexcept>

#include "viewer/osmesa/gl_state.h"

namespace barrido::osmesa {
namespace {

using raster::TextureRole;

constexpr std::size_t kTangentUnit = 6, kBitangentUnit = 7;

bool tilts(const raster::TextureUnit& unit) {
  return unit.texture != nullptr && (unit.role == TextureRole::normal || unit.role == TextureRole::bump);
}

bool has_tangents(const pipeline::State& state) {
  return std::any_of(state.texture_units.begin(), state.texture_units.end(), tilts);
}

/// texture2DProj at the unit's coordinates, moved.
std::string texel(std::size_t unit, const std::string& shift = "") {
  const std::string index = std::to_string(unit);
  const std::string at = "gl_TexCoord[" + index + "]";
  return "texture2D(tex" + index + ", " + at + ".st / " + at + ".q" + shift + ")";
}

std::string number(float value) { return "float(" + std::to_string(value) + ")"; }

std::string normal_map(std::size_t i, const raster::TextureUnit& unit) {
  return "  vec3 t = 2.0 * " + texel(i) + ".rgb - 1.0;\n  t.xy *= " + number(unit.strength) +
         ";\n  return t.x * tangent + t.y * bitangent + t.z * n;\n";
}

std::string bump_map(std::size_t i, const raster::TextureUnit& unit) {
  const auto slope = [&](int side, const char* direction) {
    const std::string step = "vec2(" + std::string(direction) + ") / " + number(static_cast<float>(side));
    const auto height = [&](const char* sign) {
      return "dot(" + texel(i, " " + std::string(sign) + " " + step) + ".rgb, vec3(1.0 / 3.0))";
    };
    return "(" + height("+") + " - " + height("-") + ") * " +
           number(unit.strength * static_cast<float>(side) * 0.5f);
  };
  const bool blinn = unit.bump_form == raster::BumpForm::blinn;
  return "  n = normalize(n);\n  float fu = " + slope(unit.texture->width(), "1.0, 0.0") +
         ";\n  float fv = " + slope(unit.texture->height(), "0.0, 1.0") +
         ";\n  vec3 d = cross(n, bitangent) * fu - cross(n, tangent) * fv;\n"
         "  float area = dot(cross(tangent, bitangent), n);\n  if (area < 0.0) d = -d;\n" +
         (blinn ? "  return n * abs(area) + d;\n"
                : "  return dot(d, d) > 0.0 ? n + normalize(d) * length(vec2(fu, fv)) : n;\n");
}

}  // namespace

std::string vertex_map_stages(const pipeline::State& state) {
  if (!has_tangents(state)) return "void make_tangents() {}\n";
  const bool to_unit = std::any_of(state.texture_units.begin(), state.texture_units.end(),
                                   [](const raster::TextureUnit& unit) {
                                     return unit.texture != nullptr && unit.role == TextureRole::normal;
                                   });
  const std::string end = to_unit ? "normalize(v)" : "v";
  return "varying vec3 tangent; varying vec3 bitangent;\n"
         "vec3 to_eye(vec3 t) { vec3 v = mat3(gl_ModelViewMatrix) * t; return " +
         end +
         "; }\n"
         "void make_tangents() {\n"
         "  vec3 b = gl_MultiTexCoord7.xyz;\n"
         "  if (b == vec3(0.0)) b = cross(gl_Normal, gl_MultiTexCoord6.xyz) * gl_MultiTexCoord6.w;\n"
         "  tangent = to_eye(gl_MultiTexCoord6.xyz);\n  bitangent = to_eye(b);\n}\n";
}

std::string fragment_map_stages(const pipeline::State& state) {
  std::string samplers, mapped = "  return n;\n", unoccluded = "  return 1.0;\n";
  for (std::size_t i = 0; i < state.texture_units.size(); ++i) {
    const raster::TextureUnit& unit = state.texture_units[i];
    const bool is_map = tilts(unit) || unit.role == TextureRole::occlusion;
    if (is_map && unit.procedure != nullptr) {
      throw std::runtime_error("the reference programs know no maps by procedures");
    }
    if (unit.texture == nullptr) continue;
    if (is_map) samplers += "uniform sampler2D tex" + std::to_string(i) + ";\n";
    if (unit.role == TextureRole::normal) mapped = normal_map(i, unit);
    if (unit.role == TextureRole::bump) mapped = bump_map(i, unit);
    if (unit.role == TextureRole::occlusion) {
      unoccluded = "  return 1.0 + " + number(unit.strength) + " * (" + texel(i) + ".r - 1.0);\n";
    }
  }
  const std::string varyings = has_tangents(state) ? "varying vec3 tangent; varying vec3 bitangent;\n" : "";
  return samplers + varyings + "vec3 mapped(vec3 n) {\n" + mapped + "}\nfloat unoccluded() {\n" + unoccluded +
         "}\n";
}

void set_tangents(const pipeline::State& state, const pipeline::Geometry& geometry) {
  if (!has_tangents(state) || geometry.tangent.data == nullptr) return;
  for (const std::size_t unit : {kTangentUnit, kBitangentUnit}) {
    if (state.texture_units[unit].texture != nullptr) {
      throw std::runtime_error("texture units 6 and 7 carry tangents in the reference");
    }
  }
  const auto set = [](std::size_t unit, const pipeline::Attribute& attribute) {
    const GLenum name = GL_TEXTURE0 + static_cast<GLenum>(unit);
    gl().ClientActiveTexture(name);
    if (attribute.data == nullptr) {
      constexpr GLfloat kNone[4] = {0, 0, 0, 0};
      gl().DisableClientState(GL_TEXTURE_COORD_ARRAY);
      gl().MultiTexCoord4fv(name, kNone);
      return;
    }
    gl().EnableClientState(GL_TEXTURE_COORD_ARRAY);
    gl().TexCoordPointer(attribute.components, GL_FLOAT, attribute.stride * static_cast<int>(sizeof(float)),
                         attribute.data);
  };
  set(kTangentUnit, geometry.tangent);
  set(kBitangentUnit, geometry.bitangent);
}

}  // namespace barrido::osmesa
