// The tie rule as a whole: over more than a million random triangles in meshes that share edges, each pixel
// centre inside is produced exactly once and none outside. Additive blending into a float frame counts.
#include <gtest/gtest.h>

#include <functional>

#include "coverage_meshes.h"
#include "raster/base/simd_target.h"
#include "raster/rasterizer.h"
#include "raster/reference/reference_rasterizer.h"
#include "raster/tiles/binning.h"

namespace barrido::raster {
namespace {

using testing::GridPoint;
using testing::Mesh;

constexpr int kWidth = 300;
constexpr int kHeight = 170;

/// Adds 1 to red for every fragment.
FragmentState counting_state() {
  FragmentState state;
  state.blend.enabled = true;
  state.blend.src_rgb = state.blend.dst_rgb = BlendFactor::one;
  state.blend.src_alpha = state.blend.dst_alpha = BlendFactor::one;
  return state;
}

/// The mesh as chunks; corners in random order, so both windings.
std::vector<PrimitiveChunk> chunks_of(const Mesh& mesh, const FragmentState& state, std::mt19937_64& bits) {
  std::vector<PrimitiveChunk> chunks;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    if (k % kMaxChunkPrimitives == 0) {
      chunks.emplace_back();
      chunks.back().state = &state;
      chunks.back().own_records = {0.5f, 1.0f, 0, 0, 0, 0, 0, 0};
      chunks.back().flat.push_back({{1, 0, 0, 0}, {0, 0, 0}});
    }
    PrimitiveRecord record{};
    const std::uint64_t order = bits();
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t slot = ((order & 1) != 0 ? 2 - c : c) + order % 3;
      const GridPoint& p = mesh.points[mesh.triangles[k][c]];
      record.x[slot % 3] = p.x;
      record.y[slot % 3] = p.y;
    }
    chunks.back().primitives.push_back(record);
  }
  return chunks;
}

FramebufferOptions counting_frame() {
  FramebufferOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.format = ColorFormat::rgba32f;
  options.keep_float = true;
  return options;
}

using Draw = std::function<void(std::vector<PrimitiveChunk>&, Framebuffer&)>;

void draw_fast(std::vector<PrimitiveChunk>& chunks, Framebuffer& frame) {
  Rasterizer rasterizer(frame);
  rasterizer.clear({});
  for (PrimitiveChunk& chunk : chunks) rasterizer.submit(rasterizer.bin(std::move(chunk)));
  rasterizer.flush();
}

void draw_reference(std::vector<PrimitiveChunk>& chunks, Framebuffer& frame) {
  std::vector<const PrimitiveChunk*> pointers;
  for (const PrimitiveChunk& chunk : chunks) pointers.push_back(&chunk);
  reference::rasterize(pointers, {}, frame);
}

/// @return the number of pixels that were not covered exactly as the outline says; the first is reported.
int check_mesh(const Mesh& mesh, std::mt19937_64& bits, const Draw& draw, const std::string& name) {
  const FragmentState state = counting_state();
  Framebuffer frame(counting_frame());
  std::vector<PrimitiveChunk> chunks = chunks_of(mesh, state, bits);
  draw(chunks, frame);
  const std::vector<bool> inside = testing::inside_outline(mesh, kWidth, kHeight);
  int wrong = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const float count = frame.color_float()[frame.index(x, y) * 4];
      const bool expected = inside[static_cast<std::size_t>(y * kWidth + x)];
      if (count == (expected ? 1.0f : 0.0f)) continue;
      if (wrong++ == 0) {
        ADD_FAILURE() << name << ": pixel (" << x << ", " << y << ") covered " << count << " times, "
                      << (expected ? "inside" : "outside");
      }
    }
  }
  return wrong;
}

/// Meshes of all kinds until `triangles` are drawn.
void check_meshes(std::uint64_t seed, std::size_t triangles, const Draw& draw) {
  std::mt19937_64 bits(seed);
  const auto choose = [&bits](std::initializer_list<int> values) {
    return values.begin()[bits() % values.size()];
  };
  std::size_t drawn = 0;
  for (int kind = 0; drawn < triangles; kind = (kind + 1) % 5) {
    Mesh mesh;
    const GridPoint somewhere{static_cast<int>(bits() % 20000), static_cast<int>(bits() % 10000)};
    if (kind == 0) {  // sub-pixel
      const int cell = choose({20, 47, 64, 100, 128, 200});
      mesh = testing::jittered_grid(bits, {somewhere.x - 3000, somewhere.y - 3000}, 120, 100, cell, cell / 2);
    } else if (kind == 1) {  // some pixels large; whole and half pixels meet centres
      const int cell = choose({256, 512, 640, 1111, 3000});
      mesh = testing::jittered_grid(bits, {-cell, -cell}, 60, 40, cell, choose({0, 1, 64, cell / 2, cell}));
    } else if (kind == 2) {
      mesh = testing::sliver_fan(bits, somewhere, 6000, choose({3000, 20000, 200000, 4000000}));
    } else if (kind == 3) {  // vertices on half pixels: many ties
      mesh = testing::jittered_grid(bits, {128, 128}, 100, 60, 512, 1);
      for (GridPoint& p : mesh.points) p = {p.x & ~127, p.y & ~127};
      for (GridPoint& p : mesh.outline) p = {p.x & ~127, p.y & ~127};
    } else {
      mesh = testing::split_square(bits, (1 << 23) - 1, 1200, kWidth * 256, kHeight * 256);
    }
    drawn += mesh.triangles.size();
    if (check_mesh(mesh, bits, draw, "kind " + std::to_string(kind)) > 0) return;
  }
  EXPECT_GE(drawn, triangles);
}

TEST(Coverage, EachCentreOfAMillionTrianglesOnce) { check_meshes(1, 1'000'000, draw_fast); }

TEST(Coverage, UnderEveryInstructionSet) {
  for (const SimdTarget target : available_simd_targets()) {
    ASSERT_TRUE(set_simd_target(target));
    SCOPED_TRACE(name_of(target));
    check_meshes(2, 100'000, draw_fast);
  }
  set_simd_target(SimdTarget::automatic);
}

TEST(Coverage, ReferenceAsWell) { check_meshes(3, 100'000, draw_reference); }

}  // namespace
}  // namespace barrido::raster
