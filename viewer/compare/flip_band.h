// FLIP of some rows: the pixels of both pictures go in as linear RGB, the errors come out. A band needs only
// the rows around it, so that bands are computed side by side and no whole picture is held in the
// intermediate spaces.
#pragma once

#include <functional>
#include <span>

#include "viewer/compare/flip_filters.h"

namespace barrido::compare {

/// Linear RGB in 0..1 of a row, as three planes of `width` values each.
struct LinearRow {
  float* red;
  float* green;
  float* blue;
};
using RowReader = std::function<void(int y, const LinearRow& row)>;

/// Size of the pictures and the rows wanted.
struct Band {
  int width = 0;
  int height = 0;
  int begin = 0;
  int end = 0;
};

/// Writes the errors of rows [begin, end) to `errors`, (end − begin)·width values. Beyond the edges the
/// outermost pixels repeat.
void flip_band(const Band& band, const FlipFilters& filters, const RowReader& expected,
               const RowReader& actual, std::span<float> errors);

}  // namespace barrido::compare
