// The filters of FLIP, as rows of weights: what the eye's contrast sensitivity leaves of a picture, and where
// edges and points are (Andersson et al. 2020, sections 4.1.1 and 4.2.1). All of them are products of one row
// and one column.
#pragma once

#include <vector>

namespace barrido::compare {

/// Weights for the pixels from −radius to +radius.
struct Kernel {
  int radius = 0;
  std::vector<float> weights;  ///< 2·radius + 1
};

struct FlipFilters {
  Kernel achromatic;   ///< For Y of YCxCz.
  Kernel red_green;    ///< For Cx.
  Kernel blue_yellow;  ///< For Cz, the sum of two Gaussians: this one and
  Kernel blue_yellow_wide;
  Kernel gaussian;  ///< Across the direction in which the following two find features.
  Kernel edge;      ///< First derivative of the Gaussian.
  Kernel point;     ///< Second derivative.

  int max_radius() const;
};

/// For a screen with so many pixels in a degree of what is seen.
FlipFilters make_flip_filters(double pixels_per_degree);

}  // namespace barrido::compare
