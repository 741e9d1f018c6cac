// A block of triangles in the window, and which of them are worth rasterizing.
#pragma once

#include <cstdint>

#include "pipeline/draw_plan.h"
#include "pipeline/packed_position.h"

namespace barrido::pipeline {

inline constexpr int kTriangleBlock = 64;

struct TriangleBlock {
  int count = 0;
  std::uint32_t vertex[3][kTriangleBlock];
  alignas(64) PackedPosition position[3][kTriangleBlock];
};

/// Bit i stands for triangle i of the block.
struct TriangleClasses {
  std::uint64_t visible = 0;  ///< Faces the right way, and may cover a pixel's centre.
  std::uint64_t clipped = 0;  ///< Crosses a clip plane; which way it faces is not known yet.
  std::uint64_t back = 0;     ///< Of the visible: seen from behind.
};

/// Sorts out triangles that lie wholly outside, face the wrong way (by the exact sign of their area between
/// snapped corners), have no area, or whose bounding box holds no pixel's centre, or few of which they cover
/// none.
TriangleClasses classify_triangles(const TriangleBlock& block, const CullRule& rule);

}  // namespace barrido::pipeline
