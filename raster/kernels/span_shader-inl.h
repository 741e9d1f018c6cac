// From spans to pixels: sets up a primitive's planes, tests depth, and sends each run of pixels on the way
// that the key names: whole batches of fragments to shade_batch, simple colours straight to the surface.
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
  /// `places`: null where all pixels are sampled at the same place.
  SpanShader(TileWorkspace& workspace, const TileArea& tile, const TilePlaces* places = nullptr)
      : workspace_(workspace), tile_(tile), places_(places) {}

  void begin_chunk(const BinnedChunk& binned) {
    chunk_ = &binned.chunk();
    key_ = &binned.key();
    const FragmentState& state = *chunk_->state;
    any_depth_ = AnyDepth(state.depth, *key_);
    if (key_->blending == Blending::constant) blend_constant_ = BlendConstant(state.blend);
    color_ = kRecordVaryings + state.varyings.at(Meaning::color);
    interpolations_ = quantities_a_fragment(state.varyings);
  }

  /// The batch holds fragments of one state and one facing.
  void begin_primitive(const PrimitiveRecord& p) {
    FragmentBatch& batch = workspace_.batch;
    const bool back_facing = (p.flat_and_facing & kBackFacing) != 0;
    if (batch.count > 0 && (batch.state != chunk_->state || batch.back_facing != back_facing)) flush();
    batch.state = chunk_->state;
    workspace_.key = key_;
    batch.back_facing = back_facing;
    primitive_ = &p;
    is_set_up_ = false;
  }

  /// The span of a row, columns [first, end) before the scissor: interpolation is anchored at `first`.
  void start_span(int row, int first, int end) {
    if (!is_set_up_) set_up();
    evaluate_row(planes_, tile_.pixel_x(first), tile_.pixel_y(row), span_.row);
    span_.anchor = first;
    span_.last = end - 1;
  }

  /// Columns [begin, end) of the span, all of them seen.
  void shade(int row, int begin, int end) {
    if (key_->colors == ColorWay::batch) return append(row, begin, end);
    const hn::ScalableTag<float> d;
    count_shaded(Loop::spans, end - begin);
    with_pixels(begin, end, [&](const auto& pixels) HWY_ATTR {
      const Pixels to = row_pixels(row);
      const int lanes = static_cast<int>(hn::Lanes(d));
      for (int x = first_vector(begin, end, lanes); x < end; x += lanes) {
        pixels(to, x, columns_mask(d, x, begin, end), lanes_from(d, static_cast<float>(x - span_.anchor)));
      }
    });
  }

  /// Those of columns [begin, end) that pass the depth test.
  void shade_passing(int row, int begin, int end) {
    if (key_->depth == DepthTest::off) return shade(row, begin, end);
    if (key_->colors == ColorWay::batch) return append_passing(row, begin, end);
    const hn::ScalableTag<float> d;
    std::size_t passed = 0;
    with_pixels(begin, end, [&](const auto& pixels) HWY_ATTR {
      const Pixels to = row_pixels(row);
      test_depth(
          *key_, any_depth_, workspace_.surface.depth + row * kTileWidth, span_depth(),
          first_vector(begin, end, static_cast<int>(hn::Lanes(d))), begin,
          end, [&](int x, auto mask, auto column) HWY_ATTR __attribute__((always_inline)) {
            const std::size_t here = hn::CountTrue(d, mask);
            if (here == 0) return;
            passed += here;
            pixels(to, x, mask, column);
          });
    });
    count_shaded(Loop::spans, passed);
  }

  /// Those of the row's pixels, all of one span with places of their own, that pass the depth test.
  void shade_placed(int row, const PixelBits& covered, const ScissorBox& scissor) {
    workspace_.statistics.spans += 1;
    workspace_.statistics.fragments_covered += static_cast<std::uint64_t>(covered.count());
    PixelBits seen = covered & PixelBits::of(scissor.x_begin, scissor.x_end);
    if (seen.none() || row < scissor.y_begin || row >= scissor.y_end) return;
    start_span(row, covered.first(), covered.last() + 1);
    if (key_->depth != DepthTest::off) seen = test_placed_depth(row, seen);
    for (int begin = 0; !(seen = seen & PixelBits::of(begin, kTileWidth)).none();) {
      const int first = seen.first();
      int end = first + 1;
      while (end < kTileWidth && seen.has(end)) ++end;
      append(row, first, end);
      begin = end;
    }
  }

  const AnyDepth& any_depth() const { return any_depth_; }

  /// All of a small triangle at once, its depth test included.
  void shade_blocks(TriangleBlocks& blocks, const TriangleSpans& spans) { blocks.draw(spans, block_paint()); }
  void count(Loop loop, const LoopCounts& counts) {
    workspace_.statistics.spans += counts.spans;
    workspace_.statistics.fragments_covered += counts.covered;
    count_shaded(loop, counts.shaded);
  }

  TinyPaint tiny_paint() const { return {key_->colors == ColorWay::flat, color_, key_->divides_color}; }

  /// Takes a tiny triangle of the coverage for a later draw_tiny().
  HWY_INLINE void add_tiny(TinyTriangles& tiny, const TinyCoverage& coverage, std::size_t i) {
    if (coverage.pixels(i) == 0) return;
    const auto record = [&](int vertex) {
      return chunk_->record(primitive_->vertex[vertex], kTinyQuantities);
    };
    tiny.add(coverage, i, record(0), record(1), record(2),
             key_->colors == ColorWay::flat ? find_flat_color() : nullptr);
    if (tiny.is_full()) draw_tiny(tiny);
  }

  /// Draws and counts the tiny triangles that have been taken.
  void draw_tiny(TinyTriangles& tiny) { count(Loop::lists, tiny.draw()); }

  void flush() {
    if (workspace_.batch.count > 0) shade_batch(workspace_);
  }

 private:
  PixelBits test_placed_depth(int row, const PixelBits& covered) {
    const hn::ScalableTag<float> d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    float* stored = workspace_.surface.depth + row * kTileWidth;
    PixelBits passed;
    for (int x = covered.first() & ~(lanes - 1); x < kTileWidth; x += lanes) {
      const unsigned here = covered.at(x, lanes);
      if (here == 0) continue;
      const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(here), static_cast<std::uint8_t>(here >> 8)};
      auto mask = hn::LoadMaskBits(d, bytes);
      const auto z = any_depth_.bounded(placed_depth(d, span_, *places_, row, x));
      mask = hn::And(mask, any_depth_.passes(z, hn::Load(d, stored + x)));
      hn::BlendedStore(z, any_depth_.written(mask), d, stored + x);
      passed.put(x, mask_bits(d, mask));
    }
    return passed;
  }

  BlockPaint block_paint() {
    if (!is_set_up_) set_up();
    const int stride = record_stride(chunk_->state->varyings.count);
    const float* r0 = chunk_->record(primitive_->vertex[0], stride);
    const float* r1 = chunk_->record(primitive_->vertex[1], stride);
    const float* r2 = chunk_->record(primitive_->vertex[2], stride);
    const bool plain_depth = !chunk_->state->polygon_offset.enabled && has_plain_depth(r0, r1, r2);
    if (key_->colors == ColorWay::flat) return {planes_, find_flat_color(), 0, false, plain_depth};
    const bool is_plain =
        plain_depth && (divides() || span_.constant_q) && has_plain_colors(r0, r1, r2, color_);
    return {planes_, nullptr, color_, divides(), is_plain};
  }

  SpanDepth span_depth() const {
    return {span_.row[kRecordDepth], planes_.slope_x[kRecordDepth], span_.anchor};
  }
  Pixels row_pixels(int row) const {
    return reinterpret_cast<Pixels>(workspace_.surface.color8 + row * kTileWidth);
  }

  /// Whether the colours of the primitive are divided by q.
  bool divides() const { return key_->divides_color && !span_.constant_q; }

  /// Counted where no batch does it.
  void count_shaded(Loop loop, std::uint64_t fragments) {
    workspace_.statistics.shaded_in[static_cast<std::size_t>(loop)] += fragments;
    workspace_.statistics.interpolations += fragments * interpolations_;
  }

  /// Calls draw(pixels) with what makes the colours of the span's columns [begin, end).
  template <class Draw>
  HWY_INLINE void with_pixels(int begin, int end, Draw&& draw) {
    if (key_->colors == ColorWay::flat) return draw(FlatPixels(find_flat_color()));
    const BlendState& blend = chunk_->state->blend;
    if (key_->blending == Blending::constant) return with_smooth_pixels(begin, end, blend_constant_, draw);
    if (key_->blending == Blending::source_alpha) {
      return with_smooth_pixels(begin, end, BlendSourceAlpha(blend), draw);
    }
    with_smooth_pixels(begin, end, Replace(blend), draw);
  }

  template <class Blend, class Draw>
  HWY_INLINE void with_smooth_pixels(int begin, int end, const Blend& blend, Draw&& draw) {
    if (divides() || !colors_are_unit(span_, color_, begin, end)) {
      draw(SmoothPixels<Blend, false, false>(span_, color_, divides(), blend));
    } else if (Blend::kReads && planes_.slope_x[color_ + 3] == 0.0f) {
      draw(SmoothPixels<Blend, true, true>(span_, color_, false, blend));
    } else {
      draw(SmoothPixels<Blend, true, false>(span_, color_, false, blend));
    }
  }

  /// The primitive's colour on ColorWay::flat.
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
    span_.constant_q = false;
    if (chunk.topology == Topology::triangles) {
      const float* r1 = chunk.record(p.vertex[1], stride);
      const float* r2 = chunk.record(p.vertex[2], stride);
      set_up_triangle(triangle_frame(p), r0, r1, r2, stride, chunk.state->polygon_offset, planes_);
      span_.constant_q = r0[kRecordQ] == 1.0f && r1[kRecordQ] == 1.0f && r2[kRecordQ] == 1.0f;
    } else {
      const bool is_line = chunk.topology == Topology::lines;
      set_up_line(p, r0, is_line ? chunk.record(p.vertex[1], stride) : nullptr, stride, planes_);
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
        *key_, any_depth_, workspace_.surface.depth + row * kTileWidth, span_depth(), x_begin, x_begin,
        x_end, [&](int x, auto mask, auto column) HWY_ATTR __attribute__((always_inline)) {
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
      if (places_ == nullptr) {
        interpolate_varyings(span_, batch.state->varyings, begin, count, batch, batch.count);
      } else {
        interpolate_placed(span_, batch.state->varyings, *places_, row, begin, count, batch, batch.count);
      }
      append_interpolated(row, begin, begin + count);
      begin += count;
    }
  }

  /// The same for columns whose varyings are in the batch already, which has room for them.
  void append_interpolated(int row, int begin, int end) {
    FragmentBatch& batch = workspace_.batch;
    const int at = batch.count;
    const int count = end - begin;
    if ((key_->late_depth || key_->sorted) && places_ == nullptr)
      interpolate_depth(span_, begin, count, batch, at);
    if (key_->lod_units != 0) append_lod(begin, count);
    if (key_->fills_primary || key_->fills_secondary) {
      fill_flat(flat_colors(*chunk_, *primitive_), *key_, batch.state->clamp_colors, count, batch, at);
    }
    batch.runs[batch.run_count++] = {static_cast<std::int16_t>(begin), static_cast<std::int16_t>(row),
                                     static_cast<std::int16_t>(at), static_cast<std::int16_t>(at + count)};
    batch.count = at + count;
    if (batch.count == kBatchCapacity) flush();
  }

  void append_lod(int begin, int count) {
    for (unsigned units = key_->lod_units; units != 0; units &= units - 1) {
      const int unit = __builtin_ctz(units);
      append_lod_groups(span_, *chunk_->state, unit, begin, count, workspace_.lod_groups[unit],
                        workspace_.lod_group_count);
    }
    workspace_.lod_group_count += lod_groups_in(begin, count);
  }

  TileWorkspace& workspace_;
  const TileArea tile_;
  const TilePlaces* places_;
  const PrimitiveChunk* chunk_ = nullptr;
  const KernelKey* key_ = nullptr;
  const PrimitiveRecord* primitive_ = nullptr;
  bool is_set_up_ = false;
  int color_ = 0;                     ///< First of the primary colour's quantities.
  std::uint64_t interpolations_ = 0;  ///< Quantities a shaded fragment.
  AnyDepth any_depth_{DepthState{}, KernelKey{}};
  float flat_color_[4];
  BlendConstant blend_constant_{BlendState{}};
  InterpolatedSpan span_;
  Planes planes_;
};

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
