// Sorted fragments: stacks of panes in any order of drawing give the bits of panes drawn from back to front,
// from the kernels as from the reference.
#include "raster/tiles/pixel_layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "raster/rasterizer.h"
#include "raster/reference/reference_rasterizer.h"
#include "raster/tiles/binning.h"

namespace barrido::raster {
namespace {

constexpr int kWidth = 150, kHeight = 70;

struct Pane {
  float depth;
  FlatColors color;
};

std::vector<Pane> random_panes(std::mt19937& bits, int count) {
  const auto share = [&] { return static_cast<float>(bits() % 1001) / 1000.0f; };
  std::vector<Pane> panes;
  for (int i = 0; i < count; ++i) {
    // Some are equally deep: the first that is drawn is the farther one.
    const float depth = static_cast<float>(bits() % 40) / 64.0f;
    panes.push_back({depth, {{share(), share(), share(), share()}, {0, 0, 0}}});
  }
  return panes;
}

FragmentState blended_state() {
  FragmentState state;
  state.depth = {true, false, Compare::less};
  state.blend.enabled = true;
  state.blend.src_rgb = state.blend.src_alpha = BlendFactor::src_alpha;
  state.blend.dst_rgb = state.blend.dst_alpha = BlendFactor::one_minus_src_alpha;
  return state;
}

/// A triangle over the whole frame.
PrimitiveChunk chunk_of(const Pane& pane, const FragmentState& state) {
  PrimitiveChunk chunk;
  chunk.state = &state;
  const auto stride = static_cast<std::size_t>(record_stride(0));
  chunk.own_records.resize(3 * stride);
  for (std::size_t v = 0; v < 3; ++v) {
    chunk.own_records[v * stride + kRecordDepth] = pane.depth;
    chunk.own_records[v * stride + kRecordQ] = 1.0f;
  }
  chunk.flat = {pane.color};
  constexpr int kFar = 1000 * kSubpixelUnits;
  chunk.primitives = {{{0, kFar, 0}, {0, 0, kFar}, {0, 1, 2}, 0}};
  return chunk;
}

struct Drawn {
  Framebuffer frame;
  RasterStatistics statistics;
};

FramebufferOptions options_of(ColorFormat format) {
  FramebufferOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.format = format;
  options.keep_float = format == ColorFormat::rgba32f;
  return options;
}

Drawn draw(const std::vector<PrimitiveChunk>& chunks, ColorFormat format) {
  Drawn drawn{Framebuffer(options_of(format)), {}};
  Rasterizer rasterizer(drawn.frame);
  rasterizer.clear({{0.25f, 0.5f, 0.75f, 1.0f}, 1.0f});
  for (const PrimitiveChunk& chunk : chunks) rasterizer.submit(rasterizer.bin(PrimitiveChunk(chunk)));
  rasterizer.flush();
  drawn.statistics = rasterizer.statistics();
  return drawn;
}

Framebuffer draw_reference(const std::vector<PrimitiveChunk>& chunks, ColorFormat format) {
  Framebuffer frame(options_of(format));
  std::vector<const PrimitiveChunk*> pointers;
  for (const PrimitiveChunk& chunk : chunks) pointers.push_back(&chunk);
  reference::rasterize(pointers, {{0.25f, 0.5f, 0.75f, 1.0f}, 1.0f}, frame);
  return frame;
}

std::vector<PrimitiveChunk> chunks_of(const std::vector<Pane>& panes, const FragmentState& state) {
  std::vector<PrimitiveChunk> chunks;
  for (const Pane& pane : panes) chunks.push_back(chunk_of(pane, state));
  return chunks;
}

TEST(PixelLayers, AnyOrderOfDrawingIsFromBackToFront) {
  std::mt19937 bits(7);
  const FragmentState in_order = blended_state();
  FragmentState sorted = blended_state();
  sorted.sorted = true;
  for (int round = 0; round < 12; ++round) {
    const ColorFormat format = round % 2 == 0 ? ColorFormat::rgba8 : ColorFormat::rgba32f;
    std::vector<Pane> panes = random_panes(bits, 1 + round * 5);
    const Drawn drawn = draw(chunks_of(panes, sorted), format);
    const Framebuffer reference = draw_reference(chunks_of(panes, sorted), format);
    std::stable_sort(panes.begin(), panes.end(),
                     [](const Pane& a, const Pane& b) { return a.depth > b.depth; });
    const Drawn expected = draw(chunks_of(panes, in_order), format);
    EXPECT_EQ(drawn.frame.color8(), expected.frame.color8()) << round;
    EXPECT_EQ(drawn.frame.color_float(), expected.frame.color_float()) << round;
    EXPECT_EQ(reference.color8(), expected.frame.color8()) << round;
    EXPECT_EQ(drawn.statistics.sorted_fragments, panes.size() * kWidth * kHeight);
    EXPECT_EQ(drawn.statistics.crowded_fragments, 0u);
    EXPECT_EQ(expected.statistics.sorted_fragments, 0u);
  }
}

TEST(PixelLayers, OfTooManyTheFarthestComeFirst) {
  std::mt19937 bits(8);
  FragmentState sorted = blended_state();
  sorted.sorted = true;
  std::vector<Pane> panes = random_panes(bits, static_cast<int>(kMaxPixelLayers) + 9);
  // Drawn from front to back: the nine nearest of the rest are as they should be, and so is what they cover.
  const Drawn drawn = draw(chunks_of(panes, sorted), ColorFormat::rgba32f);
  EXPECT_EQ(drawn.statistics.crowded_fragments, 9u * kWidth * kHeight);
  EXPECT_EQ(drawn.frame.color8(), draw_reference(chunks_of(panes, sorted), ColorFormat::rgba32f).color8());
  // With nothing out of place, no number of layers is too many.
  std::stable_sort(panes.begin(), panes.end(),
                   [](const Pane& a, const Pane& b) { return a.depth > b.depth; });
  const FragmentState in_order = blended_state();
  EXPECT_EQ(draw(chunks_of(panes, sorted), ColorFormat::rgba8).frame.color8(),
            draw(chunks_of(panes, in_order), ColorFormat::rgba8).frame.color8());
}

TEST(PixelLayers, WhatIsNotSortedComesAfterWhatWaits) {
  FragmentState sorted = blended_state();
  sorted.sorted = true;
  const FragmentState in_order = blended_state();
  const Pane far{0.75f, {{1, 0, 0, 0.5f}, {0, 0, 0}}}, near{0.25f, {{0, 1, 0, 0.5f}, {0, 0, 0}}};
  const std::vector<PrimitiveChunk> mixed{chunk_of(near, sorted), chunk_of(far, in_order)};
  const std::vector<PrimitiveChunk> plain{chunk_of(near, in_order), chunk_of(far, in_order)};
  EXPECT_EQ(draw(mixed, ColorFormat::rgba8).frame.color8(), draw(plain, ColorFormat::rgba8).frame.color8());
  EXPECT_EQ(draw_reference(mixed, ColorFormat::rgba8).color8(),
            draw(plain, ColorFormat::rgba8).frame.color8());
}

}  // namespace
}  // namespace barrido::raster
