// The order in which the triangles of all blended draws are drawn, as pieces of draws. Enters: draws and
// where the eye is; leaves: index lists. Knows no materials.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/geometry.h"
#include "pipeline/scene/sorting.h"

namespace barrido::scene {

/// A blended draw as far as its order goes.
struct BlendedDraw {
  const pipeline::Geometry* geometry = nullptr;
  EyeDistance distance;
  glm::vec3 center{0, 0, 0};  ///< Of points and lines, which stay together; object space
};

/// Triangles of one draw that follow each other.
struct BlendedPiece {
  std::size_t draw = 0;
  std::vector<std::uint32_t> indices;  ///< A triangle list; empty: the whole draw, points or lines
};

struct BlendedOrder {
  std::vector<BlendedPiece> pieces;
  int slices = 0;  ///< 0: every triangle has its place; else only its slice of so many along the view.
};

/// Farthest first by the middles of the triangles; of equals the draws in order, and in each its triangles.
/// Where draws lie within each other so often that the pieces would take longer to set up than to draw, the
/// depth of the scene is cut into slices, and within each the draws stay together.
BlendedOrder order_blended(std::span<const BlendedDraw> draws);

}  // namespace barrido::scene
