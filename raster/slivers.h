// What lies between a pixel's samples: triangles that touch a pixel without covering any place where it was
// looked at. By exact edges, so that no thin line is lost (A3). Enters: triangles of a tile; leaves: for each
// pixel the largest of its slivers, each with a place inside and its share of the pixel's area.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "raster/kernels/triangle_edges.h"

namespace barrido::raster {

struct Sliver {
  SamplePlace place;  ///< Inside the triangle and the pixel.
  float area = 0.0f;  ///< Of the triangle within the pixel, which has 1.
};

/// The largest that a pixel keeps.
inline constexpr int kMostSlivers = 4;

/// The slivers of a tile's pixels, found triangle by triangle.
class SliverSearch {
 public:
  struct PixelSlivers {
    int count = 0;
    std::array<Sliver, kMostSlivers> slivers;  ///< In drawing order.
  };

  /// `samples_of(at)`: the places where pixel `at` of the tile (row × kTileWidth + column) is sampled
  /// already; the four corners among them.
  SliverSearch(const TileArea& tile, std::function<const std::vector<SamplePlace>&(int at)> samples_of);

  void add(const PrimitiveRecord& triangle);

  /// By pixel, row × kTileWidth + column.
  const std::vector<PixelSlivers>& pixels() const { return pixels_; }
  bool any() const { return any_; }

 private:
  void look_at_pixel(const PrimitiveRecord& triangle, int column, int row);

  TileArea tile_;
  std::function<const std::vector<SamplePlace>&(int at)> samples_of_;
  std::vector<PixelSlivers> pixels_;
  bool any_ = false;
};

/// Whether a place of the window, 1/256 pixel, is inside a triangle by the rule of docs/arithmetic.md.
bool is_inside(const PrimitiveRecord& triangle, std::int64_t x, std::int64_t y);

}  // namespace barrido::raster
