// The way from chunks to fragments: which pixels each primitive covers, in drawing order, and what is
// interpolated there. Enters chunks; leaves one fragment after the other. Knows nothing of shading and of the
// frame's contents.
#pragma once

#include <functional>
#include <span>

#include "raster/fragments/primitive.h"
#include "raster/reference/fragment.h"
#include "raster/reference/planes.h"
#include "raster/reference/spans.h"
#include "raster/tiles/samples.h"

namespace barrido::raster::reference {

/// A fragment before anything is computed for it.
struct FragmentPlace {
  const PrimitiveChunk& chunk;
  std::size_t chunk_number;  ///< In the chunks that are walked.
  const PrimitiveRecord& primitive;
  std::size_t primitive_number;  ///< In the chunk.
  const Span& span;
  const SpanQuantities& along;
  int x;
  int y;
  /// Where the pixel is sampled, from its centre, in pixels; only looked at where it has a place of its own.
  bool has_place = false;
  float offset_x = 0.0f, offset_y = 0.0f;
};

/// Columns and rows [begin, end) that are asked for, in window coordinates.
struct PixelWindow {
  RowRange columns;
  RowRange rows;
};

/// Calls `visit` for every fragment inside the window, in drawing order; those outside a scissor included.
void for_each_fragment(std::span<const PrimitiveChunk* const> chunks, FrameSize frame,
                       const PixelWindow& window, const std::function<void(const FragmentPlace&)>& visit);

/// The same for spans, each called with its first pixel as the place. Spans are not cut to the window's
/// columns but touch them.
void for_each_span(std::span<const PrimitiveChunk* const> chunks, FrameSize frame, const PixelWindow& window,
                   const std::function<void(const FragmentPlace&)>& visit);

/// Where each pixel of a frame is sampled for one sample, 1/256 pixel from its lower left corner.
using PlaceOf = std::function<SamplePlace(int x, int y)>;

/// As for_each_fragment() where each pixel has a place of its own, which lies in `reach`. In a row of a tile
/// interpolation is anchored at the first pixel whose place is covered.
void for_each_placed_fragment(std::span<const PrimitiveChunk* const> chunks, FrameSize frame,
                              const SampleReach& reach, const PlaceOf& place_of,
                              const std::function<void(const FragmentPlace&)>& visit);

/// The fragment: state, facing, flat colours, depth, varyings and levels of detail.
void interpolate(const FragmentPlace& place, Fragment& fragment);

/// The fragment's depth alone; as interpolate() gives it.
float interpolated_depth(const FragmentPlace& place);

}  // namespace barrido::raster::reference
