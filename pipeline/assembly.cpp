#include "pipeline/assembly.h"

#include <algorithm>
#include <cmath>

#include "pipeline/assembly_steps.h"
#include "pipeline/bounded.h"

namespace barrido::pipeline {
namespace {

/// As the vertex stage reads it: missing components are (0, 0, 0, 1).
glm::vec4 object_position(const AssemblyInput& input, std::uint32_t vertex) {
  const Attribute& a = input.geometry.position;
  const float* from =
      a.data + static_cast<std::size_t>(vertex + input.vertices.first) * static_cast<std::size_t>(a.stride);
  glm::vec4 p{0, 0, 0, 1};
  for (int c = 0; c < a.components; ++c) p[c] = from[c];
  return p;
}

/// The vertex stage's position of a corner that clipping left alone; null where it has none.
const PackedPosition* untouched(const AssemblyInput& input, const ClipVertex& vertex,
                                const ClipCorners& corners) {
  if (vertex.corner < 0) return nullptr;
  const std::uint32_t number = corners.vertex[static_cast<std::size_t>(vertex.corner)];
  const std::uint32_t capacity = input.vertices.capacity;
  const PackedPosition* p = input.vertices.positions + (number < capacity ? number : number - capacity);
  return (outcode(*p) & kOffGuardBand) == 0 ? p : nullptr;
}

std::int32_t snapped(double window) {
  // Clipping has made sure of the guard band up to rounding; this makes sure of the rounding.
  constexpr double kLimit = kGuardLimitPixels + 2.0f;
  return static_cast<std::int32_t>(
      std::floor(std::clamp(window, -kLimit, kLimit) * raster::kSubpixelUnits + 0.5));
}

}  // namespace

std::uint32_t unit_count(const AssemblyInput& input) {
  const PrimitiveMode mode = input.geometry.mode;
  const std::uint32_t elements = input.element_count();
  if (mode == PrimitiveMode::points) return elements;
  if (!is_polygonal(mode)) return line_count(mode, elements);
  return input.plan.topology == raster::Topology::triangles ? triangle_count(mode, elements)
                                                            : polygon_count(mode, elements);
}

Assembled assemble(const AssemblyInput& input, std::uint32_t first, std::uint32_t count) {
  Assembled result;
  ChunkWriter writer(input, count, result.counts);
  if (input.geometry.mode == PrimitiveMode::points) {
    assemble_points(input, first, count, writer, result.counts);
  } else if (!is_polygonal(input.geometry.mode)) {
    assemble_lines(input, first, count, writer, result.counts);
  } else if (input.plan.topology == raster::Topology::triangles) {
    assemble_triangles(input, first, count, writer, result.counts);
  } else {
    assemble_outlines(input, first, count, writer, result.counts);
  }
  result.chunks = writer.take();
  result.sources = writer.take_sources();
  return result;
}

ClipVertex corner_in_clip_space(const AssemblyInput& input, std::uint32_t vertex, int corner) {
  return clip_vertex(input.plan.transform, object_position(input, vertex), corner);
}

WindowVertex window_position(const AssemblyInput& input, const ClipVertex& vertex,
                             const ClipCorners& corners) {
  if (const PackedPosition* p = untouched(input, vertex, corners)) {
    return {window_coordinate(p->x), window_coordinate(p->y), 0};
  }
  const glm::vec3& scale = input.plan.transform.window_scale;
  const glm::vec3& offset = input.plan.transform.window_offset;
  return {snapped(vertex.x / vertex.w * scale.x + offset.x),
          snapped(vertex.y / vertex.w * scale.y + offset.y), 0};
}

std::uint32_t vertex_number(const AssemblyInput& input, const ClipVertex& vertex, const ClipCorners& corners,
                            ChunkWriter& writer) {
  if (untouched(input, vertex, corners) != nullptr) {
    return corners.vertex[static_cast<std::size_t>(vertex.corner)];
  }
  return writer.add_vertex(vertex, corners);
}

}  // namespace barrido::pipeline
