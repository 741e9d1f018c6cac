// Uniform subdivision: every edge of a triangle list is cut into the same number of pieces, every triangle
// into a grid. Enters: which class each corner belongs to; leaves: numbers for the fine points, such that
// triangles with a common edge have the same numbers along it. Knows no positions.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace barrido::scene {

/// A point of a triangle's grid: how many of n parts it has of each corner; they sum to n.
struct GridPoint {
  std::uint32_t weight[3];
};

/// The grid that all triangles have: points row by row, and its triangles wound as the whole.
struct TriangleGrid {
  explicit TriangleGrid(int pieces);

  int pieces;
  std::vector<GridPoint> points;                        ///< (n + 1)(n + 2)/2
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< n²
};

/// Numbers of the fine points of a mesh whose corners are welded into classes.
class FinePoints {
 public:
  /// `corner_class`: three a triangle, each below `classes`.
  FinePoints(std::span<const std::uint32_t> corner_class, std::uint32_t classes, int pieces);

  std::uint32_t count() const { return count_; }
  /// Of a point of triangle `t`.
  std::uint32_t number(std::size_t t, const GridPoint& point) const;

 private:
  std::uint32_t edge_point(std::size_t t, std::size_t from, std::uint32_t steps) const;

  std::span<const std::uint32_t> corner_class_;
  std::uint32_t pieces_;
  std::uint32_t classes_;
  std::vector<std::uint32_t> edge_;  ///< Three a triangle: corner k to corner k + 1
  std::uint32_t edges_ = 0;
  std::uint32_t count_ = 0;
};

}  // namespace barrido::scene
