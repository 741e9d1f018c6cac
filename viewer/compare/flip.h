// FLIP: how much two pictures differ to a person who flips between them (Andersson et al., "FLIP: A
// Difference Evaluator for Alternating Images", HPG 2020, and "Visualizing Errors in Rendered High Dynamic
// Range Images", Eurographics 2021). Enters: pixels. Leaves: an error in 0..1 a pixel and figures over them.
// Must not know: files, reports.
#pragma once

#include <optional>
#include <vector>

#include "pipeline/pictures/stored_picture.h"

namespace barrido::compare {

/// 0.7 m from a screen 0.7 m and 3840 pixels wide, as the papers assume.
inline constexpr double kPixelsPerDegree = 67.0206432766;

struct FlipFigures {
  double mean = 0.0;
  double weighted_median = 0.0;  ///< Half of the whole error is in pixels with at most this error.
  double max = 0.0;
  int max_x = 0, max_y = 0;  ///< From the left and the top; the first of several.
  /// Of floats: the range of exposures looked at, in stops; for each pixel the greatest error counts.
  struct Exposures {
    double start = 0.0, stop = 0.0;
    int count = 0;
  };
  std::optional<Exposures> exposures;
};

/// Error of each pixel, top row first, and the figures over all.
struct FlipMap {
  int width = 0;
  int height = 0;
  std::vector<float> errors;
  FlipFigures figures;
};

/// Compares what both pictures cover: the common area at the upper left. Fractions are compared as LDR-FLIP
/// does, floats as HDR-FLIP does with exposures chosen from `expected` (ACES tone mapping). Both must be on
/// the same footing. Pixels with alpha are seen over grey (half of 255), floats over black.
FlipMap flip(const scene::StoredPicture& expected, const scene::StoredPicture& actual);

}  // namespace barrido::compare
