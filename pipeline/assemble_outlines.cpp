// Points and lines, and polygons that are drawn as their corners or edges (GL_POLYGON_MODE). Edges are those
// of the polygon itself and those that clipping makes, never those that cut a quad into triangles.
#include <cmath>

#include "pipeline/assembly_steps.h"
#include "pipeline/bounded.h"

namespace barrido::pipeline {
namespace {

constexpr std::uint32_t kPointRejects = kOutsideVolume | kOffGuardBand | kNotANumber;

/// A point is seen when its middle is.
bool add_point(const AssemblyInput& input, std::uint32_t primitive, std::uint32_t vertex, bool back,
               ChunkWriter& writer) {
  const PackedPosition p = input.vertices.positions[vertex];
  if ((outcode(p) & kPointRejects) != 0 || plane_code(p) != 0) return false;
  writer.make_room(1);
  raster::PrimitiveRecord record{};
  record.x[0] = window_coordinate(p.x);
  record.y[0] = window_coordinate(p.y);
  record.vertex[0] = number_on_side(input, vertex, back);
  record.flat_and_facing = writer.flat_and_facing(primitive, back);
  writer.add(record);
  return true;
}

bool is_hidden(const PackedPosition& a, const PackedPosition& b) {
  return (outcode(a) & outcode(b) & kOutsideVolume) != 0 || (plane_code(a) & plane_code(b)) != 0 ||
         ((outcode(a) | outcode(b)) & kNotANumber) != 0;
}

bool needs_clipping(const PackedPosition& p) {
  return (outcode(p) & kNeedsClipping) != 0 || plane_code(p) != 0;
}

ClipCorners corners_between(const AssemblyInput& input, const std::array<std::uint32_t, 2>& ends,
                            const std::array<double, 2>& w, bool back) {
  ClipCorners corners;
  corners.count = 2;
  for (std::size_t k = 0; k < 2; ++k) {
    corners.vertex[k] = number_on_side(input, ends[k], back);
    corners.w[k] = w[k];
  }
  return corners;
}

void add_line_record(std::uint32_t primitive, const std::array<WindowVertex, 2>& window, bool back,
                     ChunkWriter& writer) {
  raster::PrimitiveRecord record{};
  for (std::size_t k = 0; k < 2; ++k) {
    record.x[k] = window[k].x;
    record.y[k] = window[k].y;
    record.vertex[k] = window[k].number;
  }
  record.flat_and_facing = writer.flat_and_facing(primitive, back);
  writer.add(record);
}

WindowVertex window_vertex(const AssemblyInput& input, const ClipVertex& vertex, const ClipCorners& corners,
                           ChunkWriter& writer) {
  WindowVertex window = window_position(input, vertex, corners);
  window.number = vertex_number(input, vertex, corners, writer);
  return window;
}

bool add_line(const AssemblyInput& input, std::uint32_t primitive, const std::array<std::uint32_t, 2>& ends,
              bool back, ChunkWriter& writer, AssemblyCounts& counts) {
  const std::array<PackedPosition, 2> positions{input.vertices.positions[ends[0]],
                                                input.vertices.positions[ends[1]]};
  if (is_hidden(positions[0], positions[1])) return false;
  writer.make_room(1);
  std::array<WindowVertex, 2> window;
  if (needs_clipping(positions[0]) || needs_clipping(positions[1])) {
    ClipVertex a = corner_in_clip_space(input, ends[0], 0);
    ClipVertex b = corner_in_clip_space(input, ends[1], 1);
    const ClipCorners corners = corners_between(input, ends, {a.w, b.w}, back);
    if (!clip_line(input.plan.transform, a, b)) return false;
    window = {window_vertex(input, a, corners, writer), window_vertex(input, b, corners, writer)};
    ++counts.clipped;
  } else {
    for (std::size_t k = 0; k < 2; ++k) {
      window[k] = {window_coordinate(positions[k].x), window_coordinate(positions[k].y),
                   number_on_side(input, ends[k], back)};
    }
  }
  add_line_record(primitive, window, back, writer);
  return true;
}

/// A corner that clipping made, as a point.
bool add_clipped_point(const AssemblyInput& input, std::uint32_t primitive, const ClipVertex& v,
                       const ClipCorners& corners, bool back, ChunkWriter& writer) {
  if (std::abs(v.x) > v.w || std::abs(v.y) > v.w) return false;
  writer.make_room(1);
  const WindowVertex window = window_vertex(input, v, corners, writer);
  raster::PrimitiveRecord record{};
  record.x[0] = window.x;
  record.y[0] = window.y;
  record.vertex[0] = window.number;
  record.flat_and_facing = writer.flat_and_facing(primitive, back);
  writer.add(record);
  return true;
}

/// Where an edge of a polygon begins, or comes into sight, as a point.
bool add_corner(const AssemblyInput& input, std::uint32_t primitive, const std::array<std::uint32_t, 2>& ends,
                bool back, ChunkWriter& writer) {
  const std::array<PackedPosition, 2> positions{input.vertices.positions[ends[0]],
                                                input.vertices.positions[ends[1]]};
  if (!needs_clipping(positions[0])) return add_point(input, primitive, ends[0], back, writer);
  if (is_hidden(positions[0], positions[1])) return false;
  ClipVertex a = corner_in_clip_space(input, ends[0], 0);
  ClipVertex b = corner_in_clip_space(input, ends[1], 1);
  const ClipCorners corners = corners_between(input, ends, {a.w, b.w}, back);
  return clip_line(input.plan.transform, a, b) &&
         add_clipped_point(input, primitive, a, corners, back, writer);
}

/// The edges that clipping makes are boundary edges as well (OpenGL 1.3, section 2.11), and where they begin
/// is a corner.
void add_closing_edges(const AssemblyInput& input, std::uint32_t polygon, bool back, ChunkWriter& writer) {
  const std::uint32_t size = input.corner_count();
  std::vector<ClipVertex> clip;
  for (std::uint32_t corner = 0; corner < size; ++corner) {
    const std::uint32_t vertex = input.corner_vertex(polygon, corner);
    if ((outcode(input.vertices.positions[vertex]) & kNotANumber) != 0) return;
    clip.push_back(corner_in_clip_space(input, vertex, 0));
  }
  for (const ClosingEdge& edge : closing_edges(input.plan.transform, clip)) {
    ClipCorners corners;
    corners.count = 4;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto corner = static_cast<std::uint32_t>(edge.corner[k]);
      corners.vertex[k] = number_on_side(input, input.corner_vertex(polygon, corner), back);
      corners.w[k] = clip[edge.corner[k]].w;
    }
    if (input.plan.topology == raster::Topology::points) {
      add_clipped_point(input, polygon, edge.from, corners, back, writer);
      continue;
    }
    writer.make_room(1);
    add_line_record(
        polygon,
        {window_vertex(input, edge.from, corners, writer), window_vertex(input, edge.to, corners, writer)},
        back, writer);
  }
}

/// Twice the area of the polygon in the window; exact where no corner lacks a window position. Else the sign
/// of det(x y w) of its triangles, which is that of the area of what is in front of the eye.
double facing_area(const AssemblyInput& input, std::uint32_t polygon) {
  const std::uint32_t size = input.corner_count();
  bool placed = true;
  for (std::uint32_t corner = 0; corner < size; ++corner) {
    const PackedPosition p = input.vertices.positions[input.corner_vertex(polygon, corner)];
    placed = placed && (outcode(p) & (kOffGuardBand | kNotANumber)) == 0;
  }
  struct Point {
    double x, y, w;
  };
  const auto point = [&](std::uint32_t corner) -> Point {
    const std::uint32_t vertex = input.corner_vertex(polygon, corner);
    if (placed) {
      const PackedPosition p = input.vertices.positions[vertex];
      return {static_cast<double>(window_coordinate(p.x)), static_cast<double>(window_coordinate(p.y)), 1.0};
    }
    const ClipVertex v = corner_in_clip_space(input, vertex, 0);
    return {v.x, v.y, v.w};
  };
  double area = 0.0;
  const Point a = point(0);
  for (std::uint32_t corner = 2; corner < size; ++corner) {
    const Point b = point(corner - 1);
    const Point c = point(corner);
    area += a.x * (b.y * c.w - c.y * b.w) - a.y * (b.x * c.w - c.x * b.w) + a.w * (b.x * c.y - c.x * b.y);
  }
  return area;
}

}  // namespace

void assemble_points(const AssemblyInput& input, std::uint32_t first, std::uint32_t count,
                     ChunkWriter& writer, AssemblyCounts& counts) {
  for (std::uint32_t i = first; i < first + count; ++i) {
    counts.culled += !add_point(input, i, input.vertex(i), false, writer);
  }
  counts.primitives += count;
}

void assemble_lines(const AssemblyInput& input, std::uint32_t first, std::uint32_t count, ChunkWriter& writer,
                    AssemblyCounts& counts) {
  for (std::uint32_t i = first; i < first + count; ++i) {
    const std::array<std::uint32_t, 2> ends{input.corner_vertex(i, 0), input.corner_vertex(i, 1)};
    counts.culled += !add_line(input, i, ends, false, writer, counts);
  }
  counts.primitives += count;
}

void assemble_outlines(const AssemblyInput& input, std::uint32_t first, std::uint32_t count,
                       ChunkWriter& writer, AssemblyCounts& counts) {
  const std::uint32_t size = input.corner_count();
  const CullRule& rule = input.plan.cull;
  for (std::uint32_t polygon = first; polygon < first + count; ++polygon) {
    const double area = facing_area(input, polygon);
    const bool back = area != 0.0 && (area > 0.0) != rule.front_is_counter_clockwise;
    counts.primitives += size;
    if (!(back ? rule.keep_back : rule.keep_front)) {
      counts.culled += size;
      continue;
    }
    bool clips = false;
    for (std::uint32_t corner = 0; corner < size; ++corner) {
      const std::uint32_t vertex = input.corner_vertex(polygon, corner);
      const std::uint32_t next = input.corner_vertex(polygon, corner + 1 == size ? 0 : corner + 1);
      const bool drawn = input.plan.topology == raster::Topology::points
                             ? add_corner(input, polygon, {vertex, next}, back, writer)
                             : add_line(input, polygon, {vertex, next}, back, writer, counts);
      counts.culled += !drawn;
      clips |= needs_clipping(input.vertices.positions[vertex]);
    }
    if (clips) add_closing_edges(input, polygon, back, writer);
  }
}

}  // namespace barrido::pipeline
