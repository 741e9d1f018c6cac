// Textures by procedure at one point (docs/arithmetic.md, "Patterns"). Enters a point and the box that a
// pixel covers there; leaves a value between 0 and 1.
#pragma once

#include "raster/reference/arithmetic.h"
#include "raster/textures/pattern.h"

namespace barrido::raster::reference {

/// What a pattern's value was made of.
struct PatternTrace {
  float footprint = 0.0f;  ///< Largest side of the box.
  float octaves = 0.0f;    ///< Sum of the octaves' weights: how many of them the pixel can show.
  float sum = 0.0f;        ///< Of noise: the octaves' sum, faded ones at their mean.
  float place = 0.0f;      ///< Of wood and marble: which ring or layer, with its part.
  float value = 0.0f;
  int noise = 0;  ///< How often noise was evaluated.
};

/// +1 on even unit cells, −1 on odd ones, averaged over [x − w/2, x + w/2] in closed form (after I. Quílez).
float filtered_parity(float x, float w);

/// A wave of period 1 that rises from 0 to 1 over `rise` of it and falls in the rest, averaged over w ≥ 1/64.
float filtered_wave(float x, float w, float rise);

PatternTrace pattern_at(const Pattern& pattern, const float (&at)[3], const float (&extent)[3]);

}  // namespace barrido::raster::reference
