// Places of a sample that differ from pixel to pixel (A2, jittered sampling): one random place in the same
// cell of every pixel, from a hash of pixel, sample and seed alone. So nothing depends on threads, tiles or
// what was drawn before. Shared by the kernels and the reference: there is one way to make random numbers.
#pragma once

#include <cstdint>
#include <vector>

#include "raster/base/hash.h"
#include "raster/tiles/pixel_filter.h"
#include "raster/tiles/samples.h"

namespace barrido::raster {

/// A cell of a pixel, in 1/65536 pixel from the pixel's lower left corner.
struct PlaceCell {
  std::int32_t x = 0, y = 0;
  std::uint32_t width = 65536, height = 65536;  ///< At most 2²⁰.
};

/// Cell `number` of `count` in the square that a filter of this radius covers; see square_cell().
PlaceCell place_cell(int number, int count, float radius);

/// The place in the cell of pixel (x, y), window coordinates; `key` is hash_of(sample, seed).
inline SamplePlace place_in(const PlaceCell& cell, int x, int y, std::uint32_t key) {
  const std::uint32_t row_key = mixed(key + static_cast<std::uint32_t>(y) * kHashOdd1);
  const std::uint32_t h = mixed(row_key + static_cast<std::uint32_t>(x) * kHashOdd2);
  const auto along = [](std::int32_t begin, std::uint32_t size, std::uint32_t twelve_bits) {
    return (begin + static_cast<std::int32_t>((twelve_bits * size) >> 12)) >> 8;
  };
  return {along(cell.x, cell.width, h & 0xfff), along(cell.y, cell.height, h >> 20)};
}

/// Values of a filter at the places of pixels, in floats.
class PlaceWeights {
 public:
  explicit PlaceWeights(const PixelFilter& filter);

  /// False: all weights are 1.
  bool differ() const { return !along_.empty() || filter_.kind == PixelFilterKind::cone; }
  float at(const SamplePlace& place) const {
    const int x = place.x - kSubpixelUnits / 2;
    const int y = place.y - kSubpixelUnits / 2;
    if (!along_.empty())
      return along_[static_cast<std::size_t>(x + reach_)] * along_[static_cast<std::size_t>(y + reach_)];
    return filter_.kind == PixelFilterKind::cone ? cone(x, y) : 1.0f;
  }

 private:
  float cone(int x, int y) const;

  PixelFilter filter_;
  int reach_ = 0;             ///< Places within −reach_ … reach_ of the centre.
  std::vector<float> along_;  ///< Of filters that are products, the one of either axis.
};

}  // namespace barrido::raster
