#include "raster/reference/trace.h"

#include <algorithm>
#include <deque>
#include <iterator>

#include "raster/reference/canvas.h"
#include "raster/reference/fragment_operations.h"
#include "raster/reference/fragment_walk.h"
#include "raster/reference/shading.h"

namespace barrido::raster::reference {
namespace {

FragmentTrace begin_trace(const FragmentPlace& place) {
  FragmentTrace trace;
  trace.chunk = place.chunk_number;
  trace.primitive = place.primitive_number;
  trace.span = place.span;
  trace.along = place.along;
  trace.back_facing = (place.primitive.flat_and_facing & kBackFacing) != 0;
  trace.depth = interpolated_depth(place);
  trace.outside_scissor = !is_inside_scissor(place.chunk.state->scissor, place.x, place.y);
  return trace;
}

}  // namespace

PixelTrace trace_pixel(std::span<const PrimitiveChunk* const> chunks, const ClearValues& clear,
                       const FramebufferOptions& frame, int x, int y) {
  FramebufferOptions one = frame;
  one.width = one.height = 1;
  Canvas canvas(one, clear);
  PixelTrace pixel;
  pixel.clear = canvas.color(0, 0);
  pixel.clear_depth = canvas.depth(0, 0);
  Fragment fragment;
  std::deque<FragmentTrace> fragments;  // the canvas remembers where they stand
  for_each_fragment(
      chunks, {frame.width, frame.height}, {{x, x + 1}, {y, y + 1}}, [&](const FragmentPlace& place) {
        FragmentTrace& trace = fragments.emplace_back(begin_trace(place));
        trace.fate.turn = canvas.turn();
        if (trace.outside_scissor) return;
        const FragmentState& state = *place.chunk.state;
        interpolate(place, fragment);
        trace.q = place.along.quantities[kRecordQ].at(static_cast<float>(x - place.along.anchor));
        for (int k = 0; k < state.varyings.count; ++k) trace.varyings.push_back(fragment.varying[k]);
        const Color color = shade_fragment(fragment, &trace.shading);
        canvas.apply(state, 0, 0, color, fragment.depth, &trace.fate);
      });
  canvas.finish();
  std::stable_sort(fragments.begin(), fragments.end(),
                   [](const FragmentTrace& a, const FragmentTrace& b) { return a.fate.turn < b.fate.turn; });
  std::move(fragments.begin(), fragments.end(), std::back_inserter(pixel.fragments));
  Framebuffer stored(one);
  canvas.store(stored);
  pixel.color = canvas.color(0, 0);
  pixel.depth = canvas.depth(0, 0);
  pixel.color8 = stored.color8()[0];
  return pixel;
}

}  // namespace barrido::raster::reference
