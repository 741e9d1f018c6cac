// One draw taken through the vertex stage and assembly, for looking at what comes out before it is
// rasterized.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "pipeline/assembly.h"
#include "pipeline/vertex_stage.h"

namespace barrido::pipeline {

struct Drawn {
  FragmentCounters counters;
  FrameMemory memory;
  std::unique_ptr<DrawPlan> plan;
  TransformedVertices vertices;
  std::vector<raster::PrimitiveChunk> chunks;
  AssemblyCounts counts;

  Drawn(const State& state, const Geometry& geometry, FrameSize frame = {256, 128, {}}) {
    plan = std::make_unique<DrawPlan>(state, geometry, frame, counters);
    vertices = allocate_vertices(*plan, 0, geometry.vertex_count, memory);
    for (std::uint32_t begin = 0; begin < geometry.vertex_count; begin += kVertexBatch) {
      const std::uint32_t count = std::min<std::uint32_t>(kVertexBatch, geometry.vertex_count - begin);
      run_vertex_stage(*plan, geometry, begin, static_cast<int>(count), vertices);
    }
    const AssemblyInput input{*plan, geometry, vertices};
    const std::uint32_t units = unit_count(input);
    for (std::uint32_t first = 0; first < units; first += kAssemblyUnits) {
      Assembled assembled = assemble(input, first, std::min(kAssemblyUnits, units - first));
      counts += assembled.counts;
      for (auto& chunk : assembled.chunks) chunks.push_back(std::move(chunk));
    }
  }

  const float* record(std::uint32_t vertex) const {
    return vertices.records + static_cast<std::size_t>(vertex) * static_cast<std::size_t>(vertices.stride);
  }
  /// Varying of a vertex, not divided by w any more.
  float varying(std::uint32_t vertex, int offset) const {
    const float value = record(vertex)[raster::kRecordVaryings + offset];
    return offset < plan->fragment.varyings.affine_count ? value : value / record(vertex)[raster::kRecordQ];
  }
  std::vector<raster::PrimitiveRecord> primitives() const {
    std::vector<raster::PrimitiveRecord> all;
    for (const auto& chunk : chunks) all.insert(all.end(), chunk.primitives.begin(), chunk.primitives.end());
    return all;
  }
};

/// Geometry over positions of three floats a vertex, which must outlive it.
inline Geometry geometry_of(const std::vector<float>& positions,
                            PrimitiveMode mode = PrimitiveMode::triangles) {
  Geometry geometry;
  geometry.mode = mode;
  geometry.vertex_count = static_cast<std::uint32_t>(positions.size() / 3);
  geometry.position = {positions.data(), 3, 3};
  return geometry;
}

}  // namespace barrido::pipeline
