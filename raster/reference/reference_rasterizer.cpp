#include "raster/reference/reference_rasterizer.h"

#include <memory>

#include "raster/fragment_batch.h"
#include "raster/reference/canvas.h"
#include "raster/reference/fragment_operations.h"
#include "raster/reference/level_of_detail.h"
#include "raster/reference/planes.h"
#include "raster/reference/shading.h"
#include "raster/reference/spans.h"

namespace barrido::raster::reference {
namespace {

std::vector<Span> spans_of(const PrimitiveChunk& chunk, const PrimitiveRecord& primitive, FrameSize frame) {
  switch (chunk.topology) {
    case Topology::points:
      return point_spans(primitive, chunk.point_size, frame);
    case Topology::lines:
      return line_spans(primitive, chunk.line_width, frame);
    case Topology::triangles:
      break;
  }
  return triangle_spans(primitive, frame);
}

/// State, facing and the primitive's own colours. Colours that no varying gives are the flat ones.
void begin_fragment(const PrimitiveChunk& chunk, const PrimitiveRecord& primitive, FragmentBatch& batch) {
  batch.state = chunk.state;
  batch.back_facing = (primitive.flat_and_facing & kBackFacing) != 0;
  batch.count = 1;
  batch.run_count = 1;
  FlatColors flat{{0, 0, 0, 0}, {0, 0, 0}};
  const std::uint32_t flat_index = primitive.flat_and_facing & ~kBackFacing;
  if (flat_index < chunk.flat.size()) flat = chunk.flat[flat_index];
  for (int c = 0; c < 4; ++c) batch.color[c][0] = flat.color[c];
  for (int c = 0; c < 3; ++c) batch.specular[c][0] = flat.specular[c];
}

/// Depth, varyings and levels of detail at pixel x of a span.
void interpolate(const SpanQuantities& along, int x, int y, FragmentBatch& batch) {
  const VaryingLayout& layout = batch.state->varyings;
  const auto distance = static_cast<float>(x - along.anchor);
  batch.runs[0] = {static_cast<std::int16_t>(x % kTileWidth), static_cast<std::int16_t>(y % kTileHeight), 0,
                   1};
  batch.depth[0] = clamp_to_unit(along.quantities[kRecordDepth].at(distance));
  const float q = maximum(along.quantities[kRecordQ].at(distance), 1e-30f);
  const float w = 1.0f / q;
  for (int k = 0; k < layout.count; ++k) {
    const float value = along.quantities[static_cast<std::size_t>(kRecordVaryings + k)].at(distance);
    batch.varying[k][0] = k < layout.affine_count ? value : value * w;
  }
  for (int unit = 0; unit < kMaxTextureUnits; ++unit) {
    batch.lod[unit][0] =
        is_unit_active(*batch.state, unit) ? level_of_detail(*batch.state, unit, along, x) : 0.0f;
  }
}

void draw_primitive(const PrimitiveChunk& chunk, const PrimitiveRecord& primitive, FrameSize frame,
                    FragmentBatch& batch, Canvas& canvas) {
  const std::vector<Span> spans = spans_of(chunk, primitive, frame);
  if (spans.empty()) return;
  const PlaneSet planes = make_planes(chunk, primitive);
  const FragmentState& state = *chunk.state;
  for (const Span& span : spans) {
    const SpanQuantities along = quantities_along(planes, span);
    for (int x = span.first; x < span.end; ++x) {
      if (!is_inside_scissor(state.scissor, x, span.y)) continue;
      begin_fragment(chunk, primitive, batch);
      interpolate(along, x, span.y, batch);
      const Color color = shade_fragment(batch);
      canvas.apply(state, x, span.y, color, batch.depth[0]);
    }
  }
}

}  // namespace

void rasterize(std::span<const PrimitiveChunk* const> chunks, const ClearValues& clear,
               Framebuffer& framebuffer) {
  const FrameSize frame{framebuffer.width(), framebuffer.height()};
  Canvas canvas(framebuffer.options(), clear);
  const auto batch = std::make_unique<FragmentBatch>();
  for (const PrimitiveChunk* chunk : chunks) {
    for (const PrimitiveRecord& primitive : chunk->primitives) {
      draw_primitive(*chunk, primitive, frame, *batch, canvas);
    }
  }
  canvas.store(framebuffer);
}

}  // namespace barrido::raster::reference
