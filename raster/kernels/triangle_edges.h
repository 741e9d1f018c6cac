// What a triangle tells without spans: its pixels' bounding box in a tile, its area, and whether a box lies
// in all of it or beside it. Exact on the 1/256-pixel grid, by the rule of docs/arithmetic.md. Enters: a
// primitive and a tile.
#pragma once

#include <algorithm>
#include <cstdint>

#include "raster/tiles/tile.h"

namespace barrido::raster {

/// The tile's place in the window; all columns and rows below are relative to it.
struct TileArea {
  int x;               ///< Window x of column 0.
  int y;               ///< Window y of row 0.
  int width;           ///< Columns that lie in the frame.
  int height;          ///< Rows that lie in the frame.
  SamplePlace sample;  ///< Where its pixels are sampled: their "centres" below.

  /// The first column or row whose sample is at or after a coordinate.
  int first_column_at(std::int32_t v) const { return ((v + kToNextPixel - sample.x) >> kSubpixelBits) - x; }
  int first_row_at(std::int32_t v) const { return ((v + kToNextPixel - sample.y) >> kSubpixelBits) - y; }
  /// The sample of a column or row, 1/256 pixel.
  std::int32_t center_x(int column) const { return (x + column) * kSubpixelUnits + sample.x; }
  std::int32_t center_y(int row) const { return (y + row) * kSubpixelUnits + sample.y; }
  /// In pixels; exact.
  double pixel_x(int column) const { return (x + column) + sample.x * (1.0 / kSubpixelUnits); }
  double pixel_y(int row) const { return (y + row) + sample.y * (1.0 / kSubpixelUnits); }

  static constexpr int kToNextPixel = kSubpixelUnits - 1;
};

/// Columns and rows, relative to the tile, that the scissor leaves.
struct ScissorBox {
  int x_begin = 0, y_begin = 0, x_end = kTileWidth, y_end = kTileHeight;
};

inline ScissorBox scissor_in(const Scissor& scissor, const TileArea& tile) {
  if (!scissor.enabled) return {};
  const auto relative = [](std::int64_t v, int origin, int limit) {
    return static_cast<int>(std::clamp<std::int64_t>(v - origin, 0, limit));
  };
  return {relative(scissor.x, tile.x, kTileWidth), relative(scissor.y, tile.y, kTileHeight),
          relative(static_cast<std::int64_t>(scissor.x) + std::max(scissor.width, 0), tile.x, kTileWidth),
          relative(static_cast<std::int64_t>(scissor.y) + std::max(scissor.height, 0), tile.y, kTileHeight)};
}

/// Whether the scissor leaves less than the tile's part of the frame.
inline bool cuts(const ScissorBox& scissor, const TileArea& tile) {
  return scissor.x_begin > 0 || scissor.y_begin > 0 || scissor.x_end < tile.width ||
         scissor.y_end < tile.height;
}

/// A triangle smaller than this along both axes: its edge functions fit 32 bits.
inline constexpr std::int32_t kSmallTriangle = 40 * kSubpixelUnits;

/// Twice the signed area in (1/256 pixel)²; positive when counter-clockwise with y up.
inline std::int64_t signed_area(const PrimitiveRecord& p) {
  const std::int64_t dx1 = static_cast<std::int64_t>(p.x[1]) - p.x[0];
  const std::int64_t dy1 = static_cast<std::int64_t>(p.y[1]) - p.y[0];
  const std::int64_t dx2 = static_cast<std::int64_t>(p.x[2]) - p.x[0];
  const std::int64_t dy2 = static_cast<std::int64_t>(p.y[2]) - p.y[0];
  return dx1 * dy2 - dx2 * dy1;
}

/// The pixels of the tile that a triangle's bounding box holds, relative to the tile, half-open.
struct TriangleBox {
  int column_begin, column_end, row_begin, row_end;
  bool is_small;  ///< The triangle is smaller than kSmallTriangle, in and outside the tile.
};

/// @return false when there are none.
inline bool triangle_box(const PrimitiveRecord& p, const TileArea& tile, TriangleBox& box) {
  const std::int32_t x_min = std::min(std::min(p.x[0], p.x[1]), p.x[2]);
  const std::int32_t x_max = std::max(std::max(p.x[0], p.x[1]), p.x[2]);
  const std::int32_t y_min = std::min(std::min(p.y[0], p.y[1]), p.y[2]);
  const std::int32_t y_max = std::max(std::max(p.y[0], p.y[1]), p.y[2]);
  box.column_begin = std::max(tile.first_column_at(x_min), 0);
  box.column_end = std::min(tile.first_column_at(x_max), tile.width);
  box.row_begin = std::max(tile.first_row_at(y_min), 0);
  box.row_end = std::min(tile.first_row_at(y_max), tile.height);
  box.is_small = x_max - x_min < kSmallTriangle && y_max - y_min < kSmallTriangle;
  return box.column_begin < box.column_end && box.row_begin < box.row_end;
}

/// How much of a box of pixels a triangle covers.
enum class Cover : std::uint8_t { none, some, all };

/// By the edge functions at the box's corners. `none` and `all` are certain; `some` may turn out to be none.
inline Cover cover_of(const PrimitiveRecord& p, bool clockwise, const TriangleBox& box,
                      const TileArea& tile) {
  const int corner[4] = {0, clockwise ? 2 : 1, clockwise ? 1 : 2, 0};
  const std::int64_t x = tile.center_x(box.column_begin);
  const std::int64_t y = tile.center_y(box.row_begin);
  const std::int64_t width = (box.column_end - box.column_begin - 1) * kSubpixelUnits;
  const std::int64_t height = (box.row_end - box.row_begin - 1) * kSubpixelUnits;
  Cover cover = Cover::all;
  for (int e = 0; e < 3; ++e) {
    const std::int64_t ax = p.x[corner[e]];
    const std::int64_t ay = p.y[corner[e]];
    const std::int64_t dx = p.x[corner[e + 1]] - ax;
    const std::int64_t dy = p.y[corner[e + 1]] - ay;
    const bool owns_centres = dy < 0 || (dy == 0 && dx > 0);
    const std::int64_t value = dx * (y - ay) - dy * (x - ax) - (owns_centres ? 0 : 1);
    const std::int64_t along_x = -dy * width;
    const std::int64_t along_y = dx * height;
    const std::int64_t zero = 0;
    if (value + std::max(along_x, zero) + std::max(along_y, zero) < 0) return Cover::none;
    if (value + std::min(along_x, zero) + std::min(along_y, zero) < 0) cover = Cover::some;
  }
  return cover;
}

}  // namespace barrido::raster
