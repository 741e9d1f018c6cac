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

/// What modes come to.
inline constexpr ColorOrigin kConstantColor{.name = "constant"};
inline constexpr ColorOrigin kColorsOfVertices{.name = "gouraud", .at_vertices = true};
inline constexpr ColorOrigin kColorOfProvokingVertex{
    .name = "flat-provoking", .flat = true, .at_vertices = true};
inline constexpr ColorOrigin kColorAtCentroid{.name = "flat-centroid", .flat = true, .at_centroid = true};

/// OpenGL's model with the course's choices.
inline constexpr std::string_view kCourseModel =
    "I = ke + ka·Ia + Σ f·Ip·(kd·max(N·L, 0) + ks·({highlight})^n)";

inline constexpr std::size_t kShadingModeCount = 4;

/// In the order of ShadeModel.
inline constexpr std::array<ShadingMode, kShadingModeCount> kShadingModes{{
    {.model = ShadeModel::flat,
     .name = "flat",
     .words = "flat",
     .lit = kColorAtCentroid,
     .unlit = kColorAtCentroid,
     .interpolated = "nothing",
     .at_vertices = "nothing; with --flat-at provoking the model",
     .at_polygon = "the model, at the centroid",
     .at_fragments = "nothing",
     .cost = "one illumination a light and polygon",
     .formula = kCourseModel},
    {.model = ShadeModel::gouraud,
     .name = "gouraud",
     .words = "Gouraud",
     .lit = kColorsOfVertices,
     .unlit = kColorsOfVertices,
     .interpolated = "the lit colour (4, and 3 where highlights are added after the textures)",
     .at_vertices = "the model",
     .at_polygon = "nothing",
     .at_fragments = "nothing",
     .cost = "one illumination a light and vertex; 4 to 7 additions a pixel",
     .formula = kCourseModel},
    {.model = ShadeModel::cheap_phong,
     .name = "cheap-phong",
     .words = "cheap Phong",
     .lit = {.name = "cheap-phong", .at_vertices = true, .at_fragments = true},
     .unlit = kColorsOfVertices,
     .interpolated = "two dot products a light (2 each, and 3 of ambient where lights weaken)",
     .at_vertices = "N·L and N·H or R·V of each light",
     .at_polygon = "nothing",
     .at_fragments = "the model from the interpolated products",
     .cost = "two additions and one power a light and pixel, no square root",
     .formula = kCourseModel},
    {.model = ShadeModel::phong,
     .name = "phong",
     .words = "Phong",
     .lit = {.name = "phong", .at_fragments = true},
     .unlit = kColorsOfVertices,
     .interpolated = "the normal (3; and 3 of position with near lights or a near viewer)",
     .at_vertices = "nothing",
     .at_polygon = "nothing",
     .at_fragments = "the model, with the normal brought to unit length",
     .cost = "3 to 6 additions, a square root and one illumination a light and pixel",
     .formula = kCourseModel},
}};

constexpr const ShadingMode& shading_mode(ShadeModel model) {
  return kShadingModes[static_cast<std::size_t>(model)];
}

}  // namespace barrido::pipeline
