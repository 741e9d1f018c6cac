#include "pipeline/clip.h"

#include <algorithm>
#include <optional>

#include "pipeline/bounded.h"

namespace barrido::pipeline {
namespace {

enum Plane { kNear, kFar, kPositiveW, kGuardLeft, kGuardRight, kGuardBottom, kGuardTop, kFirstUserPlane };

/// Distance of a vertex to a plane, not below 0 inside.
double distance(const VertexTransform& transform, const ClipVertex& v, int plane) {
  // A pixel wider than the test of the vertex stage, so that no vertex which passed that is cut here.
  constexpr double kGuard = kGuardLimitPixels + 1.0f;
  const auto& scale = transform.window_scale;
  const auto& offset = transform.window_offset;
  switch (plane) {
    case kNear:
      return v.w + v.z;
    case kFar:
      return v.w - v.z;
    case kPositiveW:
      return v.w - static_cast<double>(kMinW);
    case kGuardLeft:
      return scale.x * v.x + (kGuard + offset.x) * v.w;
    case kGuardRight:
      return (kGuard - offset.x) * v.w - scale.x * v.x;
    case kGuardBottom:
      return scale.y * v.y + (kGuard + offset.y) * v.w;
    case kGuardTop:
      return (kGuard - offset.y) * v.w - scale.y * v.y;
    default:
      return v.plane_distance[static_cast<std::size_t>(plane - kFirstUserPlane)];
  }
}

int plane_end(const VertexTransform& transform) { return kFirstUserPlane + transform.plane_count; }

bool applies(const VertexTransform& transform, int plane) {
  return !(transform.depth_clamp && (plane == kNear || plane == kFar));
}

/// The point where the edge leaves the plane.
ClipVertex intersection(const ClipVertex& inside, double d_inside, const ClipVertex& outside,
                        double d_outside) {
  const double t = d_inside / (d_inside - d_outside);
  const auto mix = [t](double from, double to) { return from + t * (to - from); };
  ClipVertex v;
  v.x = mix(inside.x, outside.x);
  v.y = mix(inside.y, outside.y);
  v.z = mix(inside.z, outside.z);
  v.w = mix(inside.w, outside.w);
  for (std::size_t i = 0; i < v.weight.size(); ++i) v.weight[i] = mix(inside.weight[i], outside.weight[i]);
  for (std::size_t i = 0; i < v.plane_distance.size(); ++i) {
    v.plane_distance[i] = mix(inside.plane_distance[i], outside.plane_distance[i]);
  }
  return v;
}

void clip_at(const VertexTransform& transform, int plane, ClipPolygon& polygon) {
  std::array<double, kMaxClipVertices> d;
  bool crosses = false;
  for (int i = 0; i < polygon.count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    d[at] = distance(transform, polygon.vertices[at], plane);
    crosses |= d[at] < 0.0;
  }
  if (!crosses) return;
  ClipPolygon result;
  const auto add = [&result](const ClipVertex& v) {
    // Rounding can make a polygon very slightly concave, and cut it more often than a convex one can be.
    if (result.count < kMaxClipVertices) result.vertices[static_cast<std::size_t>(result.count++)] = v;
  };
  for (int i = 0; i < polygon.count; ++i) {
    const auto a = static_cast<std::size_t>(i);
    const auto b = static_cast<std::size_t>(i + 1 == polygon.count ? 0 : i + 1);
    const bool a_inside = d[a] >= 0.0;
    const bool b_inside = d[b] >= 0.0;
    if (a_inside) add(polygon.vertices[a]);
    if (a_inside && !b_inside) add(intersection(polygon.vertices[a], d[a], polygon.vertices[b], d[b]));
    if (!a_inside && b_inside) add(intersection(polygon.vertices[b], d[b], polygon.vertices[a], d[a]));
  }
  polygon = result;
}

/// What is left has a positive w, but where it is tiny beside the w of the corners, rounding may have taken
/// it away.
void keep_positive(ClipVertex& v) { v.w = std::max(v.w, static_cast<double>(kMinW)); }

constexpr int kNoPlane = -1;

/// Cuts a line at all planes but one, on which it may lie.
bool clip_line_but(const VertexTransform& transform, int left_out, ClipVertex& a, ClipVertex& b) {
  for (int plane = 0; plane < plane_end(transform); ++plane) {
    if (plane == left_out || !applies(transform, plane)) continue;
    const double d_a = distance(transform, a, plane);
    const double d_b = distance(transform, b, plane);
    if (d_a < 0.0 && d_b < 0.0) return false;
    if (d_a < 0.0) {
      a = intersection(b, d_b, a, d_a);
    } else if (d_b < 0.0) {
      b = intersection(a, d_a, b, d_b);
    }
  }
  keep_positive(a);
  keep_positive(b);
  return true;
}

std::optional<ClosingEdge> closing_edge(const VertexTransform& transform, std::span<const ClipVertex> polygon,
                                        int plane) {
  ClosingEdge edge;
  int crossings = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t next = i + 1 == polygon.size() ? 0 : i + 1;
    const double d = distance(transform, polygon[i], plane);
    const double d_next = distance(transform, polygon[next], plane);
    if ((d >= 0.0) == (d_next >= 0.0)) continue;
    ++crossings;
    const bool leaves = d >= 0.0;
    const std::size_t at = leaves ? 0 : 2;
    edge.corner[at] = i;
    edge.corner[at + 1] = next;
    ClipVertex a = polygon[i], b = polygon[next];
    a.corner = b.corner = -1;
    a.weight = b.weight = {};
    a.weight[at] = b.weight[at + 1] = 1.0;
    (leaves ? edge.from : edge.to) = leaves ? intersection(a, d, b, d_next) : intersection(b, d_next, a, d);
  }
  // A convex polygon is left once at most.
  if (crossings != 2 || !clip_line_but(transform, plane, edge.from, edge.to)) return std::nullopt;
  return edge;
}

float row_times(const glm::mat4& m, int row, const glm::vec4& p) {
  return ((m[0][row] * p.x + m[1][row] * p.y) + m[2][row] * p.z) + m[3][row] * p.w;
}

}  // namespace

ClipVertex clip_vertex(const VertexTransform& transform, const glm::vec4& object_position, int corner) {
  const glm::vec4& p = object_position;
  ClipVertex v;
  v.x = row_times(transform.clip_from_object, 0, p);
  v.y = row_times(transform.clip_from_object, 1, p);
  v.z = row_times(transform.clip_from_object, 2, p);
  v.w = transform.unit_w ? 1.0f : row_times(transform.clip_from_object, 3, p);
  for (int i = 0; i < transform.plane_count; ++i) {
    const glm::vec4& plane = transform.planes[i];
    v.plane_distance[static_cast<std::size_t>(i)] =
        ((plane.x * p.x + plane.y * p.y) + plane.z * p.z) + plane.w * p.w;
  }
  v.corner = corner;
  v.weight[static_cast<std::size_t>(corner)] = 1.0;
  return v;
}

void clip_polygon(const VertexTransform& transform, ClipPolygon& polygon) {
  for (int plane = 0; plane < plane_end(transform) && polygon.count > 0; ++plane) {
    if (applies(transform, plane)) clip_at(transform, plane, polygon);
  }
  for (int i = 0; i < polygon.count; ++i) keep_positive(polygon.vertices[static_cast<std::size_t>(i)]);
}

bool clip_line(const VertexTransform& transform, ClipVertex& a, ClipVertex& b) {
  return clip_line_but(transform, kNoPlane, a, b);
}

std::vector<ClosingEdge> closing_edges(const VertexTransform& transform,
                                       std::span<const ClipVertex> polygon) {
  std::vector<ClosingEdge> edges;
  for (int plane = 0; plane < plane_end(transform); ++plane) {
    const bool guards = plane >= kPositiveW && plane < kFirstUserPlane;
    if (guards || !applies(transform, plane)) continue;
    if (const std::optional<ClosingEdge> edge = closing_edge(transform, polygon, plane))
      edges.push_back(*edge);
  }
  return edges;
}

}  // namespace barrido::pipeline
