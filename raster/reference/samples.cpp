#include "raster/reference/samples.h"

#include <algorithm>
#include <functional>
#include <vector>

#include "raster/reference/canvas.h"
#include "raster/reference/fragment_operations.h"
#include "raster/reference/fragment_walk.h"
#include "raster/reference/reference_rasterizer.h"
#include "raster/reference/resolve.h"
#include "raster/reference/shading.h"
#include "raster/tiles/pixel_places.h"

namespace barrido::raster::reference {
namespace {

PrimitiveChunk moved(const PrimitiveChunk& chunk, const SamplePlace& place) {
  PrimitiveChunk result = chunk;
  for (PrimitiveRecord& p : result.primitives) {
    for (std::int32_t& x : p.x) x -= place.x - kSubpixelUnits / 2;
    for (std::int32_t& y : p.y) y -= place.y - kSubpixelUnits / 2;
  }
  return result;
}

Framebuffer draw_sample(std::span<const PrimitiveChunk* const> chunks, const ClearValues& clear,
                        const SamplePlace& place, FramebufferOptions options) {
  options.keep_depth = options.keep_float = true;
  Framebuffer frame(options);
  std::vector<PrimitiveChunk> all;
  for (const PrimitiveChunk* chunk : chunks) all.push_back(moved(*chunk, place));
  std::vector<const PrimitiveChunk*> pointers;
  for (const PrimitiveChunk& chunk : all) pointers.push_back(&chunk);
  rasterize(pointers, clear, frame);
  return frame;
}

Framebuffer draw_placed(std::span<const PrimitiveChunk* const> chunks, const ClearValues& clear,
                        const SampleReach& reach, const PlaceOf& place_of, FramebufferOptions options) {
  options.keep_depth = options.keep_float = true;
  Framebuffer frame(options);
  Canvas canvas(options, clear);
  Fragment fragment;
  for_each_placed_fragment(chunks, {frame.width(), frame.height()}, reach, place_of,
                           [&](const FragmentPlace& place) {
                             const FragmentState& state = *place.chunk.state;
                             if (!is_inside_scissor(state.scissor, place.x, place.y)) return;
                             interpolate(place, fragment);
                             const Color color = shade_fragment(fragment);
                             canvas.apply(state, place.x, place.y, color, fragment.depth);
                           });
  canvas.finish();
  canvas.store(frame);
  return frame;
}

/// One sample's colours and depths, and its weight in each pixel.
struct SampleFrame {
  Framebuffer frame;
  std::function<float(int x, int y)> weight;
};

SampleFrame draw_number(std::span<const PrimitiveChunk* const> chunks, const ClearValues& clear,
                        const SampleSettings& settings, std::size_t number,
                        const FramebufferOptions& options) {
  if (!settings.jitter) {
    const Sample& sample = settings.samples[number];
    return {draw_sample(chunks, clear, sample.place, options),
            [weight = sample.weight](int, int) { return weight; }};
  }
  const JitterSettings& jitter = *settings.jitter;
  const int own = jitter.first + static_cast<int>(number);
  const PlaceOf place_of = [cell = place_cell(own, jitter.count, jitter.filter.radius),
                            key = hash_of(static_cast<std::uint32_t>(own), jitter.seed)](int x, int y) {
    return place_in(cell, x, y, key);
  };
  return {
      draw_placed(chunks, clear, settings.reach(), place_of, options),
      [place_of, weights = PlaceWeights(jitter.filter)](int x, int y) { return weights.at(place_of(x, y)); }};
}

void multiply(Color& color, float factor) {
  for (std::size_t c = 0; c < 3; ++c) color[c] = color[c] * factor;
}

void show(Color& color, const DisplayTransform& display) {
  for (std::size_t c = 0; c < 3; ++c) color[c] = display_channel(display, color[c]);
}

}  // namespace

void add_sample(const Color& sample, float depth, float weight, const SampleSettings& settings,
                const DisplayTransform* display, SampleSum& sum) {
  Color color = sample;
  if (settings.alpha == SampleAlpha::blended) {
    if (depth < settings.background_depth) color[3] = 1.0f;
    const bool divides = color[3] > 0.0f && color[3] < 1.0f;
    if (display != nullptr) {
      for (std::size_t c = 0; c < 3 && divides; ++c) color[c] = color[c] / color[3];
      show(color, *display);
      if (divides) multiply(color, color[3]);
    }
  } else {
    if (display != nullptr) show(color, *display);
    if (settings.alpha == SampleAlpha::opaque) {
      color[3] = 1.0f;
    } else {
      multiply(color, color[3]);
    }
  }
  for (std::size_t c = 0; c < 4; ++c) sum.color[c] = sum.color[c] + color[c] * weight;
  sum.weight = sum.weight + weight;
  sum.depth = minimum(depth, sum.depth);
}

Color resolved(const SampleSum& sum, const SampleSettings& settings) {
  const float alpha = sum.color[3];
  Color color = settings.background;
  for (std::size_t c = 0; c < 3 && alpha > 0.0f; ++c) color[c] = sum.color[c] / alpha;
  color[3] = clamp_to_unit(alpha / (settings.sums_weights() ? sum.weight : settings.total_weight));
  return color;
}

void rasterize_samples(std::span<const PrimitiveChunk* const> chunks, const ClearValues& clear,
                       const SampleSettings& settings, Framebuffer& framebuffer) {
  const FramebufferOptions& options = framebuffer.options();
  const bool is_float = options.format == ColorFormat::rgba32f;
  const bool shows = is_float && settings.order == FilterOrder::display;
  std::vector<SampleSum> sums(framebuffer.color8().size());
  for (SampleSum& sum : sums) sum.depth = settings.background_depth;
  for (std::size_t number = 0; number < settings.samples.size(); ++number) {
    const auto [frame, weight_of] = draw_number(chunks, clear, settings, number, options);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const int x = static_cast<int>(i) % options.width;
      const int y = options.height - 1 - static_cast<int>(i) / options.width;
      Color color = unpack_rgba8(frame.color8()[i]);
      if (is_float) std::copy_n(&frame.color_float()[4 * i], 4, color.begin());
      add_sample(color, frame.depth()[i], weight_of(x, y), settings, shows ? &options.display : nullptr,
                 sums[i]);
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const Color color = resolved(sums[i], settings);
    framebuffer.color8()[i] = is_float && !shows ? display_color(options.display, color) : pack_rgba8(color);
    if (!framebuffer.color_float().empty())
      std::copy(color.begin(), color.end(), &framebuffer.color_float()[4 * i]);
    if (!framebuffer.depth().empty()) framebuffer.depth()[i] = sums[i].depth;
  }
}

}  // namespace barrido::raster::reference
