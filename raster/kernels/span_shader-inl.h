// From spans to pixels: sets up a primitive's planes, tests depth, and sends each run of pixels on its route:
// whole batches of fragments to shade_batch, simple colours straight to the surface.
#if defined(BARRIDO_SPAN_SHADER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_SPAN_SHADER_INL_H
#undef BARRIDO_SPAN_SHADER_INL_H
#else
#define BARRIDO_SPAN_SHADER_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "raster/kernels/blocks-inl.h"
#include "raster/kernels/depth-inl.h"
#include "raster/kernels/direct-inl.h"
#include "raster/kernels/interpolate-inl.h"
#include "raster/kernels/kernels.h"
#include "raster/kernels/planes-inl.h"
#include "raster/kernels/spans-inl.h"
#include "raster/kernels/tiny_triangles-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The colours of a flat primitive; black and transparent where the chunk has none.
inline const FlatColors& flat_colors(const PrimitiveChunk& chunk, const PrimitiveRecord& p) {
  static constexpr FlatColors kNone{};
  return chunk.flat.empty() ? kNone : chunk.flat[p.flat_and_facing & ~kBackFacing];
}

/// The one colour of a flat primitive: the primary, and the secondary where it is added; to be clamped.
HWY_INLINE void flat_color(const FragmentState& state, const FlatColors& flat, float (&color)[4]) {
  const auto bounded = [&](float c) {
    if (!state.clamp_colors) return c;
    c = c > 0.0f ? c : 0.0f;
    return c < 1.0f ? c : 1.0f;
  };
  for (int c = 0; c < 4; ++c) color[c] = flat.color[c];
  if (!state.separate_specular) return;
  for (int c = 0; c < 3; ++c) color[c] = bounded(flat.color[c]) + bounded(flat.specular[c]);
}

/// Shades spans one primitive at a time: begin_chunk, begin_primitive, then for each span start_span and what
/// is to be drawn of it. Fragments may stay in the batch until flush().
class SpanShader {
 public:
  SpanShader(TileWorkspace& workspace, const TileArea& tile) : workspace_(workspace), tile_(tile) {}

  void begin_chunk(const PrimitiveChunk& chunk) {
    const FragmentState& state = *chunk.state;
    chunk_ = &chunk;
    route_ = route_of(state, workspace_.surface.format);
    writes_depth_now_ = state.depth.write && !state.alpha_test.enabled;
    const bool divides = state.varyings.count > state.varyings.affine_count;
    interpolations_ = static_cast<std::uint64_t>(state.varyings.count + (divides ? 1 : 0));
    if (route_ == Route::smooth_blend_constant) blend_constant_ = BlendConstant(state.blend);
    color_is_replaced_ = color_is_replaced(state);
    has_flat_colors_ = state.illumination.function == nullptr &&
                       ((state.varyings.color == kAbsent && !color_is_replaced_) ||
                        (state.varyings.specular == kAbsent && state.separate_specular));
    lod_units_ = 0;
    for (int unit = 0; unit < kMaxTextureUnits; ++unit) {
      const bool needed =
          is_active(state, unit) && needs_lod(state.texture_units[static_cast<std::size_t>(unit)]);
      lod_units_ |= static_cast<unsigned>(needed) << unit;
    }
  }

  /// The batch holds fragments of one state and one facing.
  void begin_primitive(const PrimitiveRecord& p) {
    FragmentBatch& batch = workspace_.batch;
    const bool back_facing = (p.flat_and_facing & kBackFacing) != 0;
    if (batch.count > 0 && (batch.state != chunk_->state || batch.back_facing != back_facing)) flush();
    batch.state = chunk_->state;
    batch.back_facing = back_facing;
    primitive_ = &p;
    is_set_up_ = false;
  }

  /// The span of a row, columns [first, end) before the scissor: interpolation is anchored at `first`.
  void start_span(int row, int first, int end) {
    if (!is_set_up_) set_up();
    evaluate_row(planes_, tile_.x + first, tile_.y + row, span_.row);
    span_.anchor = first;
    span_.last = end - 1;
  }

  /// Columns [begin, end) of the span, all of them seen.
  void shade(int row, int begin, int end) {
    if (route_ == Route::batch) return append(row, begin, end);
    const hn::ScalableTag<float> d;
    count_shaded(static_cast<std::uint64_t>(end - begin));
    with_pixels(begin, end, [&](const auto& pixels) HWY_ATTR {
      const Pixels to = row_pixels(row);
      const int lanes = static_cast<int>(hn::Lanes(d));
      for (int x = first_vector(begin, end, lanes); x < end; x += lanes) {
        pixels(to, x, columns_mask(d, x, begin, end),
               barrido::HWY_NAMESPACE::lanes_from(d, static_cast<float>(x - span_.anchor)));
      }
    });
  }

  /// Those of columns [begin, end) that pass the depth test.
  void shade_passing(int row, int begin, int end) {
    const DepthState& state = chunk_->state->depth;
    if (!state.test) return shade(row, begin, end);
    if (route_ == Route::batch) return append_passing(row, begin, end);
    const hn::ScalableTag<float> d;
    std::size_t passed = 0;
    with_pixels(begin, end, [&](const auto& pixels) HWY_ATTR {
      const Pixels to = row_pixels(row);
      test_depth(
          state, writes_depth_now_, workspace_.surface.depth + row * kTileWidth, span_depth(),
          first_vector(begin, end, static_cast<int>(hn::Lanes(d))), begin,
          end, [&](int x, auto mask, auto column) HWY_ATTR __attribute__((always_inline)) {
            const std::size_t here = hn::CountTrue(d, mask);
            if (here == 0) return;
            passed += here;
            pixels(to, x, mask, column);
          });
    });
    count_shaded(passed);
  }

  /// Whether small triangles may be drawn in blocks.
  bool takes_blocks() const { return route_ == Route::flat || route_ == Route::smooth; }

  /// All of a small triangle at once, its depth test included.
  void shade_blocks(TriangleBlocks& blocks, const TriangleSpans& spans) { blocks.draw(spans, block_paint()); }
  /// Counts what the blocks have drawn.
  void count_blocks(const TriangleBlocks& blocks) {
    const TriangleBlocks::Counts counts = blocks.counts();
    workspace_.statistics.spans += counts.spans;
    workspace_.statistics.fragments_covered += counts.covered;
    count_shaded(counts.shaded);
  }

  /// Whether tiny triangles may be drawn pixel by pixel, unless the scissor cuts them.
  bool takes_tiny() const {
    const FragmentState& state = *chunk_->state;
    return takes_blocks() && state.depth.test && state.depth.write && state.depth.compare == Compare::less &&
           !state.polygon_offset.enabled && record_stride(state.varyings.count) == kTinyQuantities;
  }
  TinyPaint tiny_paint() const {
    const VaryingLayout& layout = chunk_->state->varyings;
    return {route_ == Route::flat, kRecordVaryings + layout.color, layout.color >= layout.affine_count};
  }

  /// Takes a tiny triangle of the coverage for a later draw_tiny().
  HWY_INLINE void add_tiny(TinyTriangles& tiny, const TinyCoverage& coverage, std::size_t i) {
    if (coverage.pixels(i) == 0) return;
    const auto record = [&](int vertex) {
      return chunk_->record(primitive_->vertex[vertex], kTinyQuantities);
    };
    tiny.add(coverage, i, record(0), record(1), record(2),
             route_ == Route::flat ? find_flat_color() : nullptr);
    if (tiny.is_full()) draw_tiny(tiny);
  }

  /// Draws and counts the tiny triangles that have been taken.
  void draw_tiny(TinyTriangles& tiny) {
    const TinyTriangles::Counts counts = tiny.draw();
    workspace_.statistics.spans += counts.spans;
    workspace_.statistics.fragments_covered += counts.covered;
    count_shaded(counts.shaded);
  }

  void flush() {
    if (workspace_.batch.count > 0) shade_batch(workspace_);
  }

 private:
  BlockPaint block_paint() {
    if (!is_set_up_) set_up();
    const VaryingLayout& layout = chunk_->state->varyings;
    const int stride = record_stride(layout.count);
    const float* r0 = chunk_->record(primitive_->vertex[0], stride);
    const float* r1 = chunk_->record(primitive_->vertex[1], stride);
    const float* r2 = chunk_->record(primitive_->vertex[2], stride);
    const bool plain_depth = !chunk_->state->polygon_offset.enabled && has_plain_depth(r0, r1, r2);
    if (route_ == Route::flat) return {planes_, find_flat_color(), 0, false, plain_depth};
    const int color = kRecordVaryings + layout.color;
    const bool is_divided = divides(layout, span_);
    const bool is_plain =
        plain_depth && (is_divided || span_.constant_q) && has_plain_colors(r0, r1, r2, color);
    return {planes_, nullptr, color, is_divided, is_plain};
  }

  SpanDepth span_depth() const {
    return {span_.row[kRecordDepth], planes_.slope_x[kRecordDepth], span_.anchor};
  }
  Pixels row_pixels(int row) const {
    return reinterpret_cast<Pixels>(workspace_.surface.color8 + row * kTileWidth);
  }

  /// Counted where no batch does it.
  void count_shaded(std::uint64_t fragments) {
    workspace_.statistics.fragments_shaded += fragments;
    workspace_.statistics.interpolations += fragments * interpolations_;
  }

  /// Calls draw(pixels) with what makes the colours of the span's columns [begin, end).
  template <class Draw>
  HWY_INLINE void with_pixels(int begin, int end, Draw&& draw) {
    const FragmentState& state = *chunk_->state;
    switch (route_) {
      case Route::flat:
        return draw(FlatPixels(find_flat_color()));
      case Route::smooth_blend_constant:
        return with_smooth_pixels(begin, end, blend_constant_, draw);
      case Route::smooth_blend_source_alpha:
        return with_smooth_pixels(begin, end, BlendSourceAlpha(state.blend), draw);
      case Route::smooth:
      case Route::batch:
        break;
    }
    with_smooth_pixels(begin, end, Replace(state.blend), draw);
  }

  template <class Blend, class Draw>
  HWY_INLINE void with_smooth_pixels(int begin, int end, const Blend& blend, Draw&& draw) {
    const VaryingLayout& layout = chunk_->state->varyings;
    const int color = kRecordVaryings + layout.color;
    if (divides(layout, span_) || !colors_are_unit(span_, color, begin, end)) {
      draw(SmoothPixels<Blend, false, false>(layout, span_, blend));
    } else if (Blend::kReads && planes_.slope_x[color + 3] == 0.0f) {
      draw(SmoothPixels<Blend, true, true>(layout, span_, blend));
    } else {
      draw(SmoothPixels<Blend, true, false>(layout, span_, blend));
    }
  }

  /// The primitive's colour on Route::flat.
  const float* find_flat_color() {
    flat_color(*chunk_->state, flat_colors(*chunk_, *primitive_), flat_color_);
    return flat_color_;
  }

  void set_up() {
    const PrimitiveChunk& chunk = *chunk_;
    const PrimitiveRecord& p = *primitive_;
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
    is_set_up_ = true;
  }

  /// Tests the span's depth and appends the runs of pixels that pass. Mostly that is all of them, so their
  /// varyings are interpolated as they are tested.
  void append_passing(int row, int x_begin, int x_end) {
    const hn::ScalableTag<float> d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    FragmentBatch& batch = workspace_.batch;
    if (batch.count + (x_end - x_begin) > kBatchCapacity) flush();
    const int at = batch.count;
    std::uint32_t passed[kTileWidth / 4];  // bits of a vector each, lane 0 lowest
    int vectors = 0;
    bool all = true;
    test_depth(
        chunk_->state->depth, writes_depth_now_, workspace_.surface.depth + row * kTileWidth, span_depth(),
        x_begin, x_begin, x_end, [&](int x, auto mask, auto column) HWY_ATTR __attribute__((always_inline)) {
          const std::uint32_t bits = mask_bits(d, mask);
          passed[vectors++] = bits;
          all = all && bits == (1u << std::min(x_end - x, lanes)) - 1;
          if (all) {
            interpolate_vector(d, span_, batch.state->varyings, column, batch, at + (x - x_begin));
          }
        });
    if (all) return append_interpolated(row, x_begin, x_end);
    append_runs(row, x_begin, x_end, passed, lanes);
  }

  /// `bits` are the pixels that passed, `lanes` in each number, from column x on.
  void append_runs(int row, int x, int x_end, const std::uint32_t* bits, int lanes) {
    int run_begin = -1;  // of the run that is open
    for (int v = 0; x < x_end; ++v, x += lanes) {
      std::uint32_t open = bits[v];  // from the lane we have come to on
      for (int lane = 0; lane < lanes;) {
        if (run_begin < 0) {
          if (open == 0) break;
          lane = __builtin_ctz(open);
          run_begin = x + lane;
        }
        lane = std::min(lanes, __builtin_ctz(~open & (~0u << lane)));
        if (lane == lanes) break;  // goes on in the next vector
        append(row, run_begin, x + lane);
        run_begin = -1;
        open &= ~0u << lane;
      }
    }
    if (run_begin >= 0) append(row, run_begin, x_end);
  }

  /// Appends columns [begin, end) of the current span to the batch.
  void append(int row, int begin, int end) {
    FragmentBatch& batch = workspace_.batch;
    while (begin < end) {
      const int count = std::min(end - begin, kBatchCapacity - batch.count);
      interpolate_varyings(span_, batch.state->varyings, begin, count, batch, batch.count);
      append_interpolated(row, begin, begin + count);
      begin += count;
    }
  }

  /// The same for columns whose varyings are in the batch already, which has room for them.
  void append_interpolated(int row, int begin, int end) {
    FragmentBatch& batch = workspace_.batch;
    const FragmentState& state = *batch.state;
    const int at = batch.count;
    const int count = end - begin;
    if (state.alpha_test.enabled) interpolate_depth(span_, begin, count, batch, at);
    if (lod_units_ != 0) append_lod(begin, count);
    if (has_flat_colors_)
      fill_flat(flat_colors(*chunk_, *primitive_), state, color_is_replaced_, count, batch, at);
    batch.runs[batch.run_count++] = {static_cast<std::int16_t>(begin), static_cast<std::int16_t>(row),
                                     static_cast<std::int16_t>(at), static_cast<std::int16_t>(at + count)};
    batch.count = at + count;
    if (batch.count == kBatchCapacity) flush();
  }

  void append_lod(int begin, int count) {
    for (unsigned units = lod_units_; units != 0; units &= units - 1) {
      const int unit = __builtin_ctz(units);
      append_lod_groups(span_, *chunk_->state, unit, begin, count, workspace_.lod_groups[unit],
                        workspace_.lod_group_count);
    }
    workspace_.lod_group_count += lod_groups_in(begin, count);
  }

  TileWorkspace& workspace_;
  const TileArea tile_;
  const PrimitiveChunk* chunk_ = nullptr;
  const PrimitiveRecord* primitive_ = nullptr;
  Route route_ = Route::batch;
  bool writes_depth_now_ = true;
  bool is_set_up_ = false;
  bool color_is_replaced_ = false;
  bool has_flat_colors_ = false;  ///< Colours that are the same for a whole primitive.
  unsigned lod_units_ = 0;  ///< Bit u: texture unit u is on and its filters ask for the level of detail.
  std::uint64_t interpolations_ = 0;  ///< Quantities a shaded fragment.
  float flat_color_[4];
  BlendConstant blend_constant_{BlendState{}};
  InterpolatedSpan span_;
  Planes planes_;
};

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
