// The frame cut into tiles, and the primitives of a chunk sorted into the tiles that their bounding boxes
// touch, in their order. A tile's colour and depth stay in the first or second cache level of the one thread
// that draws it. Tiles are aligned at window (0, 0), so that nothing depends on the size of the frame.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "raster/fragments/primitive.h"
#include "raster/tiles/kernel_key.h"
#include "raster/tiles/samples.h"

namespace barrido::raster {

inline constexpr int kTileWidth = 128;
inline constexpr int kTileHeight = 32;
inline constexpr int kTilePixels = kTileWidth * kTileHeight;
/// Elements that kernels may touch, but not change, past the last row.
inline constexpr int kTilePadding = 16;
/// The same for the tile's pixels, of which blocks of several rows touch rows below the last.
inline constexpr int kSurfacePadding = 3 * kTileWidth + kTilePadding;

struct TileGrid {
  int frame_width = 0;
  int frame_height = 0;
  int columns = 0;
  int rows = 0;

  TileGrid(int width, int height)
      : frame_width(width),
        frame_height(height),
        columns((width + kTileWidth - 1) / kTileWidth),
        rows((height + kTileHeight - 1) / kTileHeight) {}
  int count() const { return columns * rows; }
};

/// Half-open box of pixels (or tiles).
struct PixelBox {
  int x_begin, y_begin, x_end, y_end;
  bool empty() const { return x_begin >= x_end || y_begin >= y_end; }
};

/// A chunk with, for each tile of the box of tiles it touches, the numbers of its primitives in order.
class BinnedChunk {
 public:
  /// For a frame of this format whose pixels are sampled around their centres so far, some at places of their
  /// own.
  BinnedChunk(PrimitiveChunk&& chunk, const TileGrid& grid, ColorFormat surface,
              const SampleReach& reach = {}, bool places = false);

  const PrimitiveChunk& chunk() const { return chunk_; }
  /// Which loops draw it.
  const KernelKey& key() const { return key_; }
  /// Numbers of the primitives that may touch the tile, ascending.
  std::span<const std::uint16_t> primitives_in(int tile_column, int tile_row) const {
    if (tile_column < tiles_.x_begin || tile_column >= tiles_.x_end || tile_row < tiles_.y_begin ||
        tile_row >= tiles_.y_end) {
      return {};
    }
    const auto tile = static_cast<std::size_t>((tile_row - tiles_.y_begin) * (tiles_.x_end - tiles_.x_begin) +
                                               (tile_column - tiles_.x_begin));
    return {entries_.data() + begin_[tile], begin_[tile + 1] - begin_[tile]};
  }

 private:
  PrimitiveChunk chunk_;
  KernelKey key_;
  PixelBox tiles_{0, 0, 0, 0};
  std::vector<std::uint32_t> begin_;  // one a tile of tiles_, and the end
  std::vector<std::uint16_t> entries_;
};

}  // namespace barrido::raster
