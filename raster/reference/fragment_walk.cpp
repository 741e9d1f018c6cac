#include "raster/reference/fragment_walk.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

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

float value_at(const FragmentPlace& place, int number) {
  const SpanQuantity& quantity = place.along.quantities[static_cast<std::size_t>(number)];
  const auto distance = static_cast<float>(place.x - place.along.anchor);
  if (!place.has_place) return quantity.at(distance);
  return quantity.at(distance + place.offset_x) + quantity.ddy * place.offset_y;
}

/// Whether the primitive covers pixel (x, y) when that is sampled at `place`: moved the other way, its
/// centre.
bool covers(const PrimitiveChunk& chunk, const PrimitiveRecord& primitive, FrameSize frame, int x, int y,
            const SamplePlace& place) {
  PrimitiveRecord moved = primitive;
  for (std::int32_t& v : moved.x) v -= place.x - kSubpixelUnits / 2;
  for (std::int32_t& v : moved.y) v -= place.y - kSubpixelUnits / 2;
  for (const Span& span : spans_of(chunk, moved, frame, {y, y + 1})) {
    if (x >= span.first && x < span.end) return true;
  }
  return false;
}

/// Depth, varyings and levels of detail at the pixel of a span.
void interpolate_at(const FragmentPlace& place, Fragment& fragment) {
  const SpanQuantities& along = place.along;
  const int x = place.x;
  const VaryingList& varyings = fragment.state->varyings;
  const auto value_of = [&](int quantity) { return value_at(place, quantity); };
  fragment.depth = clamp_to_unit(value_of(kRecordDepth));
  const float q = maximum(value_of(kRecordQ), 1e-30f);
  const float w = 1.0f / q;
  for (int k = 0; k < varyings.count; ++k) {
    const float value = value_of(kRecordVaryings + k);
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

/// Pixels that may be covered: generously.
PixelWindow window_of(const PrimitiveChunk& chunk, const PrimitiveRecord& p, FrameSize frame,
                      const SampleReach& reach) {
  const int ends = chunk.topology == Topology::points ? 1 : chunk.topology == Topology::lines ? 2 : 3;
  const float width = chunk.topology == Topology::points  ? chunk.point_size
                      : chunk.topology == Topology::lines ? chunk.line_width
                                                          : 0.0f;
  const int margin =
      static_cast<int>(std::min(width, 1.0f * kMaxFrameSide)) + 3 +
      std::max({std::abs(reach.least.x), std::abs(reach.least.y), reach.most.x, reach.most.y}) /
          kSubpixelUnits;
  const auto range = [&](const std::int32_t* v, int size) {
    const auto [least, most] = std::minmax_element(v, v + ends);
    return RowRange{std::max((*least >> kSubpixelBits) - margin, 0),
                    std::min((*most >> kSubpixelBits) + margin, size)};
  };
  return {range(p.x, frame.width), range(p.y, frame.height)};
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

void for_each_placed_fragment(std::span<const PrimitiveChunk* const> chunks, FrameSize frame,
                              const SampleReach& reach, const PlaceOf& place_of,
                              const std::function<void(const FragmentPlace&)>& visit) {
  constexpr float kUnit = 1.0f / kSubpixelUnits;
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    const PrimitiveChunk& chunk = *chunks[c];
    for (std::size_t i = 0; i < chunk.primitives.size(); ++i) {
      const PrimitiveRecord& p = chunk.primitives[i];
      const PixelWindow box = window_of(chunk, p, frame, reach);
      std::optional<PlaneSet> planes;
      for (int y = box.rows.begin; y < box.rows.end; ++y) {
        for (int begin = box.columns.begin; begin < box.columns.end;) {
          const int end = std::min(box.columns.end, (begin / kTileWidth + 1) * kTileWidth);
          std::vector<int> covered;
          for (int x = begin; x < end; ++x) {
            if (covers(chunk, p, frame, x, y, place_of(x, y))) covered.push_back(x);
          }
          begin = end;
          if (covered.empty()) continue;
          if (!planes) planes = make_planes(chunk, p);
          const Span span{y, covered.front(), covered.back() + 1};
          const SpanQuantities along = quantities_along(*planes, span);
          for (const int x : covered) {
            const SamplePlace place = place_of(x, y);
            visit({chunk, c, p, i, span, along, x, y, true,
                   static_cast<float>(place.x - kSubpixelUnits / 2) * kUnit,
                   static_cast<float>(place.y - kSubpixelUnits / 2) * kUnit});
          }
        }
      }
    }
  }
}

void interpolate(const FragmentPlace& place, Fragment& fragment) {
  begin_fragment(place.chunk, place.primitive, fragment);
  interpolate_at(place, fragment);
}

float interpolated_depth(const FragmentPlace& place) { return clamp_to_unit(value_at(place, kRecordDepth)); }

}  // namespace barrido::raster::reference
