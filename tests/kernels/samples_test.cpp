// Samples: random scenes seen at random places of their pixels, of either surface and every rule of alpha,
// must equal the scalar reference bit for bit in every way of drawing; drawn sample by sample through the
// frame's sums, too.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "frame_difference.h"
#include "random_bits.h"
#include "random_scene.h"
#include "raster/base/simd_target.h"
#include "raster/reference/samples.h"
#include "raster/tiles/binning.h"
#include "raster/tiles/sample_pattern.h"

namespace barrido::raster::testing {
namespace {

const TexturePool& texture_pool() {
  static const TexturePool pool(77);
  return pool;
}

SampleSettings random_samples(std::mt19937& engine, const RandomScene& scene) {
  const auto below = [&](std::uint32_t count) { return static_cast<int>(engine() % count); };
  SampleSettings settings;
  const int count = 1 + below(5);
  for (int i = 0; i < count; ++i) {
    // Mostly in the pixel, some beside it.
    const int reach = below(4) == 0 ? 1000 : 256;
    settings.samples.push_back(
        {{below(static_cast<std::uint32_t>(reach)) - (reach - 256) / 2,
          below(static_cast<std::uint32_t>(reach)) - (reach - 256) / 2},
         static_cast<float>(1 + below(7)) * (i > 0 && below(5) == 0 ? -0.125f : 0.5f)});
  }
  settings.total_weight = total_weight(settings.samples);
  if (below(2) == 0) {
    const auto kind = static_cast<PixelFilterKind>(below(5));
    settings.jitter =
        JitterSettings{static_cast<std::uint32_t>(engine()), {kind, default_radius(kind)}, 0, count};
  }
  settings.alpha = static_cast<SampleAlpha>(below(3));
  settings.order = static_cast<FilterOrder>(below(2));
  settings.background = scene.clear.color;
  settings.background_depth = scene.clear.depth;
  return settings;
}

Framebuffer draw_reference(const RandomScene& scene, const SampleSettings& settings) {
  Framebuffer frame(scene.frame);
  std::vector<const PrimitiveChunk*> chunks;
  for (const PrimitiveChunk& chunk : scene.chunks) chunks.push_back(&chunk);
  reference::rasterize_samples(chunks, scene.clear, settings, frame);
  return frame;
}

void draw_fast(const RandomScene& scene, const SampleSettings& settings, bool visibility_first,
               Framebuffer& frame) {
  Rasterizer rasterizer(frame, {visibility_first, nullptr, &settings});
  rasterizer.clear(scene.clear);
  for (const PrimitiveChunk& chunk : scene.chunks) {
    rasterizer.submit(rasterizer.bin(PrimitiveChunk(chunk)));
  }
  rasterizer.flush();
}

/// As a frame is drawn in which things move.
Framebuffer draw_one_by_one(const RandomScene& scene, const SampleSettings& all) {
  Framebuffer frame(scene.frame);
  FrameSums sums(scene.frame.width, scene.frame.height, all.sums_weights());
  for (std::size_t i = 0; i < all.samples.size(); ++i) {
    SampleSettings one = all;
    one.samples = {all.samples[i]};
    if (one.jitter) one.jitter->first = static_cast<int>(i);
    one.sums = &sums;
    one.is_first = i == 0;
    one.is_last = i + 1 == all.samples.size();
    draw_fast(scene, one, true, frame);
  }
  return frame;
}

void expect_same(std::uint64_t seed, const SceneOptions& options) {
  const RandomScene scene = make_random_scene(seed, texture_pool(), options);
  std::mt19937 engine(static_cast<std::uint32_t>(seed));
  const SampleSettings settings = random_samples(engine, scene);
  const Framebuffer expected = draw_reference(scene, settings);
  for (const SimdTarget target : available_simd_targets()) {
    set_simd_target(target);
    for (const bool visibility_first : {false, true}) {
      Framebuffer frame(scene.frame);
      draw_fast(scene, settings, visibility_first, frame);
      ASSERT_EQ(describe_difference(expected, frame), "")
          << "seed " << seed << ", " << name_of(target) << (visibility_first ? ", visibility first" : "");
    }
  }
  set_simd_target(SimdTarget::automatic);
  ASSERT_EQ(describe_difference(expected, draw_one_by_one(scene, settings)), "")
      << "one by one, seed " << seed;
}

/// BARRIDO_KERNEL_SCENES says how many scenes are tried.
void expect_same_for_seeds(std::uint64_t first, int count, const SceneOptions& options) {
  if (const char* scenes = std::getenv("BARRIDO_KERNEL_SCENES")) count = std::min(count, std::atoi(scenes));
  for (int i = 0; i < count && !::testing::Test::HasFatalFailure(); ++i) {
    expect_same(first + static_cast<std::uint64_t>(i), options);
  }
}

TEST(Samples, RandomScenesAreTheSameBits) { expect_same_for_seeds(900'001, 40, {}); }

TEST(Samples, ColoursAloneAreTheSameBits) { expect_same_for_seeds(910'001, 40, {.simple = true}); }

TEST(Samples, HostileNumbersAreTheSameBits) { expect_same_for_seeds(920'001, 15, {.hostile = true}); }

/// A sample at the centre is what a frame without samples is.
TEST(Samples, OneAtTheCentreChangesNothing) {
  for (std::uint64_t seed = 930'001; seed <= 930'010; ++seed) {
    const RandomScene scene = make_random_scene(seed, texture_pool());
    SampleSettings settings;
    settings.samples = uniform_samples(1, {});
    settings.total_weight = 1.0f;
    settings.alpha = SampleAlpha::opaque;
    settings.background_depth = scene.clear.depth;
    Framebuffer sampled(scene.frame), plain(scene.frame);
    draw_fast(scene, settings, true, sampled);
    Rasterizer rasterizer(plain);
    rasterizer.clear(scene.clear);
    for (const PrimitiveChunk& chunk : scene.chunks) {
      rasterizer.submit(rasterizer.bin(PrimitiveChunk(chunk)));
    }
    rasterizer.flush();
    for (std::size_t i = 0; i < plain.color8().size(); ++i) {
      ASSERT_EQ(plain.color8()[i] & 0xffffffu, sampled.color8()[i] & 0xffffffu) << seed << " pixel " << i;
    }
  }
}

}  // namespace
}  // namespace barrido::raster::testing
