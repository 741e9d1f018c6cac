// The page that shows the flow of one draw:
//
//   geometry ──▶ vertex stage ──▶ assembly: cull, clip ──▶ bin ──▶ submit
//   (object)     (eye, clip, window)  (triangles in the window)    (tiles, in drawing order)
//
// Vertices are worked on in batches and primitives in runs, both of fixed size, by any number of threads;
// runs are submitted in order. So nothing that is drawn depends on the number of threads.
#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include <tbb/parallel_for.h>

#include "pipeline/assembled_frame.h"
#include "pipeline/assembly.h"
#include "pipeline/frame.h"
#include "pipeline/index_range.h"
#include "pipeline/vertex_stage.h"
#include "raster/tiles/binning.h"

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

/// A run of primitives on its way to the rasterizer.
struct Run {
  std::vector<std::unique_ptr<raster::BinnedChunk>> chunks;
  std::vector<std::vector<std::uint32_t>> sources;
  AssemblyCounts counts;
};

Run assemble_and_bin(const Frame& frame, const AssemblyInput& input, std::uint32_t first,
                     std::uint32_t count) {
  raster::StageClock clock(frame.profile, raster::Stage::assembly);
  Assembled assembled = assemble(input, first, count);
  clock.stop();
  Run run;
  run.counts = assembled.counts;
  run.sources = std::move(assembled.sources);
  for (raster::PrimitiveChunk& chunk : assembled.chunks)
    run.chunks.push_back(frame.rasterizer.bin(std::move(chunk)));
  return run;
}

void count_vertices(const DrawPlan& plan, std::uint32_t vertices, Frame& frame) {
  frame.statistics.vertices += vertices;
  const std::uint64_t lights = plan.illumination ? plan.illumination->lights.size() : 0;
  for (int side = 0; side < plan.sides(); ++side) {
    int powers = 0;
    if (plan.origin.makes_vertex_products()) {
      powers = cheap_phong_vertex_powers(*plan.illumination, side);
    } else if (plan.illumination && plan.origin.at_vertices) {
      powers = plan.illumination->powers_per_point(side);
    }
    if (plan.origin.at_vertices) frame.statistics.illuminations_vertex += vertices * lights;
    frame.powers_before_fragments += vertices * static_cast<std::uint64_t>(powers);
  }
}

void count_primitives(const AssemblyCounts& counts, Frame& frame) {
  Statistics& statistics = frame.statistics;
  statistics.primitives_in += counts.primitives;
  statistics.primitives_culled += counts.culled;
  statistics.primitives_clipped += counts.clipped;
  statistics.illuminations_vertex += counts.illuminations;
  frame.powers_before_fragments += counts.powers;
}

/// Before the run is submitted.
void remember(const Run& run, AssembledDraw& draw) {
  for (std::size_t i = 0; i < run.chunks.size(); ++i) {
    draw.chunks.push_back({&run.chunks[i]->chunk(), run.sources[i]});
  }
}

}  // namespace

void draw(Frame& frame, const State& state, const Geometry& geometry) {
  const DrawPlan& plan = frame.plans.emplace_back(state, geometry, frame.size, frame.fragment_counters);
  AssembledDraw* record = nullptr;
  if (frame.record != nullptr) record = &frame.record->draws.emplace_back();
  if (record != nullptr) *record = {&plan, state, geometry, {}, {}};
  if (geometry.vertex_count == 0 && geometry.indices.empty()) return;
  const IndexRange used = vertices_used(geometry);
  ++frame.statistics.draws;

  // Vertices.
  const TransformedVertices vertices =
      allocate_vertices(plan, used.smallest, used.largest - used.smallest + 1, frame.memory);
  for_each_piece(vertices.count, kVertexBatch, [&](std::uint32_t begin, std::uint32_t count) {
    const raster::StageClock clock(frame.profile, raster::Stage::vertices);
    run_vertex_stage(plan, geometry, begin, static_cast<int>(count), vertices);
  });
  count_vertices(plan, vertices.count, frame);
  if (record != nullptr) record->vertices = vertices;

  // Primitives.
  const AssemblyInput input{plan, geometry, vertices, record != nullptr};
  const std::uint32_t units = unit_count(input);
  std::vector<Run> runs(units / kAssemblyUnits + 1);
  for_each_piece(units, kAssemblyUnits, [&](std::uint32_t first, std::uint32_t count) {
    runs[first / kAssemblyUnits] = assemble_and_bin(frame, input, first, count);
  });
  for (Run& run : runs) {
    if (record != nullptr) remember(run, *record);
    for (auto& chunk : run.chunks) frame.rasterizer.submit(std::move(chunk));
    count_primitives(run.counts, frame);
  }
}

}  // namespace barrido::pipeline
