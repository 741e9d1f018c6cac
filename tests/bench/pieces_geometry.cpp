// From vertex arrays to binned triangles, one step at a time, on W8's ellipsoid. One thread.
#include <benchmark/benchmark.h>

#include "pipeline/assembly.h"
#include "pipeline/draw_plan.h"
#include "pipeline/vertex_stage.h"
#include "raster/tiles/binning.h"
#include "tests/bench/workloads.h"

namespace barrido::bench {
namespace {

/// A draw whose vertices are transformed, with what that takes.
struct PreparedDraw {
  explicit PreparedDraw(const EllipsoidOptions& options, bool lit = true) : scene(ellipsoid({}, options)) {
    pipeline::State& state = scene.draws[0].state;
    state.lighting.enabled = lit;
    geometry = scene.draws[0].mesh.geometry();
    plan = std::make_unique<pipeline::DrawPlan>(state, geometry,
                                                pipeline::FrameSize{scene.width, scene.height, {}}, counters);
    vertices = pipeline::allocate_vertices(*plan, 0, geometry.vertex_count, memory);
    transform();
  }

  void transform() const {
    for (std::uint32_t begin = 0; begin < vertices.count; begin += pipeline::kVertexBatch) {
      const std::uint32_t count = std::min<std::uint32_t>(pipeline::kVertexBatch, vertices.count - begin);
      pipeline::run_vertex_stage(*plan, geometry, begin, static_cast<int>(count), vertices);
    }
  }

  ScenePair scene;
  pipeline::Geometry geometry;
  pipeline::FragmentCounters counters;
  pipeline::FrameMemory memory;
  std::unique_ptr<pipeline::DrawPlan> plan;
  pipeline::TransformedVertices vertices;
};

void report_items(benchmark::State& state, std::size_t items) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(items));
}

void vertex_transform(benchmark::State& state) {
  const PreparedDraw draw({}, false);
  for (auto _ : state) draw.transform();
  report_items(state, draw.vertices.count);
}
BENCHMARK(vertex_transform)->Unit(benchmark::kMicrosecond);

/// Transform and illumination by so many lights.
void vertex_transform_and_lights(benchmark::State& state) {
  EllipsoidOptions options;
  options.lights = static_cast<int>(state.range(0));
  const PreparedDraw draw(options);
  for (auto _ : state) draw.transform();
  report_items(state, draw.vertices.count);
}
BENCHMARK(vertex_transform_and_lights)->Arg(1)->Arg(8)->Unit(benchmark::kMicrosecond);

template <class Use>
std::size_t assemble_all(const PreparedDraw& draw, Use use) {
  const pipeline::AssemblyInput input{*draw.plan, draw.geometry, draw.vertices, false};
  const std::uint32_t units = pipeline::unit_count(input);
  for (std::uint32_t first = 0; first < units; first += pipeline::kAssemblyUnits) {
    use(pipeline::assemble(input, first, std::min(pipeline::kAssemblyUnits, units - first)));
  }
  return units;
}

void assembly(benchmark::State& state) {
  const PreparedDraw draw{{}};
  std::size_t triangles = 0;
  for (auto _ : state) {
    triangles = assemble_all(draw, [](pipeline::Assembled&& run) { benchmark::DoNotOptimize(run); });
  }
  report_items(state, triangles);
}
BENCHMARK(assembly)->Unit(benchmark::kMicrosecond);

void assembly_and_binning(benchmark::State& state) {
  const PreparedDraw draw{{}};
  const raster::TileGrid grid(draw.scene.width, draw.scene.height);
  std::size_t triangles = 0;
  for (auto _ : state) {
    triangles = assemble_all(draw, [&grid](pipeline::Assembled&& run) {
      for (raster::PrimitiveChunk& chunk : run.chunks) {
        benchmark::DoNotOptimize(raster::BinnedChunk(std::move(chunk), grid, raster::ColorFormat::rgba8));
      }
    });
  }
  report_items(state, triangles);
}
BENCHMARK(assembly_and_binning)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace barrido::bench
