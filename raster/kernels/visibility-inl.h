// Visibility before shading: which of the opaque triangles of a tile is seen in each pixel. Enters: triangles
// in drawing order. Leaves: the tile's depth, and in every pixel the mark of the span seen there. Triangles
// are taken from the nearest to the farthest where that cannot change the outcome, so that what is hidden
// costs a comparison a row or less.
#if defined(BARRIDO_VISIBILITY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_VISIBILITY_INL_H
#undef BARRIDO_VISIBILITY_INL_H
#else
#define BARRIDO_VISIBILITY_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "raster/kernels/depth-inl.h"
#include "raster/kernels/lanes-inl.h"
#include "raster/kernels/planes-inl.h"
#include "raster/kernels/spans-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// More triangles than this are not sorted: small ones hide too little to pay for it.
inline constexpr std::size_t kMostSorted = 96;

/// The part of each row that is known to be covered, and how far away it is at most.
struct CoveredRows {
  std::int16_t begin[kTileHeight];
  std::int16_t end[kTileHeight];
  float far_part[kTileHeight];  ///< Largest depth in [begin, end).
  float far_row[kTileHeight];   ///< Largest depth of the whole row, once all of it has been covered.

  CoveredRows() {
    for (int row = 0; row < kTileHeight; ++row) {
      begin[row] = end[row] = 0;
      far_part[row] = far_row[row] = std::numeric_limits<float>::infinity();
    }
  }

  /// Columns [first, last) of a row now are at most `depth` away.
  void cover(int row, int first, int last, float depth, int width) {
    if (begin[row] == end[row] || first > end[row] || last < begin[row]) {  // apart from what is known
      if (last - first <= end[row] - begin[row]) return;
      begin[row] = static_cast<std::int16_t>(first);
      end[row] = static_cast<std::int16_t>(last);
      far_part[row] = depth;
    } else {
      far_part[row] = std::max(far_part[row], depth);
      begin[row] = static_cast<std::int16_t>(std::min<int>(begin[row], first));
      end[row] = static_cast<std::int16_t>(std::max<int>(end[row], last));
    }
    if (begin[row] > 0 || end[row] < width) return;
    far_row[row] = std::min(far_row[row], far_part[row]);
    begin[row] = end[row] = 0;  // gather anew, for something nearer
  }

  float far_tile(int height) const { return *std::max_element(far_row, far_row + height); }
};

class VisibilityPass {
 public:
  VisibilityPass(TileWorkspace& workspace, const TileArea& tile) : workspace_(workspace), tile_(tile) {}

  /// The triangle's spans in the tile, and what sorting needs. The order of these calls is the drawing order.
  void add(const BinnedChunk& binned, const PrimitiveRecord& p, const ScissorBox& scissor) {
    const PrimitiveChunk& chunk = binned.chunk();
    TriangleSpans spans;
    if (!triangle_spans(p, tile_, spans)) return;
    TilePrimitive& primitive = workspace_.primitives.emplace_back();
    keep_spans(spans, primitive);
    primitive.chunk = &binned;
    primitive.record = &p;
    primitive.row_begin = std::max(spans.row_begin, scissor.y_begin);
    primitive.row_end = std::min(spans.row_end, scissor.y_end);
    primitive.scissor_begin = static_cast<std::uint8_t>(scissor.x_begin);
    primitive.scissor_end = static_cast<std::uint8_t>(scissor.x_end);
    primitive.first_run = -1;
    const int stride = record_stride(chunk.state->varyings.count);
    primitive.depth =
        triangle_depth_plane(triangle_frame(p), chunk.record(p.vertex[0], stride)[kRecordDepth],
                             chunk.record(p.vertex[1], stride)[kRecordDepth],
                             chunk.record(p.vertex[2], stride)[kRecordDepth], chunk.state->polygon_offset);
  }

  /// Depth and marks of all triangles added.
  void resolve() {
    const std::size_t count = workspace_.primitives.size();
    const DepthTest test = count <= kMostSorted ? common_test() : DepthTest::any;
    if (test == DepthTest::less) {
      draw_sorted<DepthTest::less>();
    } else if (test == DepthTest::less_equal) {
      draw_sorted<DepthTest::less_equal>();
    } else {
      for (std::size_t i = 0; i < count; ++i) draw_in_order(i);
    }
  }

 private:
  /// Columns as bytes, and counts: rows without pixels have equal ends.
  void keep_spans(const TriangleSpans& spans, TilePrimitive& primitive) {
    const hn::ScalableTag<std::int32_t> di;
    const hn::Rebind<std::uint8_t, decltype(di)> d8;
    const int lanes = static_cast<int>(hn::Lanes(di));
    auto covered = hn::Zero(di);
    std::size_t rows = 0;
    for (int row = spans.row_begin; row < spans.row_end; row += lanes) {
      const auto first = hn::LoadU(di, spans.first + row);
      const auto end = hn::Max(hn::LoadU(di, spans.end + row), first);
      hn::StoreU(hn::DemoteTo(d8, first), d8, primitive.first + row);
      hn::StoreU(hn::DemoteTo(d8, end), d8, primitive.end + row);
      const auto length = hn::IfThenElseZero(lanes_below(di, spans.row_end - row), hn::Sub(end, first));
      covered = hn::Add(covered, length);
      rows += hn::CountTrue(di, hn::Gt(length, hn::Zero(di)));
    }
    workspace_.statistics.spans += rows;
    workspace_.statistics.fragments_covered +=
        static_cast<std::uint64_t>(hn::GetLane(hn::SumOfLanes(di, covered)));
  }

  struct Near {
    float depth;
    std::uint32_t primitive;
  };

  /// The depth test of all triangles; `any` when there is no such test.
  DepthTest common_test() const {
    const DepthTest first = workspace_.primitives.front().chunk->key().depth;
    for (const TilePrimitive& primitive : workspace_.primitives) {
      if (primitive.chunk->key().depth != first) return DepthTest::any;
    }
    return first;
  }

  /// No depth of the triangle in the tile is below this: the plane's least value over the tile, less far more
  /// than what rounding to float can take away (four roundings of half a unit in the last place, 2⁻²⁴).
  float nearest(const TilePrimitive& primitive) const {
    const DepthPlane& z = primitive.depth;
    // Samples may lie beside their pixels.
    const double half_width = 0.5 * tile_.width + beside(tile_.sample.x);
    const double half_height = 0.5 * (primitive.row_end - primitive.row_begin) + beside(tile_.sample.y);
    const double center = (z.base + z.ddx * (tile_.x + 0.5 * tile_.width - z.x0)) +
                          z.ddy * (tile_.y + 0.5 * (primitive.row_begin + primitive.row_end) - z.y0);
    const double reach = std::fabs(z.ddx) * half_width + std::fabs(z.ddy) * half_height;
    const double rounding = 0x1p-20 * (std::fabs(center) + 4 * reach);
    return static_cast<float>(std::max(0.0, center - reach - rounding));
  }

  static double beside(int sample) {
    return std::max(0, std::abs(sample - kSubpixelUnits / 2) - kSubpixelUnits / 2) * (1.0 / kSubpixelUnits);
  }

  /// In drawing order, with each triangle's own depth test.
  void draw_in_order(std::size_t number) {
    const TilePrimitive& primitive = workspace_.primitives[number];
    const KernelKey& key = primitive.chunk->key();
    const AnyDepth any(primitive.chunk->chunk().state->depth, key);
    const hn::ScalableTag<std::uint32_t> du;
    for_each_row(primitive, [&](int row, int begin, int end, const SpanDepth& depth) HWY_ATTR {
      const auto mark = hn::Set(du, span_mark(number, row));
      std::uint32_t* marks = workspace_.surface.visible_span + row * kTileWidth;
      const int start = first_vector(begin, end, static_cast<int>(hn::Lanes(du)));
      test_depth(key, any, workspace_.surface.depth + row * kTileWidth, depth, start, begin, end,
                 [&](int x, auto mask, auto)
                     HWY_ATTR { hn::BlendedStore(mark, hn::RebindMask(du, mask), du, marks + x); });
    });
  }

  template <class Visit>
  HWY_INLINE void for_each_row(const TilePrimitive& primitive, Visit&& visit) const {
    const auto slope = static_cast<float>(primitive.depth.ddx);
    for (int row = primitive.row_begin; row < primitive.row_end; ++row) {
      const int first = primitive.first[row];
      const int begin = std::max<int>(first, primitive.scissor_begin);
      const int end = std::min<int>(primitive.end[row], primitive.scissor_end);
      if (begin >= end) continue;
      visit(row, begin, end,
            SpanDepth{primitive.depth.at(tile_.pixel_x(first), tile_.pixel_y(row)), slope, first});
    }
  }

  /// Nearest first. Of equal depths `less` keeps the triangle drawn first, `less_equal` the one drawn last.
  template <DepthTest kTest>
  void draw_sorted() {
    Near order[kMostSorted];
    const std::size_t count = workspace_.primitives.size();
    for (std::size_t i = 0; i < count; ++i) {
      order[i] = {nearest(workspace_.primitives[i]), static_cast<std::uint32_t>(i)};
    }
    std::sort(order, order + count, [](const Near& a, const Near& b) {
      return a.depth != b.depth ? a.depth < b.depth : a.primitive < b.primitive;
    });
    CoveredRows covered;
    float far_tile = covered.far_tile(tile_.height);
    for (std::size_t i = 0; i < count; ++i) {
      if (order[i].depth > far_tile) return;  // and so are all that follow
      const std::size_t number = order[i].primitive;
      for_each_row(workspace_.primitives[number],
                   [&](int row, int begin, int end, const SpanDepth& depth) HWY_ATTR {
                     draw_row<kTest>(covered, span_mark(number, row), row, begin, end, depth);
                   });
      far_tile = covered.far_tile(tile_.height);
    }
  }

  template <DepthTest kTest>
  HWY_INLINE void draw_row(CoveredRows& covered, std::uint32_t mark, int row, int begin, int end,
                           const SpanDepth& depth) {
    const auto at = [&depth](int x) { return std::min(std::max(depth.at(x), 0.0f), 1.0f); };
    // In floating point, too, a linear function is monotonic: the ends are the extremes.
    const float a = at(begin);
    const float b = at(end - 1);
    if (std::min(a, b) > covered.far_row[row]) return;
    if (within_unit(a, b)) {
      test_row<kTest, false>(mark, row, begin, end, depth);
    } else {
      test_row<kTest, true>(mark, row, begin, end, depth);
    }
    covered.cover(row, begin, end, std::max(a, b), tile_.width);
  }

  template <DepthTest kTest, bool kClamp>
  HWY_INLINE void test_row(std::uint32_t mark_value, int row, int begin, int end, const SpanDepth& depth) {
    const hn::ScalableTag<float> d;
    const hn::ScalableTag<std::uint32_t> du;
    const int lanes = static_cast<int>(hn::Lanes(d));
    float* depths = workspace_.surface.depth + row * kTileWidth;
    std::uint32_t* marks = workspace_.surface.visible_span + row * kTileWidth;
    const auto mark = hn::Set(du, mark_value);
    const auto start = hn::Set(d, depth.row);
    const auto slope = hn::Set(d, depth.slope);
    int x = first_vector(begin, end, lanes);
    auto column = lanes_from(d, static_cast<float>(x - depth.anchor));
    for (; x < end; x += lanes) {
      auto z = hn::Add(start, hn::Mul(slope, column));
      if constexpr (kClamp) z = clamp01(z);
      const auto stored = hn::LoadU(d, depths + x);
      auto nearer = is_nearer(z, stored);
      const auto equal = hn::Eq(z, stored);
      if (HWY_UNLIKELY(!hn::AllFalse(d, equal))) {
        const auto seen = hn::LoadU(du, marks + x);
        const auto wins = kTest == DepthTest::less ? hn::Lt(mark, seen) : hn::Lt(seen, mark);
        nearer = hn::Or(nearer, hn::And(equal, hn::RebindMask(d, wins)));
      }
      const auto mask = hn::And(nearer, columns_mask(d, x, begin, end));
      hn::BlendedStore(z, mask, d, depths + x);
      hn::BlendedStore(mark, hn::RebindMask(du, mask), du, marks + x);
      column = hn::Add(column, hn::Set(d, static_cast<float>(lanes)));  // small integers: exact
    }
  }

  TileWorkspace& workspace_;
  const TileArea tile_;
};

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
