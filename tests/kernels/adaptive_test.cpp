// Adaptive sampling: thin lines anywhere are never lost and have the brightness of their area, whatever tile
// they lie in; the plain corner rule loses them; the picture is the same in every way of drawing.
// BARRIDO_THIN_LINES sets how many lines are tried.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "frame_difference.h"
#include "random_bits.h"
#include "random_scene.h"
#include "raster/base/simd_target.h"
#include "raster/rasterizer.h"
#include "raster/tiles/binning.h"

namespace barrido::raster::testing {
namespace {

constexpr int kWidth = 24, kHeight = 16;

SampleSettings adaptive(bool keeps_slivers) {
  SampleSettings settings;
  settings.samples = {Sample{}};
  settings.alpha = SampleAlpha::opaque;
  settings.adaptive = AdaptiveSettings{0.1f, 2, keeps_slivers};
  return settings;
}

FramebufferOptions float_frame() {
  FramebufferOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.format = ColorFormat::rgba32f;
  options.keep_float = true;
  return options;
}

/// A white quad about a line of this width between two points, pixels.
PrimitiveChunk line_chunk(const FragmentState& state, const double (&a)[2], const double (&b)[2],
                          double width) {
  PrimitiveChunk chunk;
  chunk.state = &state;
  chunk.own_records = {0.5f, 1.0f, 0, 0, 0, 0, 0, 0};
  chunk.flat.push_back({{1, 1, 1, 1}, {0, 0, 0}});
  const double dx = b[0] - a[0], dy = b[1] - a[1];
  const double length = std::sqrt(dx * dx + dy * dy);
  const double nx = -dy / length * width / 2, ny = dx / length * width / 2;
  const double corner[4][2] = {
      {a[0] - nx, a[1] - ny}, {b[0] - nx, b[1] - ny}, {b[0] + nx, b[1] + ny}, {a[0] + nx, a[1] + ny}};
  const auto units = [](double v) { return static_cast<std::int32_t>(std::floor(v * kSubpixelUnits + 0.5)); };
  for (const auto& [i, j, k] : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
    PrimitiveRecord p{};
    const int order[3] = {i, j, k};
    for (int c = 0; c < 3; ++c) {
      p.x[c] = units(corner[order[c]][0]);
      p.y[c] = units(corner[order[c]][1]);
    }
    chunk.primitives.push_back(p);
  }
  return chunk;
}

Framebuffer draw(const PrimitiveChunk& chunk, const SampleSettings& settings) {
  Framebuffer frame(float_frame());
  Rasterizer rasterizer(frame, {true, nullptr, &settings});
  rasterizer.clear({{0, 0, 0, 1}, 1.0f});
  rasterizer.submit(rasterizer.bin(PrimitiveChunk(chunk)));
  rasterizer.flush();
  return frame;
}

double brightness(const Framebuffer& frame) {
  double sum = 0.0;
  for (std::size_t i = 0; i < frame.color_float().size(); i += 4)
    sum += static_cast<double>(frame.color_float()[i]);
  return sum;
}

double area(const PrimitiveChunk& chunk) {
  double sum = 0.0;
  for (const PrimitiveRecord& p : chunk.primitives) {
    sum += std::abs((static_cast<double>(p.x[1]) - p.x[0]) * (static_cast<double>(p.y[2]) - p.y[0]) -
                    (static_cast<double>(p.x[2]) - p.x[0]) * (static_cast<double>(p.y[1]) - p.y[0])) /
           (2.0 * kSubpixelUnits * kSubpixelUnits);
  }
  return sum;
}

/// Whether every pixel that holds some of the line shows some: walked along its middle.
bool is_whole(const Framebuffer& frame, const double (&a)[2], const double (&b)[2]) {
  for (int i = 0; i <= 400; ++i) {
    const double t = 0.01 + 0.98 * i / 400.0;
    const int x = static_cast<int>(a[0] + (b[0] - a[0]) * t);
    const int y = static_cast<int>(a[1] + (b[1] - a[1]) * t);
    // Where the line passes near a corner its part of the pixel may be nothing.
    const double fx = a[0] + (b[0] - a[0]) * t - x, fy = a[1] + (b[1] - a[1]) * t - y;
    if (std::min({fx, fy, 1 - fx, 1 - fy}) < 0.05) continue;
    if (!(frame.color_float()[4 * frame.index(x, y)] > 0.0f)) return false;
  }
  return true;
}

TEST(Adaptive, ThinLinesAreNeverLost) {
  const char* wanted = std::getenv("BARRIDO_THIN_LINES");
  const int count = wanted != nullptr ? std::atoi(wanted) : 4000;
  const FragmentState state;
  RandomBits random(20);
  int lost_by_corners = 0;
  for (int i = 0; i < count; ++i) {
    const auto place = [&](float most) { return static_cast<double>(random.number(1.5f, most - 1.5f)); };
    const double a[2] = {place(kWidth), place(kHeight)};
    double b[2] = {place(kWidth), place(kHeight)};
    const int axis = random.between(0, 1);
    if (random.chance(20)) b[axis] = a[axis];
    if (std::hypot(b[0] - a[0], b[1] - a[1]) < 2.0) continue;
    const double width = static_cast<double>(random.number(0.05f, 1.2f));
    const PrimitiveChunk chunk = line_chunk(state, a, b, width);
    const Framebuffer frame = draw(chunk, adaptive(true));
    ASSERT_TRUE(is_whole(frame, a, b)) << "line " << i << " of width " << width << " from " << a[0] << ", "
                                       << a[1] << " to " << b[0] << ", " << b[1];
    const double exact = area(chunk);
    // Samples a quarter of a pixel apart: a line that runs along a row of them is as wide as their distance.
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    ASSERT_NEAR(brightness(frame), exact, 0.25 * length + 0.6) << "line " << i << " of width " << width;
    lost_by_corners += !is_whole(draw(chunk, adaptive(false)), a, b);
  }
  EXPECT_GT(lost_by_corners, count / 4);
}

TEST(Adaptive, RandomScenesAreTheSameInEveryWay) {
  const TexturePool pool(5);
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    const RandomScene scene = make_random_scene(seed, pool);
    SampleSettings settings = adaptive(seed % 4 != 0);
    settings.alpha = static_cast<SampleAlpha>(seed % 3);
    settings.background = scene.clear.color;
    settings.background_depth = scene.clear.depth;
    settings.adaptive->depth = 1 + static_cast<int>(seed % 3);
    std::optional<Framebuffer> first;
    for (const SimdTarget target : available_simd_targets()) {
      set_simd_target(target);
      for (const bool visibility_first : {false, true}) {
        Framebuffer frame(scene.frame);
        Rasterizer rasterizer(frame, {visibility_first, nullptr, &settings});
        rasterizer.clear(scene.clear);
        for (const PrimitiveChunk& chunk : scene.chunks) {
          rasterizer.submit(rasterizer.bin(PrimitiveChunk(chunk)));
        }
        rasterizer.flush();
        if (!first)
          first = std::move(frame);
        else
          ASSERT_EQ(describe_difference(*first, frame), "") << "seed " << seed << ", " << name_of(target);
      }
    }
    set_simd_target(SimdTarget::automatic);
  }
}

}  // namespace
}  // namespace barrido::raster::testing
