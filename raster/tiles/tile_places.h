// A tile's pixels, each with a place of its own where it is sampled, and which of them are sampled at all.
#pragma once

#include <algorithm>
#include <cstdint>

#include "raster/tiles/binning.h"
#include "raster/tiles/samples.h"

namespace barrido::raster {

/// A bit for each column of a tile.
struct PixelBits {
  std::uint64_t word[kTileWidth / 64] = {};

  static PixelBits of(int begin, int end) {
    PixelBits bits;
    for (int w = 0; w < kTileWidth / 64; ++w) {
      const auto below = [w](int column) {
        const int n = std::clamp(column - 64 * w, 0, 64);
        return n == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << n) - 1;
      };
      bits.word[w] = below(end) & ~below(begin);
    }
    return bits;
  }
  /// Bits from a column on, none of which lie in two words.
  void put(int column, std::uint64_t bits) { word[column / 64] |= bits << (column % 64); }
  bool has(int column) const { return (word[column / 64] >> (column % 64) & 1) != 0; }
  bool none() const { return (word[0] | word[1]) == 0; }
  /// Of some.
  int first() const { return word[0] != 0 ? __builtin_ctzll(word[0]) : 64 + __builtin_ctzll(word[1]); }
  int last() const { return word[1] != 0 ? 127 - __builtin_clzll(word[1]) : 63 - __builtin_clzll(word[0]); }
  int count() const { return __builtin_popcountll(word[0]) + __builtin_popcountll(word[1]); }
  /// From a column that is a multiple of `lanes` on, the lowest first.
  unsigned at(int column, int lanes) const {
    return static_cast<unsigned>(word[column / 64] >> (column % 64)) & ((1u << lanes) - 1);
  }
  friend PixelBits operator&(const PixelBits& a, const PixelBits& b) {
    return {{a.word[0] & b.word[0], a.word[1] & b.word[1]}};
  }
  friend PixelBits operator|(const PixelBits& a, const PixelBits& b) {
    return {{a.word[0] | b.word[0], a.word[1] | b.word[1]}};
  }
};

struct TilePlaces {
  // Offsets from the pixels' centres, in pixels: multiples of 1/256, exact.
  alignas(64) float x[kTilePixels + kTilePadding];
  alignas(64) float y[kTilePixels + kTilePadding];
  alignas(64) float weight[kTilePixels + kTilePadding];
  PixelBits wanted[kTileHeight];
  SampleReach reach;  ///< Of the places of wanted pixels, or more.

  void set(int at, const SamplePlace& place) {
    constexpr float kUnit = 1.0f / kSubpixelUnits;
    x[at] = static_cast<float>(place.x - kSubpixelUnits / 2) * kUnit;
    y[at] = static_cast<float>(place.y - kSubpixelUnits / 2) * kUnit;
  }
};

}  // namespace barrido::raster
