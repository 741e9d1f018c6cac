// The least that drawing a pixel takes: depth compared, depth and colour stored, in a tile that fits a cache.
// What spans could reach if nothing else had to be done.
#pragma once

#include <cstdint>
#include <vector>

namespace barrido::bench {

class CachedTile {
 public:
  static constexpr int kPixels = 128 * 32;

  CachedTile() : depth_(kPixels, 1.0f), color_(kPixels, 0) {}

  /// Every pixel whose depth is greater than `depth` takes it, and the colour.
  void store_layer(float depth, std::uint32_t color);
  void clear();

 private:
  std::vector<float> depth_;
  std::vector<std::uint32_t> color_;
};

}  // namespace barrido::bench
