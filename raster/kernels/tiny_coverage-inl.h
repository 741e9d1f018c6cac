// Which pixels tiny triangles cover: those whose pixels in the tile lie in a square of eight by eight and are
// not many. Found for a vector of triangles at a time, one lane a triangle, by the same edges as in
// spans-inl.h. Enters: triangles and a tile. Leaves: a bit a pixel, and the frame for their planes.
#if defined(BARRIDO_TINY_COVERAGE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_TINY_COVERAGE_INL_H
#undef BARRIDO_TINY_COVERAGE_INL_H
#else
#define BARRIDO_TINY_COVERAGE_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <span>

#include "raster/kernels/planes-inl.h"
#include "raster/kernels/spans-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Columns and rows of a tiny triangle at most.
inline constexpr int kTinySide = 8;
/// Its area in pixels at most: larger ones fill vectors better in blocks.
inline constexpr int kTinyArea = 16;

class TinyCoverage {
 public:
  using I = hn::ScalableTag<std::int32_t>;
  using VecI = hn::Vec<I>;
  static constexpr std::size_t kTriangles = hn::MaxLanes(I());

  explicit TinyCoverage(const TileArea& tile) : tile_(tile) {}

  bool is_tiny(std::size_t i) const { return is_tiny_[i] != 0; }
  /// Bit 8r + c: whether the pixel of column `column(i)` + c and row `row(i)` + r is covered.
  std::uint64_t pixels(std::size_t i) const {
    return lower_[i] | static_cast<std::uint64_t>(upper_[i]) << 32;
  }
  int column(std::size_t i) const { return column_[i]; }
  int row(std::size_t i) const { return row_[i]; }
  TriangleFrame frame(std::size_t i) const {
    return {frame_[0][i], frame_[1][i], frame_[2][i], frame_[3][i], frame_[4][i], frame_[5][i], frame_[6][i]};
  }

  /// Of the first `kTriangles` of `numbers`, or all when there are fewer.
  void find(const PrimitiveChunk& chunk, std::span<const std::uint16_t> numbers) {
    const I di;
    const Corners c = load_corners(chunk, numbers);
    const auto x_min = hn::Min(hn::Min(c.x[0], c.x[1]), c.x[2]);
    const auto x_max = hn::Max(hn::Max(c.x[0], c.x[1]), c.x[2]);
    const auto y_min = hn::Min(hn::Min(c.y[0], c.y[1]), c.y[2]);
    const auto y_max = hn::Max(hn::Max(c.y[0], c.y[1]), c.y[2]);
    const auto zero = hn::Zero(di);
    const auto column = hn::Max(first_centre(x_min, tile_.x, tile_.sample.x), zero);
    const auto row = hn::Max(first_centre(y_min, tile_.y, tile_.sample.y), zero);
    const auto columns =
        hn::Sub(hn::Min(first_centre(x_max, tile_.x, tile_.sample.x), hn::Set(di, tile_.width)), column);
    const auto rows =
        hn::Sub(hn::Min(first_centre(y_max, tile_.y, tile_.sample.y), hn::Set(di, tile_.height)), row);
    const auto area = hn::Sub(hn::Mul(hn::Sub(c.x[1], c.x[0]), hn::Sub(c.y[2], c.y[0])),
                              hn::Mul(hn::Sub(c.x[2], c.x[0]), hn::Sub(c.y[1], c.y[0])));
    const auto is_below = [&](VecI v, int limit) HWY_ATTR { return hn::Lt(v, hn::Set(di, limit)); };
    const auto is_small = hn::And(is_below(hn::Sub(x_max, x_min), kSmallTriangle),
                                  is_below(hn::Sub(y_max, y_min), kSmallTriangle));
    const auto fits = hn::And(is_below(columns, kTinySide + 1), is_below(rows, kTinySide + 1));
    const auto is_tiny = hn::And(hn::And(is_small, fits),
                                 is_below(hn::Abs(area), 2 * kTinyArea * kSubpixelUnits * kSubpixelUnits));
    hn::Store(hn::VecFromMask(di, is_tiny), di, is_tiny_);
    hn::Store(column, di, column_);
    hn::Store(row, di, row_);
    const auto in_tile = [&](VecI length)
                             HWY_ATTR { return hn::IfThenElseZero(is_tiny, hn::Max(length, zero)); };
    find_pixels(c, area, {column, row, in_tile(columns), in_tile(rows)});
    store_frames(c);
  }

 private:
  struct Corners {
    VecI x[3], y[3];
  };
  /// Of the pixels that the bounding boxes hold, relative to the tile.
  struct Boxes {
    VecI column, row, columns, rows;
  };

  static Corners load_corners(const PrimitiveChunk& chunk, std::span<const std::uint16_t> numbers) {
    const I di;
    const hn::Rebind<std::uint16_t, I> d16;
    alignas(64) std::uint16_t last[kTriangles];
    const std::uint16_t* group = numbers.data();
    if (numbers.size() < kTriangles) {  // the rest is as the last one
      for (std::size_t i = 0; i < kTriangles; ++i) last[i] = numbers[std::min(i, numbers.size() - 1)];
      group = last;
    }
    const auto offset = hn::Mul(hn::PromoteTo(di, hn::LoadU(d16, group)),
                                hn::Set(di, static_cast<std::int32_t>(sizeof(PrimitiveRecord))));
    const PrimitiveRecord* records = chunk.primitives.data();
    Corners c;
    for (int i = 0; i < 3; ++i) {
      c.x[i] = hn::GatherOffset(di, records->x + i, offset);
      c.y[i] = hn::GatherOffset(di, records->y + i, offset);
    }
    return c;
  }

  /// See TileArea::first_column_at.
  static HWY_INLINE VecI first_centre(VecI v, int origin, int sample) {
    const auto moved = hn::Add(v, hn::Set(I(), TileArea::kToNextPixel - sample));
    return hn::Sub(hn::ShiftRight<kSubpixelBits>(moved), hn::Set(I(), origin));
  }

  /// The edge functions of counter-clockwise triangles' sides, at least 0 inside: the rule of
  /// docs/arithmetic.md gives left and lower sides their own pixel centres; the others lose one unit. At a
  /// centre, and steps to the next column and row.
  struct Edges {
    VecI value, step_x, step_y;
  };
  static HWY_INLINE Edges edges(VecI ax, VecI ay, VecI bx, VecI by, VecI center_x, VecI center_y) {
    const I di;
    const auto zero = hn::Zero(di);
    const auto dx = hn::Sub(bx, ax);
    const auto dy = hn::Sub(by, ay);
    const auto owns_centres = hn::Or(hn::Lt(dy, zero), hn::And(hn::Eq(dy, zero), hn::Gt(dx, zero)));
    const auto value = hn::Sub(hn::Mul(dx, hn::Sub(center_y, ay)), hn::Mul(dy, hn::Sub(center_x, ax)));
    return {hn::Sub(value, hn::IfThenZeroElse(owns_centres, hn::Set(di, 1))),
            hn::ShiftLeft<kSubpixelBits>(hn::Neg(dy)), hn::ShiftLeft<kSubpixelBits>(dx)};
  }

  HWY_INLINE void find_pixels(const Corners& c, VecI area, const Boxes& boxes) {
    const I di;
    const auto to_center = [&](VecI pixel, int origin, int sample) HWY_ATTR {
      return hn::Add(hn::ShiftLeft<kSubpixelBits>(hn::Add(pixel, hn::Set(di, origin))), hn::Set(di, sample));
    };
    const auto clockwise = hn::Lt(area, hn::Zero(di));
    const auto second_x = hn::IfThenElse(clockwise, c.x[2], c.x[1]);
    const auto second_y = hn::IfThenElse(clockwise, c.y[2], c.y[1]);
    const auto third_x = hn::IfThenElse(clockwise, c.x[1], c.x[2]);
    const auto third_y = hn::IfThenElse(clockwise, c.y[1], c.y[2]);
    const auto center_x = to_center(boxes.column, tile_.x, tile_.sample.x);
    const auto center_y = to_center(boxes.row, tile_.y, tile_.sample.y);
    Edges e[3] = {edges(c.x[0], c.y[0], second_x, second_y, center_x, center_y),
                  edges(second_x, second_y, third_x, third_y, center_x, center_y),
                  edges(third_x, third_y, c.x[0], c.y[0], center_x, center_y)};
    // Triangles without area have no pixels.
    const auto rows_of = hn::IfThenZeroElse(hn::Eq(area, hn::Zero(di)), boxes.rows);
    const int most_columns = hn::GetLane(hn::MaxOfLanes(di, boxes.columns));
    const int most_rows = hn::GetLane(hn::MaxOfLanes(di, rows_of));
    auto lower = hn::Zero(di);
    auto upper = hn::Zero(di);
    for (int r = 0; r < most_rows; ++r) {
      const auto in_row = row_pixels(e, most_columns, boxes.columns);
      const auto here = hn::IfThenElseZero(hn::Lt(hn::Set(di, r), rows_of), in_row);
      if (r < 4) {
        lower = hn::Or(lower, hn::ShiftLeftSame(here, 8 * r));
      } else {
        upper = hn::Or(upper, hn::ShiftLeftSame(here, 8 * (r - 4)));
      }
      for (Edges& edge : e) edge.value = hn::Add(edge.value, edge.step_y);
    }
    const hn::RebindToUnsigned<I> du;
    hn::Store(hn::BitCast(du, lower), du, lower_);
    hn::Store(hn::BitCast(du, upper), du, upper_);
  }

  /// A bit for each covered column of one row of the boxes.
  static HWY_INLINE VecI row_pixels(const Edges (&e)[3], int most_columns, VecI columns) {
    const I di;
    auto v0 = e[0].value;
    auto v1 = e[1].value;
    auto v2 = e[2].value;
    auto bits = hn::Zero(di);
    auto bit = hn::Set(di, 1);
    for (int column = 0; column < most_columns; ++column) {
      const auto inside =
          hn::And(hn::Gt(hn::Or(hn::Or(v0, v1), v2), hn::Set(di, -1)), hn::Lt(hn::Set(di, column), columns));
      bits = hn::Or(bits, hn::IfThenElseZero(inside, bit));
      bit = hn::Add(bit, bit);
      v0 = hn::Add(v0, e[0].step_x);
      v1 = hn::Add(v1, e[1].step_x);
      v2 = hn::Add(v2, e[2].step_x);
    }
    return bits;
  }

  /// See triangle_frame.
  HWY_INLINE void store_frames(const Corners& c) {
    const hn::ScalableTag<double> d;
    const hn::Rebind<std::int32_t, decltype(d)> di;
    alignas(64) std::int32_t x[3][kTriangles];
    alignas(64) std::int32_t y[3][kTriangles];
    for (int i = 0; i < 3; ++i) {
      hn::Store(c.x[i], I(), x[i]);
      hn::Store(c.y[i], I(), y[i]);
    }
    const auto unit = hn::Set(d, 1.0 / kSubpixelUnits);
    for (std::size_t i = 0; i < kTriangles; i += hn::Lanes(d)) {
      const auto pixels = [&](const std::int32_t* v)
                              HWY_ATTR { return hn::Mul(hn::PromoteTo(d, hn::Load(di, v + i)), unit); };
      const auto x0 = pixels(x[0]);
      const auto y0 = pixels(y[0]);
      const auto dx1 = hn::Sub(pixels(x[1]), x0);
      const auto dy1 = hn::Sub(pixels(y[1]), y0);
      const auto dx2 = hn::Sub(pixels(x[2]), x0);
      const auto dy2 = hn::Sub(pixels(y[2]), y0);
      const auto inverse = hn::Div(hn::Set(d, 1.0), hn::Sub(hn::Mul(dx1, dy2), hn::Mul(dx2, dy1)));
      const decltype(inverse) values[7] = {x0, y0, dx1, dy1, dx2, dy2, inverse};
      for (int k = 0; k < 7; ++k) hn::Store(values[k], d, frame_[k] + i);
    }
  }

  const TileArea tile_;
  alignas(64) std::int32_t is_tiny_[kTriangles];
  alignas(64) std::uint32_t lower_[kTriangles];  ///< Rows 0 to 3.
  alignas(64) std::uint32_t upper_[kTriangles];  ///< Rows 4 to 7.
  alignas(64) std::int32_t column_[kTriangles];
  alignas(64) std::int32_t row_[kTriangles];
  alignas(64) double frame_[7][kTriangles];
};

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
