#include "raster/reference/fragment_walk.h"

#include <algorithm>

#include "raster/reference/arithmetic.h"
#include "raster/reference/level_of_detail.h"

namespace barrido::raster::reference {
namespace {

std::vector<Span> spans_of(const PrimitiveChunk& chunk, const PrimitiveRecord& primitive, FrameSize frame,
                           RowRange rows) {
  switch (chunk.topology) {
    case Topology::points:
      return point_spans(primitive, chunk.point_size, frame, rows);
    case Topology::lines:
      return line_spans(primitive, chunk.line_width, frame, rows);
    case Topology::triangles:
      break;
  }
  return triangle_spans(primitive, frame, rows);
}

/// Whether the triangle's box leaves the window out; a rule of speed alone.
bool is_beside(const PrimitiveRecord& p, const PixelWindow& window) {
  const auto misses = [](const std::int32_t(&at)[3], const RowRange& range) {
    const auto [least, most] = std::minmax({at[0], at[1], at[2]});
    return (most >> kSubpixelBits) < range.begin || (least >> kSubpixelBits) >= range.end;
  };
  return misses(p.x, window.columns) || misses(p.y, window.rows);
}

/// State, facing and the primitive's own colours. Colours that no varying gives are the flat ones.
void begin_fragment(const PrimitiveChunk& chunk, const PrimitiveRecord& primitive, Fragment& fragment) {
  fragment.state = chunk.state;
  fragment.back_facing = (primitive.flat_and_facing & kBackFacing) != 0;
  FlatColors flat{{0, 0, 0, 0}, {0, 0, 0}};
  const std::uint32_t flat_index = primitive.flat_and_facing & ~kBackFacing;
  if (flat_index < chunk.flat.size()) flat = chunk.flat[flat_index];
  std::copy_n(flat.color, 4, fragment.color.begin());
  std::copy_n(flat.specular, 3, fragment.specular.begin());
}

/// Depth, varyings and levels of detail at pixel x of a span.
void interpolate_at(const SpanQuantities& along, int x, Fragment& fragment) {
  const VaryingList& varyings = fragment.state->varyings;
  const auto distance = static_cast<float>(x - along.anchor);
  fragment.depth = clamp_to_unit(along.quantities[kRecordDepth].at(distance));
  const float q = maximum(along.quantities[kRecordQ].at(distance), 1e-30f);
  const float w = 1.0f / q;
  for (int k = 0; k < varyings.count; ++k) {
    const float value = along.quantities[static_cast<std::size_t>(kRecordVaryings + k)].at(distance);
    fragment.varying[k] = k < varyings.affine_count ? value : value * w;
  }
  for (int unit = 0; unit < kMaxTextureUnits; ++unit) {
    const bool is_picture = has_picture(*fragment.state, unit);
    const TextureUnit& texture = fragment.state->texture_units[static_cast<std::size_t>(unit)];
    fragment.lod[unit] = is_picture ? level_of_detail(*fragment.state, unit, along, x) : 0.0f;
    if (is_picture && has_wide_filter(texture)) {
      fragment.slopes[unit] = coordinate_slopes(*fragment.state, unit, along, x);
      fragment.lod[unit] = level_of_detail(fragment.slopes[unit], *texture.texture);
    }
    if (is_active(*fragment.state, unit) && !is_picture) {
      pixel_extent(*fragment.state, unit, along, x, fragment.extent[unit]);
    }
  }
}

}  // namespace

void for_each_span(std::span<const PrimitiveChunk* const> chunks, FrameSize frame, const PixelWindow& window,
                   const std::function<void(const FragmentPlace&)>& visit) {
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    const PrimitiveChunk& chunk = *chunks[c];
    for (std::size_t i = 0; i < chunk.primitives.size(); ++i) {
      const PrimitiveRecord& primitive = chunk.primitives[i];
      if (chunk.topology == Topology::triangles && is_beside(primitive, window)) continue;
      std::vector<Span> spans = spans_of(chunk, primitive, frame, window.rows);
      std::erase_if(spans, [&](const Span& span) {
        return span.end <= window.columns.begin || span.first >= window.columns.end;
      });
      if (spans.empty()) continue;
      const PlaneSet planes = make_planes(chunk, primitive);
      for (const Span& span : spans) {
        const SpanQuantities along = quantities_along(planes, span);
        visit({chunk, c, primitive, i, span, along, span.first, span.y});
      }
    }
  }
}

void for_each_fragment(std::span<const PrimitiveChunk* const> chunks, FrameSize frame,
                       const PixelWindow& window, const std::function<void(const FragmentPlace&)>& visit) {
  for_each_span(chunks, frame, window, [&](const FragmentPlace& start) {
    const int end = std::min(start.span.end, window.columns.end);
    for (int x = std::max(start.span.first, window.columns.begin); x < end; ++x) {
      visit({start.chunk, start.chunk_number, start.primitive, start.primitive_number, start.span,
             start.along, x, start.y});
    }
  });
}

void interpolate(const FragmentPlace& place, Fragment& fragment) {
  begin_fragment(place.chunk, place.primitive, fragment);
  interpolate_at(place.along, place.x, fragment);
}

float interpolated_depth(const FragmentPlace& place) {
  return clamp_to_unit(
      place.along.quantities[kRecordDepth].at(static_cast<float>(place.x - place.along.anchor)));
}

}  // namespace barrido::raster::reference
