#include "tests/bench/tile_store.h"

#include <algorithm>

// Compiled for the wide vectors as well, and chosen when the program starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define BARRIDO_WIDE_VECTORS __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
#else
#define BARRIDO_WIDE_VECTORS
#endif

namespace barrido::bench {
namespace {

BARRIDO_WIDE_VECTORS
void store(float* __restrict depth, std::uint32_t* __restrict colors, float value, std::uint32_t color) {
  for (int i = 0; i < CachedTile::kPixels; ++i) {
    const bool passes = value < depth[i];
    depth[i] = passes ? value : depth[i];
    colors[i] = passes ? color : colors[i];
  }
}

}  // namespace

void CachedTile::store_layer(float depth, std::uint32_t color) {
  store(depth_.data(), color_.data(), depth, color);
}

void CachedTile::clear() { std::fill(depth_.begin(), depth_.end(), 1.0f); }

}  // namespace barrido::bench
