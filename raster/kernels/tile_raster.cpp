// One tile from its primitives: spans, depth test, visibility, interpolation; whole batches of fragments go
// on to shade_batch. Two ways lead to the same bits: opaque primitives that overlap are first resolved to the
// span seen in each pixel and every pixel is shaded once; all others are shaded in drawing order.
#include <algorithm>
#include <cstring>

#include "raster/kernels/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/tile_raster.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/depth-inl.h"
#include "raster/kernels/interpolate-inl.h"
#include "raster/kernels/planes-inl.h"
#include "raster/kernels/spans-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Columns and rows, relative to the tile, that the scissor leaves.
struct ScissorBox {
  int x_begin = 0, y_begin = 0, x_end = kTileWidth, y_end = kTileHeight;
};

ScissorBox scissor_in(const Scissor& scissor, const TileArea& tile) {
  if (!scissor.enabled) return {};
  const auto relative = [](std::int64_t v, int origin, int limit) {
    return static_cast<int>(std::clamp<std::int64_t>(v - origin, 0, limit));
  };
  return {relative(scissor.x, tile.x, kTileWidth), relative(scissor.y, tile.y, kTileHeight),
          relative(static_cast<std::int64_t>(scissor.x) + std::max(scissor.width, 0), tile.x, kTileWidth),
          relative(static_cast<std::int64_t>(scissor.y) + std::max(scissor.height, 0), tile.y, kTileHeight)};
}

/// Opaque: what is behind a fragment that passes its tests does not matter.
bool is_opaque(const FragmentState& state) {
  return !state.blend.enabled && !state.alpha_test.enabled &&
         state.color_mask == std::array{true, true, true, true};
}

/// The colours of a flat primitive; black and transparent where the chunk has none.
const FlatColors& flat_colors(const PrimitiveChunk& chunk, const PrimitiveRecord& p) {
  static constexpr FlatColors kNone{};
  return chunk.flat.empty() ? kNone : chunk.flat[p.flat_and_facing & ~kBackFacing];
}

/// Calls visit(row, first, end) for each span of a primitive in the tile.
template <class Visit>
HWY_INLINE void for_each_span(const PrimitiveChunk& chunk, const PrimitiveRecord& p, const TileArea& tile,
                              Visit&& visit) {
  if (chunk.topology == Topology::points) return point_spans(p, chunk.point_size, tile, visit);
  if (chunk.topology == Topology::lines) return line_spans(p, chunk.line_width, tile, visit);
  TriangleSpans spans;
  if (!triangle_spans(p, tile, spans)) return;
  for (int row = spans.row_begin; row < spans.row_end; ++row) {
    if (spans.first[row] < spans.end[row]) visit(row, spans.first[row], spans.end[row]);
  }
}

class TileRasterizer {
 public:
  TileRasterizer(const TileJob& job, TileWorkspace& workspace)
      : job_(job),
        workspace_(workspace),
        tile_{job.column * kTileWidth, job.row * kTileHeight, job.width, job.height} {}

  void run() {
    const auto& chunks = *job_.chunks;
    for (std::size_t begin = 0; begin < chunks.size();) {
      std::size_t end = begin;
      while (end < chunks.size() && is_opaque(*chunks[end]->chunk().state)) ++end;
      if (end > begin && job_.visibility_first && overlaps(begin, end)) {
        draw_visible(begin, end);
      } else {
        end = std::max(end, begin + 1);
        for (std::size_t i = begin; i < end; ++i) draw_in_order(*chunks[i]);
      }
      begin = end;
    }
    flush();
  }

 private:
  std::span<const std::uint16_t> primitives_of(const BinnedChunk& binned) const {
    return binned.primitives_in(job_.column, job_.row);
  }

  /// Whether the opaque chunks [begin, end) are likely to cover the tile more than once, judged by their
  /// areas. A rule of speed alone; both ways give the same bits.
  bool overlaps(std::size_t begin, std::size_t end) const {
    const std::int64_t tile_area = static_cast<std::int64_t>(tile_.width) * tile_.height;
    std::int64_t covered = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const PrimitiveChunk& chunk = (*job_.chunks)[i]->chunk();
      if (chunk.topology != Topology::triangles) continue;
      for (const std::uint16_t number : primitives_of(*(*job_.chunks)[i])) {
        const std::int64_t area =
            std::abs(signed_area(chunk.primitives[number])) / (2 * kSubpixelUnits * kSubpixelUnits);
        covered += area < tile_area ? area : area_in_tile(chunk.primitives[number]);
      }
    }
    return 2 * covered > 3 * tile_area;
  }

  /// Of a triangle larger than the tile: half the part of its bounding box that lies in the tile, or all of
  /// the tile.
  std::int64_t area_in_tile(const PrimitiveRecord& p) const {
    TriangleSpans spans;
    if (!triangle_spans(p, tile_, spans)) return 0;
    const int middle = (spans.row_begin + spans.row_end) / 2;
    return static_cast<std::int64_t>(std::max(spans.end[middle] - spans.first[middle], 0)) *
           (spans.row_end - spans.row_begin);
  }

  /// Planes and row values for a primitive; false when it has none.
  bool set_up(const PrimitiveChunk& chunk, const PrimitiveRecord& p) {
    const int stride = record_stride(chunk.state->varyings.count);
    const float* r0 = chunk.record(p.vertex[0], stride);
    span_.planes = &planes_;
    if (chunk.topology == Topology::triangles) {
      const float* r1 = chunk.record(p.vertex[1], stride);
      const float* r2 = chunk.record(p.vertex[2], stride);
      set_up_triangle(triangle_frame(p), r0, r1, r2, stride, chunk.state->polygon_offset, planes_);
      span_.constant_q = r0[kRecordQ] == 1.0f && r1[kRecordQ] == 1.0f && r2[kRecordQ] == 1.0f;
    } else if (chunk.topology == Topology::lines) {
      set_up_line(p, r0, chunk.record(p.vertex[1], stride), stride, planes_);
      span_.constant_q = false;
    } else {
      set_up_point(p, r0, stride, planes_);
      span_.constant_q = false;
    }
    return true;
  }

  /// All shading in drawing order: blending, alpha test, or nothing to gain from resolving visibility first.
  void draw_in_order(const BinnedChunk& binned) {
    const PrimitiveChunk& chunk = binned.chunk();
    const FragmentState& state = *chunk.state;
    const ScissorBox scissor = scissor_in(state.scissor, tile_);
    const bool write_depth_now = state.depth.write && !state.alpha_test.enabled;
    for (const std::uint16_t number : primitives_of(binned)) {
      const PrimitiveRecord& p = chunk.primitives[number];
      begin_primitive(state, p);
      bool ready = false;
      for_each_span(chunk, p, tile_, [&](int row, int first, int end) HWY_ATTR {
        const int x_begin = std::max(first, scissor.x_begin);
        const int x_end = std::min(end, scissor.x_end);
        ++workspace_.statistics.spans;
        workspace_.statistics.fragments_covered += static_cast<std::uint64_t>(end - first);
        if (x_begin >= x_end || row < scissor.y_begin || row >= scissor.y_end) return;
        if (!ready) ready = set_up(chunk, p);
        evaluate_row(planes_, tile_.x + first, tile_.y + row, span_.row);
        span_.anchor = first;
        span_.last = end - 1;
        const SpanDepth depth{span_.row[kRecordDepth], planes_.slope_x[kRecordDepth], first};
        append_passing(chunk, p, state, depth, write_depth_now, row, x_begin, x_end);
      });
      // A later primitive's depth test must see what the alpha test lets through.
      if (state.alpha_test.enabled) flush();
    }
  }

  /// Tests a span's depth and appends the runs of pixels that pass.
  HWY_INLINE void append_passing(const PrimitiveChunk& chunk, const PrimitiveRecord& p,
                                 const FragmentState& state, const SpanDepth& depth, bool write, int row,
                                 int x_begin, int x_end) {
    if (!state.depth.test) return append(chunk, p, row, x_begin, x_end);
    const hn::ScalableTag<float> d;
    int run_begin = -1;  // of the run that is open
    test_depth(state.depth, write, workspace_.surface.depth + row * kTileWidth, depth, x_begin, x_end,
               [&](int x, auto mask) HWY_ATTR {
                 if (run_begin >= 0 && hn::AllTrue(d, mask)) return;
                 unsigned bits = mask_bits(d, mask);
                 if (run_begin >= 0 && (bits & 1u) == 0) {  // the open run ended with the last vector
                   append(chunk, p, row, run_begin, x);
                   run_begin = -1;
                 }
                 const int lanes = static_cast<int>(hn::Lanes(d));
                 while (bits != 0 || run_begin >= 0) {
                   if (run_begin < 0) {
                     const int begin = __builtin_ctz(bits);
                     run_begin = x + begin;
                     bits |= (1u << begin) - 1u;
                   }
                   const int end = ~bits == 0 ? lanes : __builtin_ctz(~bits);
                   if (end >= lanes) return;  // open to the next vector
                   append(chunk, p, row, run_begin, x + end);
                   run_begin = -1;
                   bits &= ~0u << end;
                 }
               });
    if (run_begin >= 0) append(chunk, p, row, run_begin, x_end);
  }

  /// Visibility before shading: the chunks write depth and span number only; then each visible run is shaded
  /// once.
  void draw_visible(std::size_t begin, std::size_t end) {
    workspace_.spans.clear();
    workspace_.primitives.clear();
    workspace_.runs.clear();
    for (std::size_t i = begin; i < end; ++i) resolve_visibility(*(*job_.chunks)[i]);
    if (workspace_.spans.empty()) return;
    collect_runs();
    for (const TilePrimitive& primitive : workspace_.primitives) {
      if (primitive.first_run >= 0) shade_visible(primitive);
    }
    std::memset(workspace_.surface.visible_span, 0, sizeof(workspace_.surface.visible_span));
  }

  void resolve_visibility(const BinnedChunk& binned) {
    const PrimitiveChunk& chunk = binned.chunk();
    const FragmentState& state = *chunk.state;
    const ScissorBox scissor = scissor_in(state.scissor, tile_);
    for (const std::uint16_t number : primitives_of(binned)) {
      const PrimitiveRecord& p = chunk.primitives[number];
      const auto position = static_cast<std::uint32_t>(workspace_.primitives.size());
      const DepthPlane plane = depth_plane(chunk, p);
      const auto slope = static_cast<float>(plane.ddx);
      bool met = false;
      for_each_span(chunk, p, tile_, [&](int row, int first, int end_column) HWY_ATTR {
        const int x_begin = std::max(first, scissor.x_begin);
        const int x_end = std::min(end_column, scissor.x_end);
        ++workspace_.statistics.spans;
        workspace_.statistics.fragments_covered += static_cast<std::uint64_t>(end_column - first);
        if (x_begin >= x_end || row < scissor.y_begin || row >= scissor.y_end) return;
        met = true;
        workspace_.spans.push_back({position, static_cast<std::int16_t>(row),
                                    static_cast<std::int16_t>(first),
                                    static_cast<std::int16_t>(end_column - 1)});
        const auto span_number = static_cast<std::uint32_t>(workspace_.spans.size());  // 0 is "none"
        const SpanDepth depth{plane.at(tile_.x + first, tile_.y + row), slope, first};
        const hn::ScalableTag<std::uint32_t> du;
        std::uint32_t* visible = workspace_.surface.visible_span + row * kTileWidth;
        test_depth(state.depth, state.depth.write, workspace_.surface.depth + row * kTileWidth, depth,
                   x_begin, x_end, [&](int x, auto mask) HWY_ATTR {
                     hn::BlendedStore(hn::Set(du, span_number), hn::RebindMask(du, mask), du, visible + x);
                   });
      });
      if (met) workspace_.primitives.push_back({&chunk, &p, -1});
    }
  }

  DepthPlane depth_plane(const PrimitiveChunk& chunk, const PrimitiveRecord& p) {
    const int stride = record_stride(chunk.state->varyings.count);
    if (chunk.topology == Topology::triangles) {
      return triangle_depth_plane(triangle_frame(p), chunk.record(p.vertex[0], stride)[kRecordDepth],
                                  chunk.record(p.vertex[1], stride)[kRecordDepth],
                                  chunk.record(p.vertex[2], stride)[kRecordDepth],
                                  chunk.state->polygon_offset);
    }
    set_up(chunk, p);
    return {planes_.x0, planes_.y0, planes_.base[kRecordDepth], planes_.ddx[kRecordDepth],
            planes_.ddy[kRecordDepth]};
  }

  /// Cuts the tile's rows into runs of one span and hands each to its primitive.
  void collect_runs() {
    for (int row = 0; row < tile_.height; ++row) {
      const std::uint32_t* visible = workspace_.surface.visible_span + row * kTileWidth;
      for (int x = 0; x < tile_.width;) {
        const std::uint32_t span = visible[x];
        const int end = end_of_run(visible, x, tile_.width);
        if (span != 0) {
          TilePrimitive& primitive = workspace_.primitives[workspace_.spans[span - 1].primitive];
          workspace_.runs.push_back(
              {span - 1, static_cast<std::int16_t>(x), static_cast<std::int16_t>(end), primitive.first_run});
          primitive.first_run = static_cast<std::int32_t>(workspace_.runs.size()) - 1;
        }
        x = end;
      }
    }
  }

  /// First column after x whose span is another.
  static HWY_INLINE int end_of_run(const std::uint32_t* visible, int x, int width) {
    const hn::ScalableTag<std::uint32_t> du;
    const int lanes = static_cast<int>(hn::Lanes(du));
    const auto same = hn::Set(du, visible[x]);
    for (int i = x & ~(lanes - 1); i < width; i += lanes) {
      const auto differs = hn::And(hn::Ne(hn::Load(du, visible + i), same),
                                   hn::Not(barrido::HWY_NAMESPACE::lanes_below(du, x - i)));
      const auto place = hn::FindFirstTrue(du, differs);
      if (place >= 0) return std::min(i + static_cast<int>(place), width);
    }
    return width;
  }

  void shade_visible(const TilePrimitive& primitive) {
    const PrimitiveChunk& chunk = *primitive.chunk;
    begin_primitive(*chunk.state, *primitive.record);
    set_up(chunk, *primitive.record);
    std::uint32_t evaluated = ~0u;
    for (std::int32_t i = primitive.first_run; i >= 0;
         i = workspace_.runs[static_cast<std::size_t>(i)].next) {
      const VisibleRun& run = workspace_.runs[static_cast<std::size_t>(i)];
      const SpanRecord& span = workspace_.spans[run.span];
      if (run.span != evaluated) {
        evaluate_row(planes_, tile_.x + span.first, tile_.y + span.row, span_.row);
        evaluated = run.span;
      }
      span_.anchor = span.first;
      span_.last = span.last;
      append(chunk, *primitive.record, span.row, run.begin, run.end);
    }
  }

  /// The batch holds fragments of one state and one facing.
  void begin_primitive(const FragmentState& state, const PrimitiveRecord& p) {
    FragmentBatch& batch = workspace_.batch;
    const bool back_facing = (p.flat_and_facing & kBackFacing) != 0;
    if (batch.count > 0 && (batch.state != &state || batch.back_facing != back_facing)) flush();
    batch.state = &state;
    batch.back_facing = back_facing;
  }

  /// Appends columns [begin, end) of the current span to the batch.
  HWY_INLINE void append(const PrimitiveChunk& chunk, const PrimitiveRecord& p, int row, int begin, int end) {
    FragmentBatch& batch = workspace_.batch;
    const FragmentState& state = *batch.state;
    const VaryingLayout& layout = state.varyings;
    while (begin < end) {
      const int at = batch.count;
      const int count = std::min(end - begin, kBatchCapacity - at);
      interpolate_varyings(span_, layout, begin, count, batch, at);
      if (state.alpha_test.enabled) interpolate_depth(span_, begin, count, batch, at);
      for (int unit = 0; unit < kMaxTextureUnits; ++unit) {
        if (is_active(state, unit) && needs_lod(state.texture_units[static_cast<std::size_t>(unit)])) {
          interpolate_lod(span_, state, unit, begin, count, batch, at);
        }
      }
      if (state.illumination.function == nullptr) fill_flat(flat_colors(chunk, p), state, count, batch, at);
      batch.runs[batch.run_count++] = {static_cast<std::int16_t>(begin), static_cast<std::int16_t>(row),
                                       static_cast<std::int16_t>(at), static_cast<std::int16_t>(at + count)};
      batch.count = at + count;
      begin += count;
      if (batch.count == kBatchCapacity) flush();
    }
  }

  void flush() {
    if (workspace_.batch.count > 0) shade_batch(workspace_);
  }

  const TileJob& job_;
  TileWorkspace& workspace_;
  const TileArea tile_;
  InterpolatedSpan span_;
  Planes planes_;
};

void RasterizeTile(const TileJob& job, TileWorkspace& workspace) { TileRasterizer(job, workspace).run(); }

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace barrido::raster {

HWY_EXPORT(RasterizeTile);

void rasterize_tile(const TileJob& job, TileWorkspace& workspace) {
  HWY_DYNAMIC_DISPATCH(RasterizeTile)(job, workspace);
}

}  // namespace barrido::raster
#endif
