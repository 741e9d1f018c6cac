// A texture's colour at one place: wrap modes, choice of mip levels, filters. Enters coordinates and λ; knows
// nothing of what the colour is used for.
#pragma once

#include <cstdint>

#include "raster/fragments/fragment_state.h"
#include "raster/reference/arithmetic.h"
#include "raster/reference/trace.h"

namespace barrido::raster::reference {

/// Filtered channels in 16 bits: 65280 is 1 for rgba8 texels, 65535 for rgba16.
using Filtered = std::array<std::uint32_t, 4>;

/// A place on one face of a texture, before wrapping.
struct Place {
  int face = 0;
  float u = 0.0f;
  float v = 0.0f;
};

/// 0 in place of what is not below 2²² in magnitude.
float sane_coordinate(float value);
/// `coordinates` as for sample_texture.
Place place_of(TexcoordKind kind, const float (&coordinates)[3]);

/// The texel's channels as they are stored; (i, j) may lie in the apron.
Filtered fetch(const Texture& texture, int level, int face, int i, int j);
/// What a 16-bit channel of the filters counts.
float channel_scale(const Texture& texture);

/// Which mip levels a unit reads for a level of detail, and how.
struct LevelChoice {
  bool magnified = false;
  bool linear = false;  ///< Four texels a level, else one.
  int first = 0;
  int second = 0;              ///< Only read when two_levels.
  bool two_levels = false;     ///< *_mipmap_linear, minified.
  std::uint32_t fraction = 0;  ///< Weight of the second level in 1/256.

  /// Texels that decide the colour: those of a level without weight are not counted.
  int texels() const { return (linear ? 4 : 1) * (two_levels && fraction > 0 ? 2 : 1); }
  /// The level between the two, 0 for magnified textures.
  float level() const {
    return static_cast<float>(first) + (two_levels ? static_cast<float>(fraction) * (1.0f / 256.0f) : 0.0f);
  }
};

/// `lod` is λ without the unit's bias; the unit must have a texture.
LevelChoice choose_levels(const TextureUnit& unit, float lod);

/// The texels at one place of the levels chosen, filtered.
Filtered sample_at(const TextureUnit& unit, const LevelChoice& choice, const Place& place,
                   SampleTrace* trace);

/// `coordinates` holds two or three numbers, as `kind` says; `lod` is λ without the unit's bias. What was
/// read is remembered in `trace` unless that is null.
Color sample_texture(const TextureUnit& unit, TexcoordKind kind, const float (&coordinates)[3], float lod,
                     SampleTrace* trace = nullptr);

}  // namespace barrido::raster::reference
