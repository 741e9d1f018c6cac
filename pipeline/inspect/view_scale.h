// How a view's numbers are spread over its colours. Enters: values; leaves: places on the scale. Knows no
// pixels.
#pragma once

#include <string>

#include "pipeline/inspect/structure_view.h"

namespace barrido::inspect {

/// Second derivatives of this size, in 1/255, have the strongest colours; edges of objects have far more.
inline constexpr double kMachBandLimit = 16.0;

/// So many doublings of texels to a pixel have the strongest colours.
inline constexpr double kDensityLimit = 6.0;

/// Of views with numbers in order.
struct ViewScale {
  double least = 0.0, most = 1.0;
  bool is_signed = false;    ///< From −most to most, by square roots.
  bool square_root = false;  ///< From least to most, by square roots.
  std::string least_word, most_word;

  /// Place in [0, 1], or in [−1, 1] of signed scales.
  double place_of(double value) const;
  /// The value at a place of the bar from 0 to 1.
  double value_at(double t) const;
};

ViewScale scale_of(const ViewValues& values);

}  // namespace barrido::inspect
