#include "pipeline/layout.h"

#include "pipeline/cheap_phong.h"

namespace barrido::pipeline {
namespace {

using raster::TexcoordKind;

/// Row 3 of the matrix is (0, 0, 0, 1).
bool keeps_w(const glm::mat4& m) {
  return m[0][3] == 0.0f && m[1][3] == 0.0f && m[2][3] == 0.0f && m[3][3] == 1.0f;
}

bool may_need_division(const TextureCoordinates& coordinates, const Attribute& array,
                       const glm::vec4& constant) {
  if (coordinates.generation[3].enabled || !keeps_w(coordinates.matrix)) return true;
  return array.data != nullptr ? array.components == 4 : constant.w != 1.0f;
}

TexcoordKind texcoord_kind(const State& state, const Geometry& geometry, std::size_t unit) {
  if (state.texture_units[unit].texture->is_cube()) return TexcoordKind::cube;
  return may_need_division(state.texture_coordinates[unit], geometry.texcoord[unit],
                           geometry.constant_texcoord[unit])
             ? TexcoordKind::projective
             : TexcoordKind::plain;
}

constexpr int floats_of(TexcoordKind kind) { return kind == TexcoordKind::plain ? 2 : 3; }

}  // namespace

VaryingNeeds varying_needs(const State& state, const Geometry& geometry, const ColorOrigin& origin,
                           const Illumination* illumination) {
  VaryingNeeds needs;
  const bool interpolates_colors = origin.makes_vertex_colors() && !origin.flat;
  needs.color = interpolates_colors || (origin.at_fragments && illumination->tracks_color);
  needs.specular = interpolates_colors && illumination != nullptr && illumination->separate_specular;
  needs.normal = origin.at_fragments && !origin.at_vertices;
  needs.eye_position = needs.normal && illumination->needs_position;
  needs.dots = origin.makes_vertex_products() ? cheap_phong_varyings(*illumination) : 0;
  needs.fog = state.fog.enabled;
  for (std::size_t unit = 0; unit < state.texture_units.size(); ++unit) {
    if (state.texture_units[unit].texture != nullptr) {
      needs.texcoord[unit] = texcoord_kind(state, geometry, unit);
    }
  }
  needs.colors_affine = state.color_interpolation == ColorInterpolation::screen;
  needs.texcoords_affine = state.texture_interpolation == TextureInterpolation::affine;
  needs.all_affine = has_unit_w(state, geometry);
  return needs;
}

raster::VaryingLayout make_layout(const VaryingNeeds& needs) {
  raster::VaryingLayout layout;
  const auto place = [&layout](int& offset, int floats) {
    if (floats > 0) offset = layout.count;
    layout.count += floats;
  };
  const auto place_colors = [&] {
    place(layout.color, needs.color ? 4 : 0);
    place(layout.specular, needs.specular ? 3 : 0);
    place(layout.normal, needs.normal ? 3 : 0);
    place(layout.eye_position, needs.eye_position ? 3 : 0);
    place(layout.dots, needs.dots);
  };
  const auto place_texcoords = [&] {
    for (std::size_t unit = 0; unit < needs.texcoord.size(); ++unit) {
      if (!needs.texcoord[unit]) continue;
      layout.texcoord_kind[unit] = *needs.texcoord[unit];
      place(layout.texcoord[unit], floats_of(*needs.texcoord[unit]));
    }
  };
  if (needs.colors_affine) place_colors();
  if (needs.texcoords_affine) place_texcoords();
  layout.affine_count = layout.count;
  if (!needs.colors_affine) place_colors();
  if (!needs.texcoords_affine) place_texcoords();
  place(layout.fog, needs.fog ? 1 : 0);
  if (needs.all_affine) layout.affine_count = layout.count;
  return layout;
}

bool has_unit_w(const State& state, const Geometry& geometry) {
  return geometry.position.components < 4 && keeps_w(state.eye_from_object) && keeps_w(state.clip_from_eye);
}

}  // namespace barrido::pipeline
