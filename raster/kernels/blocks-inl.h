// Small triangles, a block of four columns by as many rows as fill a vector at a time: where spans would
// leave most lanes idle. The same edges, anchors and planes as the spans have, so the same bits. Enters: a
// triangle whose pixels in the tile lie in a small box, and simple opaque colours. Leaves: pixels and depth.
#if defined(BARRIDO_BLOCKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_BLOCKS_INL_H
#undef BARRIDO_BLOCKS_INL_H
#else
#define BARRIDO_BLOCKS_INL_H
#endif

#include <hwy/highway.h>

#include "raster/kernels/blend-inl.h"
#include "raster/kernels/depth-inl.h"
#include "raster/kernels/interpolate-inl.h"
#include "raster/kernels/spans-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

inline constexpr int kBlockColumns = 4;
inline constexpr int kMostBlockColumns = 40;  ///< Of a triangle's box in the tile.

/// Lane i of a block is column i % 4 of row i / 4.
struct BlockLanes {
  alignas(64) static constexpr std::int32_t kColumn[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
  alignas(64) static constexpr std::int32_t kRow[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
};

/// Colours of a triangle: one, or the four quantities from `color` on, divided by q when `divides`.
struct BlockPaint {
  const Planes& planes;
  const float* flat;  ///< Null: interpolated.
  int color;
  bool divides;
};

/// Draws the small triangles of one chunk in one tile.
class TriangleBlocks {
 public:
  using D = hn::ScalableTag<float>;
  using I = hn::RebindToSigned<D>;
  using VecI = hn::Vec<I>;
  static constexpr int kRows = static_cast<int>(hn::MaxLanes(D())) / kBlockColumns;
  using RowsD = hn::FixedTag<double, kRows>;
  /// Lane of column 0 of row i, for the rows that there are.
  static constexpr int kLanes = kRows * kBlockColumns;
  alignas(64) static constexpr std::int32_t kFirstOfRow[16] = {0, 4 % kLanes, 8 % kLanes, 12 % kLanes};

  struct Counts {
    unsigned spans = 0, covered = 0, shaded = 0;
  };

  TriangleBlocks(TileSurface& surface, const TileArea& tile, const ScissorBox& scissor,
                 const DepthState& state)
      : surface_(surface), tile_(tile), scissor_(scissor), rule_(state, state.write) {
    is_cut_ = cuts(scissor, tile);
    is_usual_ = state.test && state.write && state.compare == Compare::less;
  }

  /// Draws a triangle whose box is `box`. `paint` is called for its BlockPaint when the first pixel is found.
  template <class Paint>
  HWY_INLINE Counts draw(const PrimitiveRecord& p, bool clockwise, const TriangleBox& box, Paint&& paint) {
    counts_ = {};
    set_edges(p, clockwise, box);
    for (int row = box.row_begin; row < box.row_end; row += kRows) {
      if (!find_pixels(box, row)) continue;
      const BlockPaint& colors = paint();
      if (is_usual_) {
        draw_rows<true>(box, row, colors);
      } else {
        draw_rows<false>(box, row, colors);
      }
    }
    return counts_;
  }

 private:
  void set_edges(const PrimitiveRecord& p, bool clockwise, const TriangleBox& box) {
    const I di;
    const int second = clockwise ? 2 : 1;
    const int third = 3 - second;
    const std::int32_t center_x = (tile_.x + box.column_begin) * kSubpixelUnits + kSubpixelUnits / 2;
    const std::int32_t center_y = (tile_.y + box.row_begin) * kSubpixelUnits + kSubpixelUnits / 2;
    const int corner[4] = {0, second, third, 0};
    for (int e = 0; e < 3; ++e) {
      const int a = corner[e];
      const int b = corner[e + 1];
      edge_[e] = edge_function(p.x[a], p.y[a], p.x[b], p.y[b], center_x, center_y);
      const auto along_x = hn::Mul(hn::Load(di, BlockLanes::kColumn), hn::Set(di, edge_[e].step_x));
      const auto along_y = hn::Mul(hn::Load(di, BlockLanes::kRow), hn::Set(di, edge_[e].step_y));
      start_[e] = hn::Add(hn::Add(along_x, along_y), hn::Set(di, edge_[e].value));
    }
  }

  /// The pixels of the rows from `row` on, as a mask a block, and the first column of each row; steps down.
  HWY_INLINE bool find_pixels(const TriangleBox& box, int row) {
    const I di;
    const auto in_rows = hn::Lt(hn::Load(di, BlockLanes::kRow), hn::Set(di, box.row_end - row));
    const auto column = hn::Load(di, BlockLanes::kColumn);
    auto v0 = start_[0];
    auto v1 = start_[1];
    auto v2 = start_[2];
    auto first = hn::Set(di, kTileWidth);
    auto columns = hn::Add(column, hn::Set(di, box.column_begin));
    const auto end = hn::Set(di, box.column_end);
    bool any = false;
    for (int x = box.column_begin, block = 0; x < box.column_end; x += kBlockColumns, ++block) {
      const auto inside = hn::Gt(hn::Or(hn::Or(v0, v1), v2), hn::Set(di, -1));
      const auto in_box = hn::And(in_rows, hn::Lt(columns, end));
      const auto mask = hn::And(inside, in_box);
      mask_[block] = mask;
      const auto number = static_cast<unsigned>(hn::CountTrue(di, mask));
      counts_.covered += number;
      any |= number != 0;
      first = hn::Min(first, hn::IfThenElse(mask, columns, hn::Set(di, kTileWidth)));
      columns = hn::Add(columns, hn::Set(di, kBlockColumns));
      v0 = hn::Add(v0, hn::Set(di, kBlockColumns * edge_[0].step_x));
      v1 = hn::Add(v1, hn::Set(di, kBlockColumns * edge_[1].step_x));
      v2 = hn::Add(v2, hn::Set(di, kBlockColumns * edge_[2].step_x));
    }
    for (int e = 0; e < 3; ++e) start_[e] = hn::Add(start_[e], hn::Set(di, kRows * edge_[e].step_y));
    if (!any) return false;
    first = hn::Min(first, hn::Shuffle2301(first));
    first_ = hn::Min(first, hn::Shuffle1032(first));
    const auto is_span = hn::And(hn::Lt(first_, hn::Set(di, kTileWidth)), hn::Eq(column, hn::Zero(di)));
    counts_.spans += static_cast<unsigned>(hn::CountTrue(di, is_span));
    return true;
  }

  /// Where the rows' anchors are, from the planes' reference point.
  struct RowCenters {
    hn::Vec<RowsD> dx, dy;
  };
  HWY_INLINE RowCenters row_centers(int row, const Planes& planes) const {
    const I di;
    const RowsD dd;
    const hn::Rebind<std::int32_t, RowsD> dr;
    const auto to_rows = hn::SetTableIndices(di, kFirstOfRow);
    const auto anchors = hn::LowerHalf(hn::LowerHalf(hn::TableLookupLanes(first_, to_rows)));
    const auto x = hn::PromoteTo(dd, hn::Add(anchors, hn::Set(dr, tile_.x)));
    const auto y = barrido::HWY_NAMESPACE::lanes_from(dd, static_cast<double>(tile_.y + row));
    const auto half = hn::Set(dd, 0.5);
    return {hn::Sub(hn::Add(x, half), hn::Set(dd, planes.x0)),
            hn::Sub(hn::Add(y, half), hn::Set(dd, planes.y0))};
  }

  /// A quantity at the anchors of the rows, in all lanes of each row.
  HWY_INLINE V at_anchors(const Planes& planes, const RowCenters& c, int quantity) const {
    const D d;
    const RowsD dd;
    const hn::Rebind<float, RowsD> df;
    const auto along_x =
        hn::Add(hn::Set(dd, planes.base[quantity]), hn::Mul(hn::Set(dd, planes.ddx[quantity]), c.dx));
    const auto value = hn::Add(along_x, hn::Mul(hn::Set(dd, planes.ddy[quantity]), c.dy));
    alignas(16) float rows[4];
    hn::StoreU(hn::DemoteTo(df, value), df, rows);
    return hn::TableLookupLanes(hn::LoadDup128(d, rows), hn::SetTableIndices(d, BlockLanes::kRow));
  }

  /// Colours and q at the anchors.
  struct RowValues {
    V q;
    Rgba color;
  };
  HWY_INLINE void start_colors(const BlockPaint& paint, const RowCenters& centers, RowValues& values) const {
    for (int c = 0; c < 4; ++c) {
      values.color.c[c] = paint.flat != nullptr ? hn::Set(D(), paint.flat[c])
                                                : at_anchors(paint.planes, centers, paint.color + c);
    }
    if (paint.divides) values.q = at_anchors(paint.planes, centers, kRecordQ);
  }
  HWY_INLINE Rgba colors(const BlockPaint& paint, const RowValues& values, V k) const {
    if (paint.flat != nullptr) return values.color;
    const D d;
    const float* slope = paint.planes.slope_x;
    Rgba rgba;
    for (int c = 0; c < 4; ++c) {
      rgba.c[c] = hn::Add(values.color.c[c], hn::Mul(hn::Set(d, slope[paint.color + c]), k));
    }
    if (!paint.divides) return rgba;
    const V q = hn::Add(values.q, hn::Mul(hn::Set(d, slope[kRecordQ]), k));
    const V w = hn::Div(one(), barrido::HWY_NAMESPACE::maximum(q, hn::Set(d, kSmallestQ)));
    for (V& c : rgba.c) c = hn::Mul(c, w);
    return rgba;
  }

  /// What the scissor leaves of a block, by its first column.
  HWY_INLINE auto scissor_mask(int row) const {
    const I di;
    const auto rows = hn::Add(hn::Load(di, BlockLanes::kRow), hn::Set(di, row));
    const auto in_rows =
        hn::And(hn::Gt(rows, hn::Set(di, scissor_.y_begin - 1)), hn::Lt(rows, hn::Set(di, scissor_.y_end)));
    return [in_rows, this](int x) HWY_ATTR {
      const auto columns = hn::Add(hn::Load(I(), BlockLanes::kColumn), hn::Set(I(), x));
      return hn::And(in_rows, hn::And(hn::Gt(columns, hn::Set(I(), scissor_.x_begin - 1)),
                                      hn::Lt(columns, hn::Set(I(), scissor_.x_end))));
    };
  }

  template <bool kUsual>
  HWY_INLINE void draw_rows(const TriangleBox& box, int row, const BlockPaint& paint) {
    const Planes& planes = paint.planes;
    const D d;
    const I di;
    const RowCenters centers = row_centers(row, planes);
    const V z_row = at_anchors(planes, centers, kRecordDepth);
    const V z_slope = hn::Set(d, planes.slope_x[kRecordDepth]);
    const auto in_scissor = scissor_mask(row);
    const auto column = hn::Load(di, BlockLanes::kColumn);
    bool is_ready = false;
    RowValues row_values;
    // Columns from the rows' anchors on; small integers, so that steps are exact.
    V next = hn::ConvertTo(d, hn::Sub(hn::Add(column, hn::Set(di, box.column_begin)), first_));
    for (int x = box.column_begin, block = 0; x < box.column_end; x += kBlockColumns, ++block) {
      const V k = next;
      next = hn::Add(next, hn::Set(d, static_cast<float>(kBlockColumns)));
      auto mask = hn::RebindMask(d, is_cut_ ? hn::And(mask_[block], in_scissor(x)) : mask_[block]);
      if (hn::AllFalse(d, mask)) continue;
      V z = hn::Add(z_row, hn::Mul(z_slope, k));
      z = barrido::HWY_NAMESPACE::minimum(barrido::HWY_NAMESPACE::maximum(z, hn::Zero(d)), one());
      float* depths = surface_.depth + row * kTileWidth + x;
      const V stored = load_block(d, depths);
      if constexpr (kUsual) {
        mask = hn::And(mask, hn::Lt(z, stored));
        if (hn::AllFalse(d, mask)) continue;
        store_block(d, z, mask, depths);
      } else {
        mask = hn::And(mask, rule_(z, stored));
        if (hn::AllFalse(d, mask)) continue;
        store_block(d, z, hn::And(mask, rule_.write), depths);
      }
      counts_.shaded += static_cast<unsigned>(hn::CountTrue(d, mask));
      if (!is_ready) start_colors(paint, centers, row_values);
      is_ready = true;
      const Rgba rgba = colors(paint, row_values, k);
      auto* pixels = reinterpret_cast<std::int32_t*>(surface_.color8) + row * kTileWidth + x;
      store_block(di, pack8(rgba), hn::RebindMask(di, mask), pixels);
    }
  }

  /// kRows pieces of four, one below the other in the tile.
  template <class Tag, class T>
  static HWY_INLINE hn::Vec<Tag> load_block(Tag d, const T* from) {
    const hn::FixedTag<T, 4> d4;
    if constexpr (kRows == 1) {
      return hn::LoadU(d, from);
    } else if constexpr (kRows == 2) {
      return hn::Combine(d, hn::LoadU(d4, from + kTileWidth), hn::LoadU(d4, from));
    } else {
      const hn::FixedTag<T, 8> d8;
      return hn::Combine(
          d, hn::Combine(d8, hn::LoadU(d4, from + 3 * kTileWidth), hn::LoadU(d4, from + 2 * kTileWidth)),
          hn::Combine(d8, hn::LoadU(d4, from + kTileWidth), hn::LoadU(d4, from)));
    }
  }

  template <class Tag, class T>
  static HWY_INLINE void store_block(Tag d, hn::Vec<Tag> v, hn::Mask<Tag> mask, T* to) {
    const hn::FixedTag<T, 4> d4;
    if constexpr (kRows == 1) {
      hn::BlendedStore(v, mask, d, to);
    } else {
      // Rows outside the mask keep what they have: blended here, so that whole rows can be stored.
      const auto blended = hn::IfThenElse(mask, v, load_block(d, to));
      if constexpr (kRows == 2) {
        hn::StoreU(hn::LowerHalf(blended), d4, to);
        hn::StoreU(hn::UpperHalf(d4, blended), d4, to + kTileWidth);
      } else {
        const hn::FixedTag<T, 8> d8;
        const auto low = hn::LowerHalf(blended);
        const auto high = hn::UpperHalf(d8, blended);
        hn::StoreU(hn::LowerHalf(low), d4, to);
        hn::StoreU(hn::UpperHalf(d4, low), d4, to + kTileWidth);
        hn::StoreU(hn::LowerHalf(high), d4, to + 2 * kTileWidth);
        hn::StoreU(hn::UpperHalf(d4, high), d4, to + 3 * kTileWidth);
      }
    }
  }

  TileSurface& surface_;
  const TileArea tile_;
  const ScissorBox scissor_;
  const DepthRule rule_;
  bool is_usual_;
  bool is_cut_;  ///< By the scissor.
  EdgeFunction edge_[3];
  VecI start_[3];  ///< Edge functions at the first block of the next rows.
  VecI first_;     ///< First column of each row, kTileWidth where there is none.
  hn::Mask<I> mask_[kMostBlockColumns / kBlockColumns];
  Counts counts_;
};

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
