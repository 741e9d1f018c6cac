// Clipping in homogeneous clip space (Sutherland and Hodgman 1974). Polygons are only cut at the near and far
// planes, at user planes, and at a guard band around the frame that few reach; the rasterizer and the scissor
// do the rest.
//
// A point on an edge is always computed from the inside towards the outside. So triangles that share an edge
// get the same point on it from either side, bit for bit. For the same reason a plane is applied to every
// polygon that crosses it, and never cuts an edge that lies inside it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "pipeline/vertex_batch.h"

namespace barrido::pipeline {

/// A triangle cut by seven planes of the volume and the user's.
inline constexpr int kMaxClipVertices = 3 + 7 + kMaxClipPlanes;

/// A corner of the polygon that is being clipped. Clip space.
struct ClipVertex {
  double x = 0, y = 0, z = 0, w = 1;
  /// Share of each of the primitive's own corners; they sum to 1. On an edge all but two are exactly 0. Only
  /// the edge that closes a cut polygon has four.
  std::array<double, 4> weight{};
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

/// An edge that clipping makes: where a polygon leaves the inside of a plane and comes back, joined along the
/// plane, because the outline must stay closed (OpenGL 1.3, section 2.11). The four weights of both ends
/// belong to these corners of the polygon: the last inside, the first outside, the last outside, the next
/// inside.
struct ClosingEdge {
  ClipVertex from, to;
  std::array<std::size_t, 4> corner{};
};

/// The closing edges of a convex polygon at the near and far planes and the user's, as far as the other
/// planes leave them. None along the sides of the frame, where a line may fall on either side of the border.
std::vector<ClosingEdge> closing_edges(const VertexTransform& transform, std::span<const ClipVertex> polygon);

}  // namespace barrido::pipeline
