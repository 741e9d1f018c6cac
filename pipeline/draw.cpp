// The page that shows how a frame is made:
//
//   State, Geometry ──▶ DrawPlan            the state compiled once: light, varyings, a fragment's stages
//        │                                  (draw_plan.cpp)
//        ▼
//   vertices ──▶ transform, light ──▶       one record a vertex: window position, depth, 1/w, varyings
//        │                                  (vertex_stage.cpp)
//        ▼
//   primitives ──▶ cull, clip ──▶           chunks of triangles, lines, points in the window (assembly.cpp)
//        │
//        ▼
//   bin ──▶ submit                          which chunks touch which tile (raster/tiles/binning.cpp)
//        │   draw() ends here; finish() goes on, each tile on one thread (raster/rasterizer.cpp):
//        ▼
//   tile: visible spans ──▶ fragments ──▶   raster/kernels/tile_raster.cpp, span_shader-inl.h
//         stages: light, textures, fog ──▶  raster/shade_batch.cpp
//         alpha test, blending ──▶          raster/kernels/write.cpp
//         resolve ──▶ the framebuffer       raster/kernels/resolve.cpp, tile_memory.cpp
//
// Vertices are worked on in batches and primitives in runs, both of fixed size, by any number of threads;
// runs are submitted in order. So nothing that is drawn depends on the number of threads.
#include <algorithm>
#include <stdexcept>
#include <string>

#include <tbb/parallel_for.h>

#include "pipeline/draw_ledger.h"
#include "pipeline/index_range.h"
#include "pipeline/vertex_stage.h"

namespace barrido::pipeline {
namespace {

/// Calls work(first, count) for consecutive pieces of [0, total). A single piece costs no more than the call.
template <class Work>
void for_each_piece(std::uint32_t total, std::uint32_t size, const Work& work) {
  const std::uint32_t pieces = total / size + (total % size != 0);
  if (pieces == 1) return work(0, total);
  tbb::parallel_for(std::uint32_t{0}, pieces,
                    [&](std::uint32_t piece) { work(piece * size, std::min(size, total - piece * size)); });
}

/// The vertices that are used, all indices checked.
IndexRange vertices_used(const Geometry& geometry) {
  if (geometry.indices.empty()) return {0, geometry.vertex_count - 1};
  const IndexRange range = index_range(geometry.indices);
  if (range.largest >= geometry.vertex_count) {
    throw std::out_of_range("index " + std::to_string(range.largest) + " of a draw with " +
                            std::to_string(geometry.vertex_count) + " vertices");
  }
  return range;
}

TransformedVertices transform_vertices(Frame& frame, const DrawPlan& plan, const Geometry& geometry) {
  const IndexRange used = vertices_used(geometry);
  const TransformedVertices vertices =
      allocate_vertices(plan, used.smallest, used.largest - used.smallest + 1, frame.memory);
  for_each_piece(vertices.count, kVertexBatch, [&](std::uint32_t begin, std::uint32_t count) {
    const raster::StageClock clock(frame.profile, raster::Stage::vertices);
    run_vertex_stage(plan, geometry, begin, static_cast<int>(count), vertices);
  });
  return vertices;
}

Run assemble_and_bin(const Frame& frame, const AssemblyInput& input, std::uint32_t first,
                     std::uint32_t count) {
  raster::StageClock clock(frame.profile, raster::Stage::assembly);
  Assembled assembled = assemble(input, first, count);
  clock.stop();
  Run run{{}, std::move(assembled.sources), assembled.counts};
  for (raster::PrimitiveChunk& chunk : assembled.chunks)
    run.chunks.push_back(frame.rasterizer.bin(std::move(chunk)));
  return run;
}

std::vector<Run> assemble_runs(const Frame& frame, const AssemblyInput& input) {
  const std::uint32_t units = unit_count(input);
  std::vector<Run> runs(units / kAssemblyUnits + 1);
  for_each_piece(units, kAssemblyUnits, [&](std::uint32_t first, std::uint32_t count) {
    runs[first / kAssemblyUnits] = assemble_and_bin(frame, input, first, count);
  });
  return runs;
}

}  // namespace

void draw(Frame& frame, const State& state, const Geometry& geometry) {
  const DrawPlan& plan = frame.plans.emplace_back(state, geometry, frame.size, frame.fragment_counters);
  DrawLedger ledger(frame, plan, state, geometry);
  if (geometry.vertex_count == 0 && geometry.indices.empty()) return;
  const TransformedVertices vertices = transform_vertices(frame, plan, geometry);
  ledger.add(vertices);
  for (Run& run : assemble_runs(frame, {plan, geometry, vertices, ledger.wants_sources()})) {
    ledger.add(run);
    for (auto& chunk : run.chunks) frame.rasterizer.submit(std::move(chunk));
  }
}

void finish(Frame& frame) {
  frame.rasterizer.flush();  // every tile, from visibility to the framebuffer
  frame.release_draws();
}

}  // namespace barrido::pipeline
