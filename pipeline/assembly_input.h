// What primitive assembly reads: one draw's plan, its transformed vertices, and the elements that its
// primitives are made of.
#pragma once

#include <cstdint>

#include "pipeline/draw_plan.h"
#include "pipeline/primitive_mode.h"
#include "pipeline/vertex_stage.h"

namespace barrido::pipeline {

struct AssemblyInput {
  const DrawPlan& plan;
  const Geometry& geometry;
  const TransformedVertices& vertices;
  bool with_sources = false;  ///< Whether to remember what each primitive is made of.

  std::uint32_t element_count() const {
    return geometry.indices.empty() ? geometry.vertex_count
                                    : static_cast<std::uint32_t>(geometry.indices.size());
  }

  /// Number (in `vertices`) of the vertex that an element stands for.
  std::uint32_t vertex(std::uint32_t element) const {
    return (geometry.indices.empty() ? element : geometry.indices[element]) - vertices.first;
  }

  // A primitive is a point, line or polygon of the mode.
  std::uint32_t corner_count() const {
    if (geometry.mode == PrimitiveMode::points) return 1;
    return is_polygonal(geometry.mode) ? polygon_size(geometry.mode, element_count()) : 2;
  }

  std::uint32_t corner_vertex(std::uint32_t primitive, std::uint32_t corner) const {
    if (geometry.mode == PrimitiveMode::points) return vertex(primitive);
    if (is_polygonal(geometry.mode)) return vertex(polygon_corner(geometry.mode, primitive, corner));
    return vertex(line_elements(geometry.mode, primitive, element_count())[corner]);
  }

  std::uint32_t provoking_vertex(std::uint32_t primitive) const {
    return is_polygonal(geometry.mode) ? vertex(provoking_element(geometry.mode, primitive))
                                       : corner_vertex(primitive, corner_count() - 1);
  }
};

/// What assembly did; see Statistics.
struct AssemblyCounts {
  std::uint64_t primitives = 0;
  std::uint64_t culled = 0;
  std::uint64_t clipped = 0;
  std::uint64_t illuminations = 0;
  std::uint64_t powers = 0;

  AssemblyCounts& operator+=(const AssemblyCounts& other) {
    primitives += other.primitives;
    culled += other.culled;
    clipped += other.clipped;
    illuminations += other.illuminations;
    powers += other.powers;
    return *this;
  }
};

}  // namespace barrido::pipeline
