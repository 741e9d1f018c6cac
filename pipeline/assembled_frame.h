// A frame between assembly and rasterization: its draws, compiled, with their vertices and primitives. For
// those who explain pixels and count work; drawing does not need it. Knows no pixels.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "pipeline/draw_plan.h"
#include "pipeline/geometry.h"
#include "pipeline/state.h"
#include "pipeline/vertex_stage.h"
#include "raster/fragments/primitive.h"
#include "raster/rasterizer.h"

namespace barrido::pipeline {

struct AssembledChunk {
  const raster::PrimitiveChunk* chunk = nullptr;
  /// For each of its primitives the number of the point, line or polygon of the draw that it is made of.
  std::vector<std::uint32_t> sources;
};

struct AssembledDraw {
  const DrawPlan* plan = nullptr;
  State state;
  Geometry geometry;
  TransformedVertices vertices;  ///< None where nothing was to be drawn.
  std::vector<AssembledChunk> chunks;
};

/// Filled by a Renderer that was given it. What it points to stays until Renderer::finish() or clear().
struct AssembledFrame {
  raster::ClearValues clear;
  std::deque<AssembledDraw> draws;  ///< One for each call of Renderer::draw(), in order.
};

}  // namespace barrido::pipeline
