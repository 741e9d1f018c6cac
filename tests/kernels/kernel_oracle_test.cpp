// The gate of the vector kernels: random scenes through the fast rasterizer, under every instruction set,
// with visibility resolved first or not, on one, two and four threads, must equal the scalar reference bit
// for bit. BARRIDO_KERNEL_SCENES sets how many scenes are tried, BARRIDO_KERNEL_SEED tries a single one.
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cstdlib>
#include <span>

#include "frame_difference.h"
#include "random_scene.h"
#include "raster/base/simd_target.h"
#include "raster/reference/fragment_walk.h"
#include "raster/reference/reference_rasterizer.h"
#include "raster/tiles/binning.h"

namespace barrido::raster::testing {
namespace {

const TexturePool& texture_pool() {
  static const TexturePool pool(2024);
  return pool;
}

/// One way to draw a scene.
struct Way {
  SimdTarget target;
  bool visibility_first;
  int threads;

  std::string name() const {
    return std::string(name_of(target)) + (visibility_first ? ", visibility first, " : ", in order, ") +
           std::to_string(threads) + " threads";
  }
};

std::vector<Way> all_ways() {
  std::vector<Way> ways;
  for (const SimdTarget target : available_simd_targets()) {
    for (const bool visibility_first : {false, true}) {
      for (const int threads : {1, 2, 4}) ways.push_back({target, visibility_first, threads});
    }
  }
  return ways;
}

Framebuffer draw_reference(const RandomScene& scene, std::size_t chunk_count) {
  Framebuffer frame(scene.frame);
  std::vector<const PrimitiveChunk*> chunks;
  for (std::size_t k = 0; k < chunk_count; ++k) chunks.push_back(&scene.chunks[k]);
  reference::rasterize(chunks, scene.clear, frame);
  return frame;
}

Framebuffer draw_fast(const RandomScene& scene, std::size_t chunk_count, const Way& way,
                      RasterStatistics* statistics = nullptr) {
  set_simd_target(way.target);
  const auto threads = static_cast<std::size_t>(way.threads);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(way.threads);
  Framebuffer frame(scene.frame);
  arena.execute([&] {
    Rasterizer rasterizer(frame, {way.visibility_first});
    rasterizer.clear(scene.clear);
    for (std::size_t k = 0; k < chunk_count; ++k) {
      rasterizer.submit(rasterizer.bin(PrimitiveChunk(scene.chunks[k])));
    }
    rasterizer.flush();
    if (statistics != nullptr) *statistics = rasterizer.statistics();
  });
  set_simd_target(SimdTarget::automatic);
  return frame;
}

/// The shortest beginning of the scene that already differs, for the message.
std::string first_bad_chunk(const RandomScene& scene, const Way& way) {
  for (std::size_t count = 1; count <= scene.chunks.size(); ++count) {
    const std::string difference =
        describe_difference(draw_reference(scene, count), draw_fast(scene, count, way));
    if (!difference.empty()) {
      return "chunk " + std::to_string(count - 1) + ": " + scene.descriptions[count - 1] + "\n" + difference;
    }
  }
  return "only the whole scene differs\n";
}

std::string describe_frame(const FramebufferOptions& frame) {
  return std::to_string(frame.width) + " × " + std::to_string(frame.height) +
         (frame.format == ColorFormat::rgba8 ? " rgba8" : " rgba32f");
}

/// Returns false at the first difference, which is reported.
bool expect_same_in_all_ways(std::uint64_t seed, const SceneOptions& options) {
  const RandomScene scene = make_random_scene(seed, texture_pool(), options);
  const Framebuffer expected = draw_reference(scene, scene.chunks.size());
  for (const Way& way : all_ways()) {
    const std::string difference = describe_difference(expected, draw_fast(scene, scene.chunks.size(), way));
    if (difference.empty()) continue;
    ADD_FAILURE() << "seed " << seed << ", " << way.name() << ", " << describe_frame(scene.frame) << "\n"
                  << difference << first_bad_chunk(scene, way);
    return false;
  }
  return true;
}

void expect_same_for_seeds(std::uint64_t first_seed, int default_count, const SceneOptions& options) {
  if (const char* seed = std::getenv("BARRIDO_KERNEL_SEED")) {
    expect_same_in_all_ways(std::strtoull(seed, nullptr, 10), options);
    return;
  }
  const char* scenes = std::getenv("BARRIDO_KERNEL_SCENES");
  const int count = scenes != nullptr ? std::atoi(scenes) : default_count;
  int failures = 0;
  for (int k = 0; k < count && failures < 5; ++k) {
    if (!expect_same_in_all_ways(first_seed + static_cast<std::uint64_t>(k), options)) ++failures;
  }
}

TEST(KernelOracle, RandomScenesAreTheSameBits) { expect_same_for_seeds(1, 200, {}); }

TEST(KernelOracle, HostileNumbersAreTheSameBits) { expect_same_for_seeds(100000, 60, {.hostile = true}); }

TEST(KernelOracle, ColoursAloneAreTheSameBits) { expect_same_for_seeds(200000, 150, {.simple = true}); }

TEST(KernelOracle, HostileColoursAloneAreTheSameBits) {
  expect_same_for_seeds(300000, 50, {.hostile = true, .simple = true});
}

/// Fragments of all primitives, hidden ones too.
std::uint64_t count_fragments(const RandomScene& scene) {
  std::vector<const PrimitiveChunk*> chunks;
  for (const PrimitiveChunk& chunk : scene.chunks) chunks.push_back(&chunk);
  std::uint64_t count = 0;
  reference::for_each_fragment(chunks, {scene.frame.width, scene.frame.height}, {},
                               [&](const reference::FragmentPlace&) { ++count; });
  return count;
}

TEST(KernelOracle, StatisticsDependOnNothingButTheScene) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const RandomScene scene = make_random_scene(seed, texture_pool(), {.simple = seed > 20});
    RasterStatistics first[2];
    bool known[2] = {false, false};
    const std::uint64_t covered = count_fragments(scene);
    for (const Way& way : all_ways()) {
      RasterStatistics statistics;
      draw_fast(scene, scene.chunks.size(), way, &statistics);
      RasterStatistics& expected = first[way.visibility_first ? 1 : 0];
      if (!known[way.visibility_first ? 1 : 0]) expected = statistics;
      known[way.visibility_first ? 1 : 0] = true;
      EXPECT_EQ(statistics.primitives, expected.primitives) << seed << " " << way.name();
      EXPECT_EQ(statistics.spans, expected.spans) << seed << " " << way.name();
      EXPECT_EQ(statistics.fragments_covered, covered) << seed << " " << way.name();
      EXPECT_EQ(statistics.fragments_shaded, expected.fragments_shaded) << seed << " " << way.name();
      EXPECT_EQ(statistics.texel_fetches, expected.texel_fetches) << seed << " " << way.name();
      EXPECT_EQ(statistics.mapped, expected.mapped) << seed << " " << way.name();
      EXPECT_EQ(statistics.patterns, expected.patterns) << seed << " " << way.name();
      EXPECT_EQ(statistics.noise, expected.noise) << seed << " " << way.name();
      EXPECT_EQ(statistics.sorted_fragments, expected.sorted_fragments) << seed << " " << way.name();
    }
  }
}

TEST(KernelOracle, DrawingOnTopGoesOnWhereTheFrameWas) {
  for (std::uint64_t seed = 500; seed < 540; ++seed) {
    RandomScene scene = make_random_scene(seed, texture_pool());
    scene.frame.keep_depth = true;
    scene.frame.keep_float = true;
    for (auto& state : scene.states) state->sorted = false;  // each flush blends what waits
    const Framebuffer expected = draw_reference(scene, scene.chunks.size());
    Framebuffer frame(scene.frame);
    Rasterizer rasterizer(frame);
    rasterizer.clear(scene.clear);
    for (const PrimitiveChunk& chunk : scene.chunks) {
      rasterizer.submit(rasterizer.bin(PrimitiveChunk(chunk)));
      rasterizer.flush();
    }
    ASSERT_EQ(describe_difference(expected, frame), "") << "seed " << seed;
  }
}

}  // namespace
}  // namespace barrido::raster::testing
