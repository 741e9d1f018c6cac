// What each pixel of a scene pair may differ, decided from the projected geometry in double precision and
// never from a picture: interior, within one pixel of an edge, or near a tie of a discrete decision (texel,
// level, face, depth).
#pragma once

#include <optional>
#include <vector>

#include "tests/osmesa/scene_pair.h"

namespace barrido::crosscheck {

enum class PixelClass : std::uint8_t { interior, edge, tie };
inline constexpr std::size_t kPixelClasses = 3;

struct PixelRule {
  PixelClass kind = PixelClass::interior;
  int layers = 1;            ///< Roundings that add up: fragments that are blended, scales of combine.
  float allowance = 0.0f;    ///< On top of that, in 1/255.
  float depth_slope = 0.0f;  ///< Steepest surface here: window depth per pixel.
  /// The colour itself in double precision, in 1/255, where it is nothing but a linearly filtered texel.
  std::optional<std::array<double, 4>> color;
};

/// For every pixel, top row first.
std::vector<PixelRule> classify(const ScenePair& pair);

}  // namespace barrido::crosscheck
