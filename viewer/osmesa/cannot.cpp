#include "viewer/osmesa/cannot.h"

#include <algorithm>

#include "viewer/osmesa/gl_state.h"

namespace barrido::osmesa {
namespace {

bool is_textured(const pipeline::State& state) {
  return std::any_of(state.texture_units.begin(), state.texture_units.end(),
                     [](const raster::TextureUnit& unit) { return unit.texture != nullptr; });
}

bool has_unit(const pipeline::State& state, bool (*is_such)(const raster::TextureUnit&)) {
  return std::any_of(state.texture_units.begin(), state.texture_units.end(), is_such);
}

bool has_light(const pipeline::Lighting& lighting, bool (*is_such)(const pipeline::Light&)) {
  return std::any_of(lighting.lights.begin(), lighting.lights.end(), is_such);
}

bool is_soft(const pipeline::Light& light) {
  return light.spot_cutoff_deg != 180.0f && light.spot_outer_cos < light.spot_inner_cos;
}

std::vector<std::pair<bool, const char*>> rules_of(const pipeline::State& state) {
  const pipeline::Lighting& lighting = state.lighting;
  const bool lit = lighting.enabled;
  const pipeline::ShadingMode& mode = pipeline::shading_mode(state.shade_model);
  const bool at_vertices = lit && !mode.lit.at_fragments;
  const bool flat = lit && mode.lit.flat;
  const bool per_fragment = lit && mode.lit.at_fragments;
  const bool is_opengl_model = mode.formula == pipeline::kCourseModel;
  const bool shines_by_map = std::any_of(
      state.texture_units.begin(), state.texture_units.end(), [](const raster::TextureUnit& unit) {
        return unit.texture != nullptr && unit.role == raster::TextureRole::shine;
      });
  return {
      {at_vertices && shines_by_map && lighting.separate_specular, "specularity maps at vertices"},
      {lit && lighting.lights.size() > kGlLights, "lights after the eighth"},
      {lit && has_light(lighting, is_soft), "soft cones of light"},
      {lit && has_light(lighting, [](const pipeline::Light& light) { return light.range > 0.0f; }),
       "lights with a range"},
      {lit && std::max(lighting.front.shininess, lighting.back.shininess) > kGlLargestExponent,
       "shininess over 128"},
      {lit && !is_opengl_model, mode.words},
      {at_vertices && lighting.specular_model == pipeline::SpecularModel::phong,
       "R·V highlights at vertices"},
      {flat && state.flat_at == pipeline::FlatAt::centroid, "flat polygons lit at their centroid"},
      {state.color_interpolation == pipeline::ColorInterpolation::screen, "colours linear on the screen"},
      {has_unit(state,
                [](const raster::TextureUnit& unit) { return unit.tiles != raster::TileChange::none; }),
       "tiles that change"},
      {!per_fragment && has_unit(state,
                                 [](const raster::TextureUnit& unit) {
                                   return unit.procedure != nullptr ||
                                          unit.mapping.surface != raster::MappingSurface::none;
                                 }),
       "procedures and mappings without Phong shading"},
      {is_textured(state) && state.texture_interpolation == pipeline::TextureInterpolation::affine,
       "affine textures"},
      {has_unit(state,
                [](const raster::TextureUnit& unit) {
                  return unit.texture != nullptr && (unit.min_filter == raster::MinFilter::footprint ||
                                                     unit.min_filter == raster::MinFilter::corners);
                }),
       "filters of a pixel's footprint"},
      {state.sorted, "transparency exact in each pixel"},
  };
}

}  // namespace

std::vector<std::string> what_opengl_cannot(const pipeline::AssembledFrame& frame,
                                            const raster::FramebufferOptions& options) {
  std::vector<std::string> cannot;
  if (options.display.srgb_encode) {
    cannot.emplace_back("managed colours (sRGB)");
  } else if (options.format != raster::ColorFormat::rgba8) {
    cannot.emplace_back("exposure and tone maps");
  }
  for (const pipeline::AssembledDraw& draw : frame.draws) {
    for (const auto& [applies, name] : rules_of(draw.state)) {
      if (applies && std::find(cannot.begin(), cannot.end(), name) == cannot.end()) cannot.emplace_back(name);
    }
  }
  return cannot;
}

}  // namespace barrido::osmesa
