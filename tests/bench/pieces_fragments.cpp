// Pixels: the machine's own limits, spans, texture filters and illumination per fragment. One thread.
#include <benchmark/benchmark.h>

#include <cstring>

#include <tbb/global_control.h>

#include "pipeline/draw_plan.h"
#include "raster/fragments/fragment_batch.h"
#include "raster/kernels/kernels.h"
#include "tests/bench/peer.h"
#include "tests/bench/tile_store.h"
#include "tests/bench/workloads.h"

namespace barrido::bench {
namespace {

constexpr std::size_t kFramePixels = std::size_t{1920} * 1080;

void report_pixels(benchmark::State& state, std::size_t pixels) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(pixels));
}

void limit_memset_of_frame(benchmark::State& state) {
  std::vector<std::uint32_t> color(kFramePixels), depth(kFramePixels);
  for (auto _ : state) {
    std::memset(color.data(), 1, color.size() * sizeof color[0]);
    std::memset(depth.data(), 2, depth.size() * sizeof depth[0]);
    benchmark::ClobberMemory();
  }
  report_pixels(state, kFramePixels);
}
BENCHMARK(limit_memset_of_frame)->Unit(benchmark::kMicrosecond);

void limit_store_in_tile(benchmark::State& state) {
  CachedTile tile;
  float depth = 1.0f;
  for (auto _ : state) {
    depth *= 0.999999f;
    tile.store_layer(depth, 7);
    benchmark::ClobberMemory();
  }
  report_pixels(state, CachedTile::kPixels);
}
BENCHMARK(limit_store_in_tile)->Unit(benchmark::kMicrosecond);

/// A frame of layers, clear included; items are the pixels of all layers.
void spans(benchmark::State& state, Coloring coloring) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const int layers = static_cast<int>(state.range(0));
  const ScenePair scene = screen_layers({}, layers, coloring, false);
  const std::unique_ptr<Drawer> drawer = make_barrido_drawer(scene);
  for (auto _ : state) drawer->draw();
  report_pixels(state, kFramePixels * static_cast<std::size_t>(layers));
}
BENCHMARK_CAPTURE(spans, flat, Coloring::flat)->Arg(1)->Arg(8)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(spans, smooth, Coloring::smooth)->Arg(1)->Arg(8)->Unit(benchmark::kMicrosecond);

/// The draw of a scene, compiled, and a full batch of fragments of it.
struct PreparedBatch {
  explicit PreparedBatch(const ScenePair& scene) {
    const DrawCall& draw = scene.draws[0];
    geometry = draw.mesh.geometry();
    plan = std::make_unique<pipeline::DrawPlan>(draw.state, geometry,
                                                pipeline::FrameSize{scene.width, scene.height, {}}, counters);
    std::memset(static_cast<void*>(batch), 0, sizeof *batch);
    batch->state = &plan->fragment;
    batch->count = raster::kBatchCapacity;
  }

  /// `first` for the first fragment, `step` more for each one after.
  void set(int varying, float first, float step) {
    for (int i = 0; i < raster::kBatchStride; ++i) {
      batch->varying[varying][i] = first + step * static_cast<float>(i);
    }
  }

  pipeline::Geometry geometry;
  pipeline::FragmentCounters counters;
  std::unique_ptr<pipeline::DrawPlan> plan;
  std::unique_ptr<raster::TileWorkspace> workspace = std::make_unique<raster::TileWorkspace>();
  raster::FragmentBatch* batch = &workspace->batch;
};

/// Packed levels of a fragment half way between levels 0 and 1.
std::int32_t levels_of(raster::MinFilter filter) {
  using raster::MinFilter;
  const bool four = filter == MinFilter::linear || filter == MinFilter::linear_mipmap_nearest ||
                    filter == MinFilter::linear_mipmap_linear;
  const bool two = filter == MinFilter::nearest_mipmap_linear || filter == MinFilter::linear_mipmap_linear;
  const int texels = (four ? 4 : 1) * (two ? 2 : 1);
  return (two ? 128 | 1 << raster::kUpperLevelShift : 0) | (four ? raster::kFourTexels : 0) |
         texels << raster::kTexelCountShift;
}

/// A scanline through a texture of 1024² texels at 1.4 texels a pixel.
void texture_filter(benchmark::State& state, raster::MinFilter filter) {
  GroundOptions options;
  options.min_filter = filter;
  if (filter == raster::MinFilter::nearest) options.mag_filter = raster::MagFilter::nearest;
  const ScenePair scene = ground_layers({}, options);
  PreparedBatch prepared(scene);
  const int at = prepared.plan->fragment.varyings.at(raster::Meaning::texcoord);
  prepared.set(at, 0.1f, 1.4f / 1024);
  prepared.set(at + 1, 0.3f, 0.2f / 1024);
  const auto levels = std::make_unique<raster::SampleLevels>();
  std::fill_n(levels->packed, raster::kBatchStride, levels_of(filter));
  alignas(64) float texels[4][raster::kBatchStride];
  for (auto _ : state) {
    raster::sample_texture(*prepared.batch, 0, *levels, texels);
    benchmark::ClobberMemory();
  }
  report_pixels(state, raster::kBatchCapacity);
}
BENCHMARK_CAPTURE(texture_filter, nearest, raster::MinFilter::nearest);
BENCHMARK_CAPTURE(texture_filter, linear, raster::MinFilter::linear);
BENCHMARK_CAPTURE(texture_filter, nearest_mipmap_nearest, raster::MinFilter::nearest_mipmap_nearest);
BENCHMARK_CAPTURE(texture_filter, linear_mipmap_nearest, raster::MinFilter::linear_mipmap_nearest);
BENCHMARK_CAPTURE(texture_filter, nearest_mipmap_linear, raster::MinFilter::nearest_mipmap_linear);
BENCHMARK_CAPTURE(texture_filter, linear_mipmap_linear, raster::MinFilter::linear_mipmap_linear);

/// The illumination model for each fragment, by so many lights.
void phong_fragment(benchmark::State& state) {
  EllipsoidOptions options;
  options.shading = pipeline::ShadeModel::phong;
  options.lights = static_cast<int>(state.range(0));
  const ScenePair scene = ellipsoid({}, options);
  PreparedBatch prepared(scene);
  const raster::FragmentState& fragment = prepared.plan->fragment;
  const int normal = fragment.varyings.at(raster::Meaning::normal);
  prepared.set(normal, -0.2f, 0.003f);
  prepared.set(normal + 1, 0.1f, 0.001f);
  prepared.set(normal + 2, 0.9f, 0.0f);
  const int position = fragment.varyings.at(raster::Meaning::eye_position);
  if (position != raster::kAbsent) prepared.set(position + 2, -9.0f, 0.0f);
  for (auto _ : state) {
    fragment.stages.front().kind->vector(fragment.stages.front(), *prepared.workspace);
    benchmark::ClobberMemory();
  }
  report_pixels(state, raster::kBatchCapacity);
}
BENCHMARK(phong_fragment)->Arg(1)->Arg(8);

}  // namespace
}  // namespace barrido::bench
