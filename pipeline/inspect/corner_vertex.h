// A vertex sent through the vertex stage once more, to see what it gave to the frame. Enters: a draw and a
// vertex number; leaves: its record, surface and lit colours, the same bits as in the frame.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/frame_memory.h"
#include "pipeline/inspect/fragment_story.h"
#include "pipeline/inspect/illumination_story.h"

namespace barrido::inspect {

class VertexAgain {
 public:
  VertexAgain(const pipeline::AssembledDraw& draw, std::uint32_t vertex);

  glm::vec3 object() const;
  glm::vec3 normal() const;  ///< Eye space; 0 where the draw has none.
  pipeline::reference::SurfacePoint point(bool back) const;
  /// Depth, 1/w and varyings, those of perspective already divided by w.
  const float* record(bool back) const;
  /// Lit colours of Gouraud and flat shading at the provoking vertex; else null.
  const raster::FlatColors* lit(bool back) const;
  const pipeline::PackedPosition& window() const { return *out_.positions; }

 private:
  const pipeline::AssembledDraw& draw_;
  std::uint32_t vertex_;
  pipeline::FrameMemory memory_;
  pipeline::TransformedVertices out_;
};

/// Numbers of the corners of what a primitive is made of, in the draw's arrays: of the whole triangle where
/// clipping left a piece; none for lines that were clipped.
std::vector<std::uint32_t> corner_vertices(const FrameChunk& place, const raster::PrimitiveRecord& primitive,
                                           std::uint32_t source);

/// Whether a corner of the primitive was made by clipping.
bool is_clipped(const raster::PrimitiveChunk& chunk, const raster::PrimitiveRecord& primitive);

/// Whether the polygon that a primitive is made of is seen from behind; never for points and lines of the
/// file.
bool faces_back(const FrameChunk& place, const raster::PrimitiveRecord& primitive, std::uint32_t source);

}  // namespace barrido::inspect
