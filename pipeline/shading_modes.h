// The shading modes in one table (course S1, S4, S6, S7): what each is called, where it evaluates the
// illumination model, what is interpolated, and what it costs. Whoever draws, counts or explains asks the
// table; so a mode is added by a row.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace barrido::pipeline {

/// How the illumination model is spread over a polygon, as a State asks for it.
enum class ShadeModel : std::uint8_t { flat, gouraud, cheap_phong, phong };

/// Where the colours of one draw's primitives are made: what a mode comes to, lighting being on or off.
struct ColorOrigin {
  std::string_view name;      ///< In stories.
  bool flat = false;          ///< One colour a polygon; none is interpolated.
  bool at_vertices = false;   ///< The model, or its dot products, are evaluated at every vertex.
  bool at_centroid = false;   ///< The model is evaluated at the middle of each polygon.
  bool at_fragments = false;  ///< The model is evaluated, or completed, at every fragment.

  constexpr bool makes_vertex_colors() const { return at_vertices && !at_fragments; }
  constexpr bool makes_vertex_products() const { return at_vertices && at_fragments; }
};

struct ShadingMode {
  ShadeModel model;
  std::string_view name;   ///< On the command line, in reports and file names.
  const char* words;       ///< For people.
  ColorOrigin lit, unlit;  ///< With lighting; and without, where vertices have colours.

  // The course's comparison (S8), in words; docs/shading.md shows it.
  std::string_view interpolated;
  std::string_view at_vertices;
  std::string_view at_polygon;
  std::string_view at_fragments;
  std::string_view cost;
  /// The model as `inspect` tells it; {highlight} is N·H or R·V.
  std::string_view formula;
};

inline constexpr std::size_t kShadingModeCount = 4;

/// In the order of ShadeModel.
extern const std::array<ShadingMode, kShadingModeCount> kShadingModes;

inline const ShadingMode& shading_mode(ShadeModel model) {
  return kShadingModes[static_cast<std::size_t>(model)];
}

struct State;

/// `lit`: lighting is on. `has_colors`: the vertices have colours of their own.
ColorOrigin color_origin(const State& state, bool lit, bool has_colors);

}  // namespace barrido::pipeline
