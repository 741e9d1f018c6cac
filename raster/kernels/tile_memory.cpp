// Tiles to and from the frame: clearing, and storing finished rows past the caches, since nothing reads them
// soon.
#include <algorithm>
#include <cstring>

#include "raster/kernels/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/tile_memory.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/blend-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class T>
HWY_INLINE void fill_tile(T* values, T value) {
  const hn::ScalableTag<T> d;
  const auto v = hn::Set(d, value);
  for (int i = 0; i < kTilePixels; i += static_cast<int>(hn::Lanes(d))) hn::Store(v, d, values + i);
}

/// Copies a row; whole vectors of the destination bypass the caches.
template <class T>
HWY_INLINE void stream_row(const T* from, int count, T* to) {
  const hn::ScalableTag<T> d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto bytes = static_cast<int>(sizeof(T)) * lanes;
  const auto misaligned =
      static_cast<int>(reinterpret_cast<std::uintptr_t>(to) % static_cast<std::uintptr_t>(bytes));
  int i = misaligned == 0 ? 0 : std::min(count, (bytes - misaligned) / static_cast<int>(sizeof(T)));
  if (i > 0) std::copy_n(from, i, to);
  for (; i + lanes <= count; i += lanes) hn::Stream(hn::LoadU(d, from + i), d, to + i);
  if (i < count) std::copy_n(from + i, count - i, to + i);
}

void ClearTile(TileSurface& tile, const float* color, float depth) {
  if (tile.format == ColorFormat::rgba8) {
    fill_tile(tile.color8, static_cast<std::uint32_t>(hn::GetLane(pack8(one_color(color)))));
  } else {
    for (int c = 0; c < 4; ++c) fill_tile(tile.color_float[c], color[c]);
  }
  fill_tile(tile.depth, depth);
}

void StoreTile(const TilePixels& tile, int width, int height, const FramePixels& frame) {
  for (int row = 0; row < height; ++row) {
    stream_row(tile.color8 + row * kTileWidth, width, frame.color8 - row * frame.pitch);
    if (frame.depth != nullptr) {
      stream_row(tile.depth + row * kTileWidth, width, frame.depth - row * frame.pitch);
    }
  }
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace barrido::raster {

HWY_EXPORT(ClearTile);
HWY_EXPORT(StoreTile);

void clear_tile(TileSurface& tile, const float* color, float depth) {
  HWY_DYNAMIC_DISPATCH(ClearTile)(tile, color, depth);
}

void store_tile(const TilePixels& tile, int width, int height, const FramePixels& frame) {
  HWY_DYNAMIC_DISPATCH(StoreTile)(tile, width, height, frame);
}

}  // namespace barrido::raster
#endif
