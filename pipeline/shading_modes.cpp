#include "pipeline/shading_modes.h"

#include "pipeline/state.h"

namespace barrido::pipeline {
namespace {

constexpr ColorOrigin kConstant{.name = "constant"};
constexpr ColorOrigin kVertices{.name = "gouraud", .at_vertices = true};
constexpr ColorOrigin kProvokingVertex{.name = "flat-provoking", .flat = true, .at_vertices = true};
constexpr ColorOrigin kCentroid{.name = "flat-centroid", .flat = true, .at_centroid = true};

constexpr std::string_view kModel = "I = ke + ka·Ia + Σ f·Ip·(kd·max(N·L, 0) + ks·({highlight})^n)";

}  // namespace

constexpr std::array<ShadingMode, kShadingModeCount> kShadingModes{{
    {.model = ShadeModel::flat,
     .name = "flat",
     .words = "flat",
     .lit = kCentroid,
     .unlit = kCentroid,
     .interpolated = "nothing",
     .at_vertices = "nothing; with --flat-at provoking the model",
     .at_polygon = "the model, at the centroid",
     .at_fragments = "nothing",
     .cost = "one illumination a light and polygon",
     .formula = kModel},
    {.model = ShadeModel::gouraud,
     .name = "gouraud",
     .words = "Gouraud",
     .lit = kVertices,
     .unlit = kVertices,
     .interpolated = "the lit colour (4, and 3 where highlights are added after the textures)",
     .at_vertices = "the model",
     .at_polygon = "nothing",
     .at_fragments = "nothing",
     .cost = "one illumination a light and vertex; 4 to 7 additions a pixel",
     .formula = kModel},
    {.model = ShadeModel::cheap_phong,
     .name = "cheap-phong",
     .words = "cheap Phong",
     .lit = {.name = "cheap-phong", .at_vertices = true, .at_fragments = true},
     .unlit = kVertices,
     .interpolated = "two dot products a light (2 each, and 3 of ambient where lights weaken)",
     .at_vertices = "N·L and N·H or R·V of each light",
     .at_polygon = "nothing",
     .at_fragments = "the model from the interpolated products",
     .cost = "two additions and one power a light and pixel, no square root",
     .formula = kModel},
    {.model = ShadeModel::phong,
     .name = "phong",
     .words = "Phong",
     .lit = {.name = "phong", .at_fragments = true},
     .unlit = kVertices,
     .interpolated = "the normal (3; and 3 of position with near lights or a near viewer)",
     .at_vertices = "nothing",
     .at_polygon = "nothing",
     .at_fragments = "the model, with the normal brought to unit length",
     .cost = "3 to 6 additions, a square root and one illumination a light and pixel",
     .formula = kModel},
}};

ColorOrigin color_origin(const State& state, bool lit, bool has_colors) {
  if (!lit && !has_colors) return kConstant;
  const ShadingMode& mode = shading_mode(state.shade_model);
  const ColorOrigin& origin = lit ? mode.lit : mode.unlit;
  return origin.at_centroid && state.flat_at == FlatAt::provoking_vertex ? kProvokingVertex : origin;
}

}  // namespace barrido::pipeline
