// Files in and out: PNG by compression level, and loading a small glTF file.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "pipeline/gltf/import_gltf.h"
#include "pipeline/pictures/image_io.h"
#include "pipeline/scene/render_scene.h"

namespace barrido::bench {
namespace {

const std::string kModels = BARRIDO_SOURCE_DIR "/models/";

/// A rendered picture, as one is written: 1280 × 720.
const raster::Framebuffer& rendered_frame() {
  static const raster::Framebuffer frame = [] {
    const scene::Scene scene = scene::import_gltf(kModels + "showcase.glb");
    return scene::SceneRenderer(scene).render({});
  }();
  return frame;
}

scene::ImageView view_of(const raster::Framebuffer& frame) {
  const auto& pixels = frame.color8();
  return {frame.options().width,
          frame.options().height,
          {reinterpret_cast<const std::uint8_t*>(pixels.data()), pixels.size() * sizeof pixels[0]},
          {}};
}

void report_pixels(benchmark::State& state, std::size_t pixels) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(pixels));
}

void png_encode(benchmark::State& state) {
  const scene::ImageView image = view_of(rendered_frame());
  scene::WriteOptions options;
  options.png_compression = static_cast<int>(state.range(0));
  std::size_t bytes = 0;
  for (auto _ : state) bytes = scene::encode_png(image, options).size();
  report_pixels(state, rendered_frame().color8().size());
  state.counters["bytes"] = static_cast<double>(bytes);
}
BENCHMARK(png_encode)->Arg(0)->Arg(1)->Arg(6)->Unit(benchmark::kMillisecond);

void png_decode(benchmark::State& state) {
  const std::vector<std::uint8_t> png = scene::encode_png(view_of(rendered_frame()));
  for (auto _ : state) benchmark::DoNotOptimize(scene::decode_image(png, "memory"));
  report_pixels(state, rendered_frame().color8().size());
}
BENCHMARK(png_decode)->Unit(benchmark::kMillisecond);

void gltf_load(benchmark::State& state, const char* name) {
  for (auto _ : state) benchmark::DoNotOptimize(scene::import_gltf(kModels + name));
}
BENCHMARK_CAPTURE(gltf_load, lesson, "t_junction.glb")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(gltf_load, suzanne, "suzanne.glb")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace barrido::bench
