// Filled polygons: blocks of triangles are looked up and culled on vectors; the few that cross a clip plane
// are clipped one by one.
#include <bit>

#include "pipeline/assembly_steps.h"
#include "pipeline/triangle_block.h"

namespace barrido::pipeline {
namespace {

/// Looks up the corners of the triangles from `first`.
template <PrimitiveMode kMode>
void fill_block(const AssemblyInput& input, std::uint32_t first, TriangleBlock& block) {
  const PackedPosition* positions = input.vertices.positions;
  const std::uint32_t* indices = input.geometry.indices.empty() ? nullptr : input.geometry.indices.data();
  for (int i = 0; i < block.count; ++i) {
    const auto elements = triangle_elements(kMode, first + static_cast<std::uint32_t>(i));
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex =
          (indices != nullptr ? indices[elements[k]] : elements[k]) - input.vertices.first;
      block.vertex[k][i] = vertex;
      block.position[k][i] = positions[vertex];
    }
  }
}

using FillBlock = void (*)(const AssemblyInput&, std::uint32_t, TriangleBlock&);

FillBlock fill_block_of(PrimitiveMode mode) {
  switch (mode) {
    case PrimitiveMode::triangle_strip:
      return fill_block<PrimitiveMode::triangle_strip>;
    case PrimitiveMode::triangle_fan:
      return fill_block<PrimitiveMode::triangle_fan>;
    case PrimitiveMode::quads:
      return fill_block<PrimitiveMode::quads>;
    case PrimitiveMode::quad_strip:
      return fill_block<PrimitiveMode::quad_strip>;
    case PrimitiveMode::polygon:
      return fill_block<PrimitiveMode::polygon>;
    default:
      return fill_block<PrimitiveMode::triangles>;
  }
}

void add_whole(const AssemblyInput& input, const TriangleBlock& block, int i, std::uint32_t primitive,
               bool back, ChunkWriter& writer) {
  raster::PrimitiveRecord record;
  for (int k = 0; k < 3; ++k) {
    record.x[k] = window_coordinate(block.position[k][i].x);
    record.y[k] = window_coordinate(block.position[k][i].y);
    record.vertex[k] = number_on_side(input, block.vertex[k][i], back);
  }
  record.flat_and_facing = writer.flat_and_facing(primitive, back);
  writer.add(record);
}

std::int64_t doubled_area(const WindowVertex& a, const WindowVertex& b, const WindowVertex& c) {
  return static_cast<std::int64_t>(b.x - a.x) * (c.y - a.y) -
         static_cast<std::int64_t>(c.x - a.x) * (b.y - a.y);
}

using Window = std::array<WindowVertex, kMaxClipVertices>;

/// Twice the area of a fan.
std::int64_t doubled_area(const Window& window, std::size_t count) {
  std::int64_t area = 0;
  for (std::size_t i = 2; i < count; ++i) area += doubled_area(window[0], window[i - 1], window[i]);
  return area;
}

void add_fan(const Window& window, std::size_t count, std::uint32_t flat_and_facing, ChunkWriter& writer) {
  for (std::size_t i = 2; i < count; ++i) {
    if (doubled_area(window[0], window[i - 1], window[i]) == 0) continue;
    raster::PrimitiveRecord record;
    const std::array<const WindowVertex*, 3> corners{&window[0], &window[i - 1], &window[i]};
    for (std::size_t k = 0; k < 3; ++k) {
      record.x[k] = corners[k]->x;
      record.y[k] = corners[k]->y;
      record.vertex[k] = corners[k]->number;
    }
    record.flat_and_facing = flat_and_facing;
    writer.add(record);
  }
}

/// @return whether anything of the triangle is seen.
bool add_clipped(const AssemblyInput& input, const TriangleBlock& block, int i, std::uint32_t primitive,
                 ChunkWriter& writer) {
  ClipPolygon polygon;
  ClipCorners corners;
  polygon.count = corners.count = 3;
  for (std::size_t k = 0; k < 3; ++k) {
    polygon.vertices[k] = corner_in_clip_space(input, block.vertex[k][i], static_cast<int>(k));
    corners.w[k] = polygon.vertices[k].w;
    corners.vertex[k] = block.vertex[k][i];
  }
  clip_polygon(input.plan.transform, polygon);
  const auto count = static_cast<std::size_t>(polygon.count);
  if (count < 3) return false;
  Window window;
  for (std::size_t v = 0; v < count; ++v) window[v] = window_position(input, polygon.vertices[v], corners);
  const std::int64_t area = doubled_area(window, count);
  const CullRule& rule = input.plan.cull;
  const bool back = (area > 0) != rule.front_is_counter_clockwise;
  if (area == 0 || !(back ? rule.keep_back : rule.keep_front)) return false;

  for (std::uint32_t& vertex : corners.vertex) vertex = number_on_side(input, vertex, back);
  writer.make_room(kMaxClipVertices);
  for (std::size_t v = 0; v < count; ++v) {
    window[v].number = vertex_number(input, polygon.vertices[v], corners, writer);
  }
  add_fan(window, count, writer.flat_and_facing(primitive, back), writer);
  return true;
}

}  // namespace

void assemble_triangles(const AssemblyInput& input, std::uint32_t first, std::uint32_t count,
                        ChunkWriter& writer, AssemblyCounts& counts) {
  const PrimitiveMode mode = input.geometry.mode;
  const FillBlock fill = fill_block_of(mode);
  TriangleBlock block;
  for (std::uint32_t begin = first; begin < first + count; begin += kTriangleBlock) {
    block.count = static_cast<int>(std::min<std::uint32_t>(kTriangleBlock, first + count - begin));
    fill(input, begin, block);
    const TriangleClasses classes = classify_triangles(block, input.plan.cull);
    int drawn = 0;
    for (std::uint64_t left = classes.visible | classes.clipped; left != 0; left &= left - 1) {
      const int i = std::countr_zero(left);
      const std::uint32_t primitive = polygon_of_triangle(mode, begin + static_cast<std::uint32_t>(i));
      if ((classes.clipped >> i & 1) != 0) {
        const bool seen = add_clipped(input, block, i, primitive, writer);
        counts.clipped += seen;
        drawn += seen;
      } else {
        writer.make_room(1);
        add_whole(input, block, i, primitive, (classes.back >> i & 1) != 0, writer);
        ++drawn;
      }
    }
    counts.culled += static_cast<std::uint64_t>(block.count - drawn);
  }
  counts.primitives += count;
}

}  // namespace barrido::pipeline
