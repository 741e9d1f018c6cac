// Clipping in homogeneous clip space (Sutherland and Hodgman 1974). Polygons are only cut at the near and far
// planes, at user planes, and at a guard band around the frame that few reach; the rasterizer and the scissor
// do the rest.
//
// A point on an edge is always computed from the inside towards the outside. So triangles that share an edge
// get the same point on it from either side, bit for bit. For the same reason a plane is applied to every
// polygon that crosses it, and never cuts an edge that lies inside it.
#pragma once

#include <array>

#include "pipeline/vertex_batch.h"

namespace barrido::pipeline {

/// A triangle cut by seven planes of the volume and the user's.
inline constexpr int kMaxClipVertices = 3 + 7 + kMaxClipPlanes;

/// A corner of the polygon that is being clipped. Clip space.
struct ClipVertex {
  double x = 0, y = 0, z = 0, w = 1;
  /// Share of each of the primitive's own corners; they sum to 1. On an edge the third is exactly 0.
  std::array<double, 3> weight{};
  /// Distances to the user planes, positive inside.
  std::array<double, kMaxClipPlanes> plane_distance{};
  int corner = -1;  ///< The primitive's corner that this still is, or −1.
};

/// A corner as the vertex stage projects it: the same operations on floats, so the same bits.
ClipVertex clip_vertex(const VertexTransform& transform, const glm::vec4& object_position, int corner);

struct ClipPolygon {
  int count = 0;
  std::array<ClipVertex, kMaxClipVertices> vertices;
};

/// Cuts away what is outside; the order of corners stays. The polygon may come out empty.
void clip_polygon(const VertexTransform& transform, ClipPolygon& polygon);

/// The same for a line of two vertices. @return whether anything is left.
bool clip_line(const VertexTransform& transform, ClipVertex& a, ClipVertex& b);

}  // namespace barrido::pipeline
