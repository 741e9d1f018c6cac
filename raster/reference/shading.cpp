#include "raster/reference/shading.h"

#include <algorithm>
#include <cmath>

#include "raster/base/portable_math.h"
#include "raster/reference/sampling.h"
#include "raster/reference/texture_environment.h"

namespace barrido::raster::reference {
namespace {

Color clamped(Color color) {
  for (float& channel : color) channel = clamp_to_unit(channel);
  return color;
}

/// Colours from the varyings, where the primitive has them, or from the illumination function.
void light_fragment(Fragment& batch) {
  const FragmentState& state = *batch.state;
  const VaryingLayout& layout = state.varyings;
  if (layout.color != kAbsent) {
    for (int c = 0; c < 4; ++c) batch.color[c][0] = batch.varying[layout.color + c][0];
  }
  if (layout.specular != kAbsent) {
    for (int c = 0; c < 3; ++c) batch.specular[c][0] = batch.varying[layout.specular + c][0];
  }
  if (state.illumination.function != nullptr) {
    state.illumination.function(state.illumination.parameters, batch);
  }
}

Color sample_unit(const Fragment& batch, int unit, UnitTrace* trace) {
  const auto index = static_cast<std::size_t>(unit);
  const VaryingLayout& layout = batch.state->varyings;
  const TexcoordKind kind = layout.texcoord_kind[index];
  float coordinates[3] = {0, 0, 0};
  const int count = kind == TexcoordKind::plain ? 2 : 3;
  for (int k = 0; k < count; ++k) coordinates[k] = batch.varying[layout.texcoord[index] + k][0];
  if (trace != nullptr) {
    trace->unit = unit;
    std::copy_n(coordinates, 3, trace->coordinates);
    trace->lod = batch.lod[unit];
  }
  return sample_texture(batch.state->texture_units[index], kind, coordinates, batch.lod[unit],
                        trace != nullptr ? &trace->sample : nullptr);
}

Color apply_texture_units(const Fragment& batch, const Color& primary, ShadingTrace* trace) {
  const FragmentState& state = *batch.state;
  Color color = primary;
  for (int unit = 0; unit < kMaxTextureUnits; ++unit) {
    if (!is_unit_active(state, unit)) continue;
    UnitTrace* remembered = trace != nullptr ? &trace->units.emplace_back() : nullptr;
    const UnitInputs inputs{sample_unit(batch, unit, remembered), primary, color};
    const Color result =
        apply_texture_environment(state.texture_units[static_cast<std::size_t>(unit)], inputs);
    color = state.clamp_colors ? clamped(result) : result;
    if (remembered != nullptr) {
      remembered->previous = inputs.previous;
      remembered->result = result;
      remembered->color = color;
    }
  }
  return color;
}

Color apply_fog(const FogState& fog, float distance, Color color, ShadingTrace* trace) {
  const float f = fog_fraction(fog, distance);
  for (std::size_t c = 0; c < 3; ++c) color[c] = f * color[c] + (1.0f - f) * fog.color[c];
  if (trace != nullptr) trace->fog = FogTrace{distance, f, color};
  return color;
}

}  // namespace

bool is_unit_active(const FragmentState& state, int unit) {
  const auto index = static_cast<std::size_t>(unit);
  const Texture* texture = state.texture_units[index].texture;
  if (texture == nullptr || state.varyings.texcoord[index] == kAbsent) return false;
  return texture->is_cube() == (state.varyings.texcoord_kind[index] == TexcoordKind::cube);
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

Color shade_fragment(Fragment& batch, ShadingTrace* trace) {
  const FragmentState& state = *batch.state;
  light_fragment(batch);
  Color primary{};
  Color secondary{};
  for (std::size_t c = 0; c < 4; ++c) primary[c] = batch.color[c][0];
  for (std::size_t c = 0; c < 3; ++c) secondary[c] = batch.specular[c][0];
  if (trace != nullptr) {
    trace->lit_primary = primary;
    trace->lit_secondary = secondary;
  }
  if (state.clamp_colors) {
    primary = clamped(primary);
    secondary = clamped(secondary);
  }
  if (trace != nullptr) {
    trace->primary = primary;
    trace->secondary = secondary;
  }
  Color color = apply_texture_units(batch, primary, trace);
  if (state.separate_specular) {
    for (std::size_t c = 0; c < 3; ++c) color[c] = color[c] + secondary[c];
    if (state.clamp_colors) color = clamped(color);
    if (trace != nullptr) trace->sum = color;
  }
  if (state.fog.enabled && state.varyings.fog != kAbsent) {
    color = apply_fog(state.fog, std::fabs(batch.varying[state.varyings.fog][0]), color, trace);
  }
  if (trace != nullptr) trace->color = color;
  return color;
}

}  // namespace barrido::raster::reference
