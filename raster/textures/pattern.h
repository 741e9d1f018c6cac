// Textures that are computed, not stored (T12): stripes, checkers, noise, wood and marble as functions of a
// point. Each is a value in [0, 1], which mixes two colours. Must not know: objects, units, files.
#pragma once

#include <array>
#include <cstdint>

namespace barrido::raster {

enum class PatternKind : std::uint8_t {
  stripes,  ///< Parity of ⌊y⌋.
  checker,  ///< Parity of ⌊x⌋ + ⌊y⌋ + ⌊z⌋.
  noise,    ///< Perlin's improved noise, as it is or where it is above a threshold.
  wood,     ///< Rings about the y axis, displaced by turbulence.
  marble,   ///< Layers across the y axis, displaced by turbulence.
};

inline constexpr int kMaxOctaves = 16;

/// A pattern in coordinates whose unit is one stripe, one cell, the cell of the noise's lattice, a ring or a
/// layer. The pattern's axis is y.
struct Pattern {
  PatternKind kind = PatternKind::checker;
  int octaves = 1;             ///< 1 … kMaxOctaves; octave i has the frequency 2^i and the weight gain^i.
  float gain = 0.5f;           ///< (0, 1]
  float turbulence = 0.0f;     ///< Of wood and marble: how far noise moves rings and layers, in the unit.
  bool has_threshold = false;  ///< Of noise: 1 above the threshold, 0 below it.
  float threshold = 0.0f;      ///< [−1, 1]
  std::array<std::array<float, 4>, 2> colors{{{0, 0, 0, 1}, {1, 1, 1, 1}}};  ///< Of the values 0 and 1.

  bool operator==(const Pattern&) const = default;
};

/// How many evaluations of noise a point of the pattern asks for at most.
inline int most_octaves(const Pattern& pattern) {
  const bool is_moved = pattern.kind == PatternKind::wood || pattern.kind == PatternKind::marble;
  return pattern.kind == PatternKind::noise || (is_moved && pattern.turbulence != 0.0f) ? pattern.octaves : 0;
}

/// Mean of |noise| over a cell, which an octave that has faded leaves behind in the turbulence.
inline constexpr float kMeanAbsoluteNoise = 0.2204f;

/// Part of a ring of wood in which it darkens; in the rest it falls back.
inline constexpr float kWoodRise = 0.8f;
inline constexpr float kMarbleRise = 0.5f;

}  // namespace barrido::raster
