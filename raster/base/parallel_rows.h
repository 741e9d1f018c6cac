// The rows of a picture or texture level by all threads, where there are many pixels. Knows not what is done
// to them.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace barrido::raster {

/// Calls `row` with 0 … height − 1; rows must not depend on each other.
template <class Row>
void for_each_row(int width, int height, const Row& row) {
  constexpr int kPixelsAPiece = 1 << 15;
  const int piece = std::max(1, kPixelsAPiece / width);
  const auto rows = [&row](const tbb::blocked_range<int>& range) {
    for (int j = range.begin(); j < range.end(); ++j) row(j);
  };
  if (height <= piece) return rows({0, height});
  tbb::parallel_for(tbb::blocked_range<int>(0, height, static_cast<std::size_t>(piece)), rows);
}

}  // namespace barrido::raster
