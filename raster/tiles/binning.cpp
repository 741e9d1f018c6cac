#include "raster/tiles/binning.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "raster/base/memory.h"

namespace barrido::raster {
namespace {

/// So many pixels samples lie away from their own, at most.
int pixels_beside(const SampleReach& reach) {
  const int most = std::max({std::abs(reach.least.x), std::abs(reach.least.y), reach.most.x, reach.most.y});
  return most / kSubpixelUnits;
}

/// Bounds of triangles are exact; points and lines get a margin of their width. Of samples anywhere in reach.
PixelBox unpixel_box(const PrimitiveRecord& p, const PrimitiveChunk& chunk, const SampleReach& reach) {
  if (chunk.topology == Topology::triangles) {
    // Not std::minmax, whose branches nobody can foresee.
    const auto least = [](const std::int32_t* v) { return std::min(std::min(v[0], v[1]), v[2]); };
    const auto most = [](const std::int32_t* v) { return std::max(std::max(v[0], v[1]), v[2]); };
    constexpr int kCenter = kSubpixelUnits / 2;
    return {first_centre_at(least(p.x) - (reach.most.x - kCenter)),
            first_centre_at(least(p.y) - (reach.most.y - kCenter)),
            first_centre_at(most(p.x) - (reach.least.x - kCenter)),
            first_centre_at(most(p.y) - (reach.least.y - kCenter))};
  }
  const int last = chunk.topology == Topology::lines ? 1 : 0;
  const float width = chunk.topology == Topology::lines ? chunk.line_width : chunk.point_size;
  const int margin =
      static_cast<int>(std::min(width, static_cast<float>(kMaxFrameSide))) / 2 + 2 + pixels_beside(reach);
  return {(std::min(p.x[0], p.x[last]) >> kSubpixelBits) - margin,
          (std::min(p.y[0], p.y[last]) >> kSubpixelBits) - margin,
          (std::max(p.x[0], p.x[last]) >> kSubpixelBits) + margin + 1,
          (std::max(p.y[0], p.y[last]) >> kSubpixelBits) + margin + 1};
}

/// Pixels whose centres the primitive's bounding box holds, cut to the frame.
PixelBox pixel_box(const PrimitiveRecord& primitive, const PrimitiveChunk& chunk, const TileGrid& grid,
                   const SampleReach& reach) {
  PixelBox box = unpixel_box(primitive, chunk, reach);
  box.x_begin = std::max(box.x_begin, 0);
  box.y_begin = std::max(box.y_begin, 0);
  box.x_end = std::min(box.x_end, grid.frame_width);
  box.y_end = std::min(box.y_end, grid.frame_height);
  return box;
}

/// Of a box in the frame that is not empty.
PixelBox tiles_of(const PixelBox& pixels) {
  const auto column = [](int x) { return static_cast<int>(static_cast<unsigned>(x) / kTileWidth); };
  const auto row = [](int y) { return static_cast<int>(static_cast<unsigned>(y) / kTileHeight); };
  return {column(pixels.x_begin), row(pixels.y_begin), column(pixels.x_end - 1) + 1,
          row(pixels.y_end - 1) + 1};
}

}  // namespace

BinnedChunk::BinnedChunk(PrimitiveChunk&& chunk, const TileGrid& grid, ColorFormat surface,
                         const SampleReach& reach, bool places)
    : chunk_(std::move(chunk)), key_(make_kernel_key(*chunk_.state, surface, places)) {
  const std::size_t count = chunk_.primitives.size();
  UnclearedArray<PixelBox> boxes(count);
  tiles_ = {grid.columns, grid.rows, 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    const PixelBox pixels = pixel_box(chunk_.primitives[i], chunk_, grid, reach);
    boxes[i] = pixels.empty() ? PixelBox{0, 0, 0, 0} : tiles_of(pixels);
    if (pixels.empty()) continue;
    tiles_.x_begin = std::min(tiles_.x_begin, boxes[i].x_begin);
    tiles_.y_begin = std::min(tiles_.y_begin, boxes[i].y_begin);
    tiles_.x_end = std::max(tiles_.x_end, boxes[i].x_end);
    tiles_.y_end = std::max(tiles_.y_end, boxes[i].y_end);
  }
  if (tiles_.empty()) {
    tiles_ = {0, 0, 0, 0};
    return;
  }

  // Counting sort: count per tile, prefix sums, then place in order.
  const int columns = tiles_.x_end - tiles_.x_begin;
  const auto for_each_tile = [&](const PixelBox& box, auto&& visit) {
    for (int y = box.y_begin; y < box.y_end; ++y) {
      for (int x = box.x_begin; x < box.x_end; ++x) {
        visit(static_cast<std::size_t>((y - tiles_.y_begin) * columns + (x - tiles_.x_begin)));
      }
    }
  };
  begin_.assign(static_cast<std::size_t>(columns * (tiles_.y_end - tiles_.y_begin)) + 1, 0);
  for (const PixelBox& box : boxes) {
    for_each_tile(box, [&](std::size_t tile) { ++begin_[tile + 1]; });
  }
  for (std::size_t tile = 1; tile < begin_.size(); ++tile) begin_[tile] += begin_[tile - 1];
  entries_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < count; ++i) {
    for_each_tile(boxes[i],
                  [&](std::size_t tile) { entries_[next[tile]++] = static_cast<std::uint16_t>(i); });
  }
}

}  // namespace barrido::raster
