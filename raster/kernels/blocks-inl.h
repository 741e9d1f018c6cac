// Small triangles, a block of eight columns by as many rows as fill a vector at a time: where spans would
// leave most lanes idle. The same spans, anchors and planes as everywhere, so the same bits. Enters: the
// spans of a triangle and simple opaque colours. Leaves: pixels and depth.
//
// Rows are prepared eight at a time (ends, anchors, first values), then blocks of 8 × 2 pixels walk along
// each pair of rows. Half of their lanes hold pixels of a triangle of some dozens: about 35 cycles a block,
// five blocks a triangle. Milliseconds below are a frame of W8 (docs/performance.md). Rejected:
// - Spans for all, as for large triangles: 14.6; the first blocks, of 4 × 4, took 13.
// - Blocks of 4 × 4 whose rows are prepared one by one, clamped and with alpha always: 10.4, for 8.2 now
// (spans
//   by products with reciprocals among it).
// - One loop over all blocks of a triangle in place of loops over its rows: 3 % slower.
// - Not asking whether a block's mask is empty: no faster.
// - A vector loaded across row values that were just stored in pieces: it waits for the stores; broadcasts of
//   single numbers do not, which is 5 %.
// - Blocks for triangles of any width: above kMostBlockColumns columns rows fill the vectors anyway.
#if defined(BARRIDO_BLOCKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_BLOCKS_INL_H
#undef BARRIDO_BLOCKS_INL_H
#else
#define BARRIDO_BLOCKS_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "raster/kernels/blend-inl.h"
#include "raster/kernels/depth-inl.h"
#include "raster/kernels/interpolate-inl.h"
#include "raster/kernels/spans-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

inline constexpr int kMostBlockColumns = 40;  ///< Of a triangle's box in the tile.

/// Colours of a triangle: one, or the four quantities from `color` on, divided by q when `divides`.
struct BlockPaint {
  const Planes& planes;
  const float* flat;  ///< Null: interpolated.
  int color;
  bool divides;
  bool is_plain;  ///< See has_plain_depth() and, unless flat, has_plain_colors().
};

/// Whether depths between three vertex records need no clamping: rounding moves them by less than 2^-20.
inline bool has_plain_depth(const float* r0, const float* r1, const float* r2) {
  const auto is_inside = [](float z) { return z >= 0x1p-20f && z <= 1.0f - 0x1p-20f; };
  return is_inside(r0[kRecordDepth]) && is_inside(r1[kRecordDepth]) && is_inside(r2[kRecordDepth]);
}

/// Whether colours between three vertex records, which are to be divided by q or have q 1, need neither
/// clamping nor an alpha of their own: q alike, all from 0 to 1, alpha 1. Rounding then moves a colour by
/// less than 2^-20, which changes no 8-bit colour, and alpha, whose plane is that of q, is as near to 1.
inline bool has_plain_colors(const float* r0, const float* r1, const float* r2, int color) {
  const hn::FixedTag<float, 4> d;
  const float least_q = std::min(std::min(r0[kRecordQ], r1[kRecordQ]), r2[kRecordQ]);
  const float most_q = std::max(std::max(r0[kRecordQ], r1[kRecordQ]), r2[kRecordQ]);
  alignas(16) static constexpr float kOpaque[4] = {0.0f, 0.0f, 0.0f, 1.0f};
  const auto in_range = [&](const float* r) HWY_ATTR {
    const auto c = hn::LoadU(d, r + color);
    const auto q = hn::Set(d, r[kRecordQ]);
    return hn::And(hn::Ge(c, hn::Mul(q, hn::Load(d, kOpaque))), hn::Le(c, q));
  };
  return least_q >= 0x1p-60f && most_q <= 2 * least_q &&
         hn::AllTrue(d, hn::And(hn::And(in_range(r0), in_range(r1)), in_range(r2)));
}

/// Draws the small triangles of one chunk in one tile.
class TriangleBlocks {
 public:
  using D = hn::ScalableTag<float>;
  using I = hn::RebindToSigned<D>;
  static constexpr int kLanes = static_cast<int>(hn::MaxLanes(D()));
  static constexpr int kColumns = kLanes < 8 ? kLanes : 8;
  static constexpr int kRows = kLanes / kColumns;  ///< One or two.

  TriangleBlocks(TileSurface& surface, const TileArea& tile, const ScissorBox& scissor, const KernelKey& key,
                 const AnyDepth& any_depth)
      : surface_(surface),
        tile_(tile),
        scissor_(scissor),
        is_cut_(cuts(scissor, tile)),
        is_usual_(key.depth == DepthTest::less),
        any_depth_(any_depth),
        covered_(hn::Zero(GroupI())) {}

  /// Draws the triangle that has these spans.
  HWY_INLINE void draw(const TriangleSpans& spans, const BlockPaint& paint) {
    for (int row = spans.row_begin; row < spans.row_end; row += kGroupRows) {
      take_rows(spans, row);
      find_anchors(paint, row);
      draw_colored(row, paint);
    }
  }

  /// Of all triangles so far.
  LoopCounts counts() const {
    return {spans_, static_cast<std::uint64_t>(hn::GetLane(hn::SumOfLanes(GroupI(), covered_))), shaded_};
  }

 private:
  static constexpr int kGroupRows = 8;  ///< Rows that are prepared at once.
  using GroupI = hn::CappedTag<std::int32_t, kGroupRows>;
  using GroupD = hn::CappedTag<double, kGroupRows>;
  using Group = float[kGroupRows];  ///< A number for each row.

  /// What is to be drawn of a group's rows, and where they are anchored.
  HWY_INLINE void take_rows(const TriangleSpans& spans, int row) {
    const GroupI di;
    const hn::Rebind<float, GroupI> d;
    for (int i = 0; i < kGroupRows; i += static_cast<int>(hn::Lanes(di))) {
      const auto r = lanes_from(di, row + i);
      const auto first = hn::LoadU(di, spans.first + row + i);
      const auto end = hn::LoadU(di, spans.end + row + i);
      auto is_drawn = hn::And(hn::Lt(first, end), hn::Lt(r, hn::Set(di, spans.row_end)));
      covered_ = hn::Add(covered_, hn::IfThenElseZero(is_drawn, hn::Sub(end, first)));
      spans_ += hn::CountTrue(di, is_drawn);
      auto begin = first;
      auto limit = end;
      if (HWY_UNLIKELY(is_cut_)) {
        begin = hn::Max(first, hn::Set(di, scissor_.x_begin));
        limit = hn::Min(end, hn::Set(di, scissor_.x_end));
        is_drawn = hn::And(is_drawn, hn::And(hn::Gt(r, hn::Set(di, scissor_.y_begin - 1)),
                                             hn::Lt(r, hn::Set(di, scissor_.y_end))));
      }
      begin = hn::IfThenElse(is_drawn, begin, hn::Set(di, kTileWidth));
      limit = hn::IfThenElseZero(is_drawn, limit);
      hn::Store(first, di, first_ + i);
      hn::Store(begin, di, begin_ + i);
      hn::Store(limit, di, end_ + i);
      hn::Store(hn::ConvertTo(d, first), d, anchor_ + i);
      hn::Store(hn::ConvertTo(d, limit), d, to_ + i);
    }
  }

  /// The anchors from the planes' reference point, and what there is of the quantities there.
  HWY_INLINE void find_anchors(const BlockPaint& paint, int row) {
    const GroupD d;
    const hn::Rebind<std::int32_t, GroupD> di;
    // Multiples of 1/256 that are not large: exact in any order.
    const auto to_x = hn::Set(d, tile_.pixel_x(0) - paint.planes.x0);
    const auto to_y = hn::Set(d, tile_.pixel_y(row) - paint.planes.y0);
    for (int i = 0; i < kGroupRows; i += static_cast<int>(hn::Lanes(d))) {
      const auto dx = hn::Add(hn::PromoteTo(d, hn::Load(di, first_ + i)), to_x);
      const auto dy = hn::Add(lanes_from(d, static_cast<double>(i)), to_y);
      const auto find = [&](int quantity, Group& values) HWY_ATTR {
        const hn::Rebind<float, GroupD> df;
        const Planes& p = paint.planes;
        const auto along_x = hn::Add(hn::Set(d, p.base[quantity]), hn::Mul(hn::Set(d, p.ddx[quantity]), dx));
        const auto value = hn::Add(along_x, hn::Mul(hn::Set(d, p.ddy[quantity]), dy));
        hn::Store(hn::DemoteTo(df, value), df, values + i);
      };
      find(kRecordDepth, depth_);
      if (paint.flat != nullptr) continue;
      for (int c = 0; c < (takes_plain_way(paint) ? 3 : 4); ++c) find(paint.color + c, color_[c]);
      if (paint.divides) find(kRecordQ, q_);
    }
  }

  /// The values of kRows rows from row i of the group on, in all columns of each. Broadcasts of single
  /// numbers: a vector across what has just been stored in pieces would wait for it.
  static HWY_INLINE V in_rows(const Group& values, int i) {
    const D d;
    const auto lower = hn::Set(d, values[i]);
    if constexpr (kRows == 1) return lower;
    return hn::IfThenElse(hn::MaskFromVec(hn::BitCast(d, hn::Load(I(), kUpperRow))),
                          hn::Set(d, values[i + kRows - 1]), lower);
  }

  bool takes_plain_way(const BlockPaint& paint) const { return is_usual_ && paint.is_plain; }

  HWY_INLINE void draw_colored(int row, const BlockPaint& paint) {
    const bool plain = takes_plain_way(paint);
    if (paint.flat != nullptr) {
      const OneColor color{pack8(one_color(paint.flat))};
      plain ? draw_group(UsualDepth(), row, paint, color) : draw_group(any_depth_, row, paint, color);
    } else if (!plain) {
      draw_group(any_depth_, row, paint, AnyColors{*this, paint});
    } else if (paint.divides) {
      draw_group(UsualDepth(), row, paint, PlainColors<true>{*this, paint});
    } else {
      draw_group(UsualDepth(), row, paint, PlainColors<false>{*this, paint});
    }
  }

  template <class Rule, class Colors>
  HWY_INLINE void draw_group(const Rule& rule, int row, const BlockPaint& paint, const Colors& colors) {
    for (int i = 0; i < kGroupRows; i += kRows) {
      const int end = std::max(end_[i], end_[i + kRows - 1]);
      for (int x = std::min(begin_[i], begin_[i + kRows - 1]); x < end; x += kColumns) {
        draw_block(rule, row, i, x, paint, colors);
      }
    }
  }

  template <class Rule, class Colors>
  HWY_INLINE void draw_block(const Rule& rule, int group, int i, int x, const BlockPaint& paint,
                             const Colors& colors) {
    const D d;
    const I di;
    const int at = (group + i) * kTileWidth + x;
    const V column = hn::Add(hn::Load(d, kColumnOf), hn::Set(d, static_cast<float>(x)));
    const V k = hn::Sub(column, in_rows(anchor_, i));  // columns from the anchor on
    // No column is before what is drawn of its row: that begins at the anchor or, with the blocks, at the
    // scissor's edge.
    auto mask = hn::And(hn::Ge(k, hn::Zero(d)), hn::Lt(column, in_rows(to_, i)));
    const V z = rule.bounded(value(depth_, i, paint, kRecordDepth, k));
    const V stored = load_block(d, surface_.depth + at);
    mask = hn::And(mask, rule.passes(z, stored));
    if (hn::AllFalse(d, mask)) return;
    store_block(d, hn::IfThenElse(rule.written(mask), z, stored), surface_.depth + at);
    shaded_ += hn::CountTrue(d, mask);
    auto* pixels = reinterpret_cast<std::int32_t*>(surface_.color8) + at;
    store_block(di, hn::IfThenElse(hn::RebindMask(di, mask), colors(i, k), load_block(di, pixels)), pixels);
  }

  HWY_INLINE V value(const Group& values, int i, const BlockPaint& paint, int quantity, V k) const {
    return hn::Add(in_rows(values, i), hn::Mul(hn::Set(D(), paint.planes.slope_x[quantity]), k));
  }

  // Packed colours of the block in row i of the group whose pixels are `k` columns from the anchors.

  struct OneColor {
    HWY_INLINE hn::Vec<I> operator()(int, V) const { return packed; }
    hn::Vec<I> packed;
  };

  struct AnyColors {
    const TriangleBlocks& blocks;
    const BlockPaint& paint;
    HWY_INLINE hn::Vec<I> operator()(int i, V k) const {
      Rgba rgba;
      for (int c = 0; c < 4; ++c) rgba.c[c] = blocks.value(blocks.color_[c], i, paint, paint.color + c, k);
      if (paint.divides) {
        const V w = inverse_q(blocks.value(blocks.q_, i, paint, kRecordQ, k));
        for (V& c : rgba.c) c = hn::Mul(c, w);
      }
      return pack8(rgba);
    }
  };

  template <bool kDivides>
  struct PlainColors {
    const TriangleBlocks& blocks;
    const BlockPaint& paint;
    HWY_INLINE hn::Vec<I> operator()(int i, V k) const {
      Rgba rgba;
      for (int c = 0; c < 3; ++c) rgba.c[c] = blocks.value(blocks.color_[c], i, paint, paint.color + c, k);
      if constexpr (kDivides) {
        // has_plain_colors() has seen that q is not small.
        const V w = hn::Div(one(), blocks.value(blocks.q_, i, paint, kRecordQ, k));
        for (int c = 0; c < 3; ++c) rgba.c[c] = hn::Mul(rgba.c[c], w);
      }
      return pack8_unit<true>(rgba);
    }
  };

  /// kRows pieces of kColumns, one below the other in the tile.
  template <class Tag, class T>
  static HWY_INLINE hn::Vec<Tag> load_block(Tag d, const T* from) {
    if constexpr (kRows == 1) {
      return hn::LoadU(d, from);
    } else {
      const hn::FixedTag<T, kColumns> half;
      return hn::Combine(d, hn::LoadU(half, from + kTileWidth), hn::LoadU(half, from));
    }
  }
  template <class Tag, class T>
  static HWY_INLINE void store_block(Tag d, hn::Vec<Tag> v, T* to) {
    if constexpr (kRows == 1) {
      hn::StoreU(v, d, to);
    } else {
      const hn::FixedTag<T, kColumns> half;
      hn::StoreU(hn::LowerHalf(v), half, to);
      hn::StoreU(hn::UpperHalf(half, v), half, to + kTileWidth);
    }
  }

  alignas(64) static constexpr std::int32_t kUpperRow[16] = {0,  0,  0,  0,  0,  0,  0,  0,
                                                             -1, -1, -1, -1, -1, -1, -1, -1};
  alignas(64) static constexpr float kColumnOf[16] = {0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7};

  TileSurface& surface_;
  const TileArea tile_;
  const ScissorBox scissor_;
  const bool is_cut_;  ///< By the scissor.
  const bool is_usual_;
  const AnyDepth any_depth_;
  hn::Vec<GroupI> covered_;  ///< Pixels, counted in each lane.
  std::uint64_t spans_ = 0, shaded_ = 0;
  // Of the rows of a group:
  alignas(64) std::int32_t first_[kGroupRows];
  alignas(
      64) std::int32_t begin_[kGroupRows];  ///< Columns to draw, from kTileWidth to 0 where there are none.
  alignas(64) std::int32_t end_[kGroupRows];
  alignas(64) Group anchor_, to_;           ///< first_ and end_.
  alignas(64) Group depth_, q_, color_[4];  ///< At the anchors.
};

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
