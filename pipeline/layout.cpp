#include "pipeline/layout.h"

#include <array>

namespace barrido::pipeline {
namespace {

using raster::Meaning;
using raster::TexcoordKind;
using raster::Varying;

/// Row 3 of the matrix is (0, 0, 0, 1).
bool keeps_w(const glm::mat4& m) {
  return m[0][3] == 0.0f && m[1][3] == 0.0f && m[2][3] == 0.0f && m[3][3] == 1.0f;
}

bool may_need_division(const TextureCoordinates& coordinates, const Attribute& array,
                       const glm::vec4& constant) {
  if (coordinates.generation[3].enabled || !keeps_w(coordinates.matrix)) return true;
  return array.data != nullptr ? array.components == 4 : constant.w != 1.0f;
}

/// Whether the state asks for the meaning to be linear on the screen.
bool is_affine(const State& state, Meaning meaning) {
  if (meaning == Meaning::texcoord) return state.texture_interpolation == TextureInterpolation::affine;
  return meaning < Meaning::texcoord && state.color_interpolation == ColorInterpolation::screen;
}

/// Whatever the stages read of a meaning, once; in the order of the units.
template <class Visit>
void for_each_read(std::span<const raster::FragmentStage> stages, Meaning meaning, const Visit& visit) {
  for (int unit = 0; unit < raster::kMaxTextureUnits; ++unit) {
    Varying found{meaning, 0, unit};
    for (const raster::FragmentStage& stage : stages) {
      for (const Varying& read : stage.reads) {
        if (read.meaning == meaning && read.unit == unit && read.floats > found.floats) found = read;
      }
    }
    if (found.floats > 0) visit(found);
  }
}

}  // namespace

ColorOrigin color_origin(const State& state, bool lit, bool has_colors) {
  if (!lit && !has_colors) return kConstantColor;
  const ShadingMode& mode = shading_mode(state.shade_model);
  const ColorOrigin& origin = lit ? mode.lit : mode.unlit;
  return origin.at_centroid && state.flat_at == FlatAt::provoking_vertex ? kColorOfProvokingVertex : origin;
}

TexcoordKind texcoord_kind(const State& state, const Geometry& geometry, std::size_t unit) {
  const raster::TextureUnit& u = state.texture_units[unit];
  if (u.mapping.surface != raster::MappingSurface::none) return TexcoordKind::direct;
  if (u.procedure != nullptr)
    return u.procedure->coordinates == 2 ? TexcoordKind::plain : TexcoordKind::direct;
  if (u.texture->is_cube()) return TexcoordKind::direct;
  return may_need_division(state.texture_coordinates[unit], geometry.texcoord[unit],
                           geometry.constant_texcoord[unit])
             ? TexcoordKind::projective
             : TexcoordKind::plain;
}

raster::VaryingList lay_out(const State& state, const Geometry& geometry,
                            std::span<const raster::FragmentStage> stages) {
  raster::VaryingList list;
  const auto add_all = [&](bool affine) {
    for (std::size_t m = 0; m < raster::kMeaningCount; ++m) {
      const auto meaning = static_cast<Meaning>(m);
      if (is_affine(state, meaning) != affine) continue;
      for_each_read(stages, meaning, [&](const Varying& varying) { list.add(varying); });
    }
  };
  add_all(true);
  list.affine_count = list.count;
  add_all(false);
  if (has_unit_w(state, geometry)) list.affine_count = list.count;  // then linear on the screen is right
  for (const raster::FragmentStage& stage : stages) {
    if (stage.makes.floats > 0) list.add_computed(stage.makes);
  }
  return list;
}

bool has_unit_w(const State& state, const Geometry& geometry) {
  return geometry.position.components < 4 && keeps_w(state.eye_from_object) && keeps_w(state.clip_from_eye);
}

}  // namespace barrido::pipeline
