#include "pipeline/inspect/story_words.h"

#include <cstdio>

namespace barrido::inspect {
namespace {

template <std::size_t Count, class Enum>
std::string_view pick(const std::array<std::string_view, Count>& names, Enum value) {
  return names.at(static_cast<std::size_t>(value));
}

}  // namespace

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof(text), "%.6g", value);
  return text;
}

std::string tuple(std::span<const float> values) {
  std::string text = "(";
  for (std::size_t i = 0; i < values.size(); ++i) text += (i > 0 ? ", " : "") + number(values[i]);
  return text + ")";
}

std::string tuple(const glm::vec3& v) {
  const float values[3] = {v.x, v.y, v.z};
  return tuple(values);
}

std::string_view name_of(Fate fate) {
  return pick(std::array<std::string_view, 5>{"visible", "covered", "hidden", "cut-out", "scissored"}, fate);
}

std::string_view name_of(pipeline::ShadeModel model) {
  return pick(std::array<std::string_view, 4>{"flat", "gouraud", "cheap-phong", "phong"}, model);
}

std::string_view name_of(pipeline::Shading shading) {
  return pick(std::array<std::string_view, 6>{"constant", "gouraud", "flat-provoking", "flat-centroid",
                                              "cheap-phong", "phong"},
              shading);
}

std::string_view name_of(pipeline::SpecularModel model) {
  return pick(std::array<std::string_view, 2>{"blinn", "phong"}, model);
}

std::string_view name_of(raster::Topology topology) {
  return pick(std::array<std::string_view, 3>{"point", "line", "triangle"}, topology);
}

std::string_view name_of(raster::MinFilter filter) {
  return pick(
      std::array<std::string_view, 6>{"nearest", "linear", "nearest-mipmap-nearest", "linear-mipmap-nearest",
                                      "nearest-mipmap-linear", "linear-mipmap-linear"},
      filter);
}

std::string_view name_of(raster::MagFilter filter) {
  return pick(std::array<std::string_view, 2>{"nearest", "linear"}, filter);
}

std::string_view name_of(raster::TextureEnvMode mode) {
  return pick(std::array<std::string_view, 6>{"modulate", "replace", "add", "decal", "blend", "combine"},
              mode);
}

std::string_view name_of(raster::CombineFunction function) {
  return pick(
      std::array<std::string_view, 6>{"replace", "modulate", "add", "add-signed", "interpolate", "subtract"},
      function);
}

std::string_view name_of(raster::CombineSource source) {
  return pick(std::array<std::string_view, 4>{"texture", "constant", "primary", "previous"}, source);
}

std::string_view name_of(raster::CombineOperand operand) {
  return pick(std::array<std::string_view, 4>{"color", "one-minus-color", "alpha", "one-minus-alpha"},
              operand);
}

std::string_view name_of(raster::FogMode mode) {
  return pick(std::array<std::string_view, 3>{"linear", "exp", "exp2"}, mode);
}

std::string_view name_of(raster::BlendFactor factor) {
  return pick(
      std::array<std::string_view, 15>{"zero", "one", "src-color", "one-minus-src-color", "dst-color",
                                       "one-minus-dst-color", "src-alpha", "one-minus-src-alpha", "dst-alpha",
                                       "one-minus-dst-alpha", "constant-color", "one-minus-constant-color",
                                       "constant-alpha", "one-minus-constant-alpha", "src-alpha-saturate"},
      factor);
}

std::string_view name_of(raster::BlendEquation equation) {
  return pick(std::array<std::string_view, 5>{"add", "subtract", "reverse-subtract", "min", "max"}, equation);
}

std::string_view name_of(raster::ToneMap map) {
  return pick(std::array<std::string_view, 2>{"clamp", "reinhard"}, map);
}

std::string_view sign_of(raster::Compare compare) {
  return pick(std::array<std::string_view, 8>{"never", "<", "=", "<=", ">", "!=", ">=", "always"}, compare);
}

std::string_view name_of_face(int face) {
  return pick(std::array<std::string_view, 6>{"+X", "-X", "+Y", "-Y", "+Z", "-Z"}, face);
}

}  // namespace barrido::inspect
