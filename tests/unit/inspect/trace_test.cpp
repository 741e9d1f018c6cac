// A traced pixel is the pixel that the vector kernels draw: random scenes of the rasterizer, every state,
// topology and format.
#include <gtest/gtest.h>

#include <bit>

#include "raster/rasterizer.h"
#include "raster/reference/trace.h"
#include "raster/tiles/binning.h"
#include "tests/kernels/random_scene.h"

namespace barrido::raster::testing {
namespace {

Framebuffer draw(const RandomScene& scene) {
  FramebufferOptions options = scene.frame;
  options.keep_float = true;
  Framebuffer frame(options);
  Rasterizer rasterizer(frame);
  rasterizer.clear(scene.clear);
  for (const PrimitiveChunk& chunk : scene.chunks) {
    rasterizer.submit(rasterizer.bin(PrimitiveChunk(chunk)));
  }
  rasterizer.flush();
  return frame;
}

void expect_traced(const RandomScene& scene, const Framebuffer& frame, int x, int y) {
  std::vector<const PrimitiveChunk*> chunks;
  for (const PrimitiveChunk& chunk : scene.chunks) chunks.push_back(&chunk);
  const reference::PixelTrace trace = reference::trace_pixel(chunks, scene.clear, scene.frame, x, y);
  const std::size_t at = frame.index(x, y);
  EXPECT_EQ(trace.color8, frame.color8()[at]) << x << "," << y;
  if (!frame.depth().empty()) {
    EXPECT_EQ(trace.depth, frame.depth()[at]) << x << "," << y;
  }
  reference::Color before = trace.clear;
  for (const reference::FragmentTrace& fragment : trace.fragments) {
    if (fragment.outside_scissor) continue;
    EXPECT_EQ(fragment.fate.before, before);
    before = fragment.fate.after;
  }
  EXPECT_EQ(before, trace.color);
  if (frame.color_float().empty()) return;
  for (std::size_t c = 0; c < 4; ++c) {
    EXPECT_EQ(std::bit_cast<std::uint32_t>(trace.color[c]),
              std::bit_cast<std::uint32_t>(frame.color_float()[at * 4 + c]));
  }
}

TEST(Trace, RandomPixelsOfRandomScenes) {
  const TexturePool textures(2024);
  std::size_t fragments = 0, units = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const RandomScene scene = make_random_scene(seed, textures);
    const Framebuffer frame = draw(scene);
    for (int k = 0; k < 30; ++k) {
      const int x = (k * 7919 + 13) % frame.width();
      const int y = (k * 104729 + 7) % frame.height();
      expect_traced(scene, frame, x, y);
      if (::testing::Test::HasFailure()) FAIL() << "seed " << seed;
      std::vector<const PrimitiveChunk*> chunks;
      for (const PrimitiveChunk& chunk : scene.chunks) chunks.push_back(&chunk);
      for (const auto& f : reference::trace_pixel(chunks, scene.clear, scene.frame, x, y).fragments) {
        ++fragments;
        units += f.shading.units.size();
      }
    }
  }
  EXPECT_GT(fragments, 1000u);
  EXPECT_GT(units, 200u);
}

}  // namespace
}  // namespace barrido::raster::testing
