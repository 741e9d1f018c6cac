// The vertex stage: from the caller's arrays in object space to vertex records in the window, each shared
// vertex once. Works on batches that are independent of each other, so that any number of threads may share
// them. Must not know: primitives.
#pragma once

#include <cstdint>

#include "pipeline/draw_plan.h"
#include "pipeline/frame_memory.h"
#include "pipeline/packed_position.h"
#include "raster/fragments/primitive.h"

namespace barrido::pipeline {

/// What lighting at a polygon's centroid needs of a corner. Eye space.
struct SurfaceVertex {
  float position[3];
  float normal[3];
  float color[4];
};

/// The vertices of one draw after the vertex stage; vertex v of the geometry is number v − first here. Arrays
/// that the plan does not need are null. `capacity` is count rounded up to whole vectors; what belongs to
/// back faces stands `capacity` elements behind.
struct TransformedVertices {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  std::uint32_t capacity = 0;
  int stride = 0;
  PackedPosition* positions = nullptr;
  float* records = nullptr;
  raster::FlatColors* flat_colors = nullptr;  ///< Where they are flat and lit at vertices.
  SurfaceVertex* surfaces = nullptr;          ///< Where they are lit at centroids.
};

/// Room for the vertices first … first + count − 1.
TransformedVertices allocate_vertices(const DrawPlan& plan, std::uint32_t first, std::uint32_t count,
                                      FrameMemory& memory);

/// Transforms and lights the vertices numbered begin … begin + count − 1 in `out`; `begin` is a multiple of
/// kVertexPadding and count at most kVertexBatch.
void run_vertex_stage(const DrawPlan& plan, const Geometry& geometry, std::uint32_t begin, int count,
                      const TransformedVertices& out);

}  // namespace barrido::pipeline
