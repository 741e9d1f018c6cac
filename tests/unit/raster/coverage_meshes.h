// Meshes without cracks or overlaps for the coverage test: triangles that share edges, on the 1/256-pixel
// grid, together with the outline that they fill. Integers only.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace barrido::raster::testing {

struct GridPoint {
  std::int32_t x, y;  ///< 1/256 pixel.
};

struct Mesh {
  std::vector<GridPoint> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Counter-clockwise; some have no area.
  std::vector<GridPoint> outline;                       ///< The polygon they fill, closed by its first point.
};

/// columns × rows cells of `cell` units from `origin` on, whose corners are moved by up to `jitter` units
/// where that does not fold the mesh; diagonals at random.
Mesh jittered_grid(std::mt19937_64& bits, GridPoint origin, int columns, int rows, int cell, int jitter);

/// A fan of up to `count` triangles around `hub`: many more points than its outline has room for, so slivers.
Mesh sliver_fan(std::mt19937_64& bits, GridPoint hub, int count, int radius);

/// The square [-reach, reach]² split at random points, half of them in [0, width] × [0, height] (all in
/// units).
Mesh split_square(std::mt19937_64& bits, int reach, int points, int width, int height);

/// Whether the centre of a pixel is inside the outline. A centre on the outline counts as its neighbour
/// infinitesimally to the right, and far less above: the tie rule.
std::vector<bool> inside_outline(const Mesh& mesh, int width, int height);

}  // namespace barrido::raster::testing
