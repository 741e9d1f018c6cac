#include "raster/reference/shading.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "raster/base/portable_math.h"
#include "raster/reference/mapping.h"
#include "raster/reference/sampling.h"
#include "raster/reference/texture_environment.h"
#include "raster/reference/wide_filters.h"

namespace barrido::raster::reference {
namespace {

Color clamped(Color color) {
  for (float& channel : color) channel = clamp_to_unit(channel);
  return color;
}

Note note_of(std::string_view name, std::initializer_list<float> values) { return {name, values}; }

/// (s, t) of the unit's point by its mapping.
void map_point(const Fragment& fragment, const Mapping& mapping, float (&coordinates)[3], UnitTrace* trace) {
  Point normal{};
  if (needs_normal(mapping)) {
    std::copy_n(fragment.varying + fragment.state->varyings.at(Meaning::normal), 3, normal.begin());
  }
  const MappedPlace at = reach_surface(mapping, {coordinates[0], coordinates[1], coordinates[2]}, normal);
  const std::array<float, 2> mapped = mapped_coordinates(mapping, at);
  if (trace != nullptr) {
    const std::array<float, 2> uv = surface_coordinates(mapping, at);
    trace->notes.push_back(
        note_of("place on the intermediate surface", {at.place[0], at.place[1], at.place[2]}));
    trace->notes.push_back(note_of("its (u, v)", {uv[0], uv[1]}));
    trace->notes.push_back(note_of("coordinates by the mapping", {mapped[0], mapped[1]}));
  }
  coordinates[0] = mapped[0];
  coordinates[1] = mapped[1];
  coordinates[2] = 0.0f;
}

void change_tile_of(const TextureUnit& unit, float (&coordinates)[3], UnitTrace* trace) {
  const TilePlace tile = change_tile(unit.tiles, coordinates[0], coordinates[1]);
  std::copy_n(tile.coordinates.begin(), 2, coordinates);
  if (trace == nullptr) return;
  trace->notes.push_back(note_of("tile", {static_cast<float>(tile.i), static_cast<float>(tile.j)}));
  trace->notes.push_back(note_of("its quarter turns", {static_cast<float>(tile.quarter_turns)}));
  trace->notes.push_back(note_of("its shift", {tile.shift_s, tile.shift_t}));
}

}  // namespace

Color unit_texel(const Fragment& fragment, int unit, UnitTrace* trace, const std::array<float, 3>& shift) {
  const TextureUnit& state = fragment.state->texture_units[static_cast<std::size_t>(unit)];
  const VaryingList& varyings = fragment.state->varyings;
  float coordinates[3] = {0, 0, 0};
  std::copy_n(fragment.varying + varyings.at(Meaning::texcoord, unit),
              varyings.floats(Meaning::texcoord, unit), coordinates);
  for (std::size_t i = 0; i < 3; ++i) {
    if (shift[i] != 0.0f) coordinates[i] = coordinates[i] + shift[i];
  }
  if (trace != nullptr) {
    trace->unit = unit;
    std::copy_n(coordinates, 3, trace->coordinates);
    trace->lod = fragment.lod[unit];
  }
  const TexcoordKind kind = texcoord_kind(*fragment.state, unit);
  if (state.mapping.surface != MappingSurface::none) map_point(fragment, state.mapping, coordinates, trace);
  if (state.procedure == nullptr) {
    if (changes_tiles(*fragment.state, unit)) change_tile_of(state, coordinates, trace);
    if (has_wide_filter(state)) {
      return sample_wide(state, kind, coordinates, fragment.lod[unit], fragment.slopes[unit],
                         trace != nullptr ? &trace->sample : nullptr)
          .color;
    }
    return sample_texture(state, kind, coordinates, fragment.lod[unit],
                          trace != nullptr ? &trace->sample : nullptr);
  }
  if (kind == TexcoordKind::plain) coordinates[2] = 0.5f;
  const Color texel = state.procedure->scalar(state, coordinates, fragment.extent[unit], trace);
  if (trace != nullptr) trace->sample.color = texel;
  return texel;
}

float fog_fraction(const FogState& fog, float distance) {
  constexpr float kLog2E = 1.44269504f;
  float f = 0.0f;
  switch (fog.mode) {
    case FogMode::linear:
      f = (fog.end - distance) * (1.0f / (fog.end - fog.start));
      break;
    case FogMode::exp:
      f = portable_exp2((-fog.density * kLog2E) * distance);
      break;
    case FogMode::exp2: {
      const float t = fog.density * distance;
      f = portable_exp2((t * t) * -kLog2E);
      break;
    }
  }
  return clamp_to_unit(f);
}

void take_colors(const FragmentStage&, Fragment& fragment, ShadingTrace* trace) {
  const FragmentState& state = *fragment.state;
  if (!is_lit(state)) {
    const auto take = [&](Meaning meaning, Color& color) {
      const VaryingList& varyings = state.varyings;
      std::copy_n(fragment.varying + std::max(varyings.at(meaning), 0), varyings.floats(meaning),
                  color.data());
    };
    take(Meaning::color, fragment.color);
    take(Meaning::specular, fragment.specular);
  }
  if (trace != nullptr) {
    trace->lit_primary = fragment.color;
    trace->lit_secondary = fragment.specular;
  }
  if (state.clamp_colors) {
    fragment.color = clamped(fragment.color);
    fragment.specular = clamped(fragment.specular);
  }
  fragment.primary = fragment.color;
  if (trace != nullptr) {
    trace->primary = fragment.color;
    trace->secondary = fragment.specular;
  }
}

void apply_texture(const FragmentStage& stage, Fragment& fragment, ShadingTrace* trace) {
  const FragmentState& state = *fragment.state;
  UnitTrace* remembered = trace != nullptr ? &trace->units.emplace_back() : nullptr;
  const UnitInputs inputs{unit_texel(fragment, stage.unit, remembered), fragment.primary, fragment.color};
  const Color result =
      apply_texture_environment(state.texture_units[static_cast<std::size_t>(stage.unit)], inputs);
  fragment.color = state.clamp_colors ? clamped(result) : result;
  if (remembered != nullptr) {
    remembered->previous = inputs.previous;
    remembered->result = result;
    remembered->color = fragment.color;
  }
}

void apply_shine(const FragmentStage& stage, Fragment& fragment, ShadingTrace* trace) {
  UnitTrace* remembered = trace != nullptr ? &trace->maps.emplace_back() : nullptr;
  const Color texel = unit_texel(fragment, stage.unit, remembered);
  Color& specular = fragment.specular;
  for (std::size_t c = 0; c < 3; ++c) specular[c] = specular[c] * texel[c];
  if (remembered != nullptr) {
    remembered->notes.push_back({"highlights", {specular[0], specular[1], specular[2]}});
  }
}

void add_secondary(const FragmentStage&, Fragment& fragment, ShadingTrace* trace) {
  Color& color = fragment.color;
  for (std::size_t c = 0; c < 3; ++c) color[c] = color[c] + fragment.specular[c];
  if (fragment.state->clamp_colors) color = clamped(color);
  if (trace != nullptr) trace->sum = color;
}

void apply_fog(const FragmentStage&, Fragment& fragment, ShadingTrace* trace) {
  const FogState& fog = fragment.state->fog;
  Color& color = fragment.color;
  const float distance = std::fabs(fragment.varying[fragment.state->varyings.at(Meaning::fog)]);
  const float f = fog_fraction(fog, distance);
  for (std::size_t c = 0; c < 3; ++c) color[c] = f * color[c] + (1.0f - f) * fog.color[c];
  if (trace != nullptr) trace->fog = FogTrace{distance, f, color};
}

Color shade_fragment(Fragment& fragment, ShadingTrace* trace) {
  for (const FragmentStage& stage : fragment.state->stages) stage.kind->scalar(stage, fragment, trace);
  if (trace == nullptr) return fragment.color;
  trace->color = fragment.color;
  if (!trace->maps.empty()) trace->varyings.assign(std::begin(fragment.varying), std::end(fragment.varying));
  return fragment.color;
}

}  // namespace barrido::raster::reference
