// The frame cut into tiles. A tile's colour and depth stay in the first or second cache level of the one
// thread that draws it. Tiles are aligned at window (0, 0), so that nothing depends on the size of the frame.
#pragma once

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

}  // namespace barrido::raster
