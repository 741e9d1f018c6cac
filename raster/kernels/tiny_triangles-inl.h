// Tiny triangles, of some pixels each, as short lists that are worked off in simple loops: triangles become
// planes, planes spans, spans pixels. The same edges, anchors and planes as spans have, so the same bits.
// Enters: triangles of one chunk with simple opaque colours, in drawing order. Leaves: pixels and depth.
//
// What spans and blocks cost most for such triangles is guessing wrongly where their loops end; here every
// list is long and its loop ends once: about 80 cycles a triangle. Milliseconds below are a frame of W7, a
// million triangles (docs/performance.md). Rejected:
// - Blocks for these, too: 57.5, for 43 with the lists.
// - Pixel by pixel, one triangle after the other: no faster than blocks; loops of one to four rounds end
//   unforeseeably. It is the lists that help, not the scalar pixels.
// - Lists for triangles of up to 16 × 16 pixels, eight pixels of a span at a time: W8 3 % faster, W7 14 %
//   slower.
// Coverage, the first step, is found for a vector of triangles at once: tiny_coverage-inl.h.
#if defined(BARRIDO_TINY_TRIANGLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_TINY_TRIANGLES_INL_H
#undef BARRIDO_TINY_TRIANGLES_INL_H
#else
#define BARRIDO_TINY_TRIANGLES_INL_H
#endif

#include <hwy/highway.h>

#include <cstring>

#include "raster/kernels/blend-inl.h"
#include "raster/kernels/depth-inl.h"
#include "raster/kernels/tiny_coverage-inl.h"
#include "raster/tiles/tile.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// How the triangles of a chunk are coloured.
struct TinyPaint {
  bool is_flat;  ///< One colour a triangle.
  int color;     ///< Else the four quantities from here on,
  bool divides;  ///< divided by q.
};

class TinyTriangles {
 public:
  TinyTriangles(TileSurface& surface, const TileArea& tile) : surface_(surface), tile_(tile) {}

  void begin_chunk(const TinyPaint& paint) { paint_ = paint; }

  bool is_full() const { return triangle_count_ == kTriangles; }

  /// Takes triangle `i` of `coverage`, whose vertex records are r0, r1 and r2. `flat` may be null unless the
  /// chunk is flat.
  void add(const TinyCoverage& coverage, std::size_t i, const float* r0, const float* r1, const float* r2,
           const float* flat) {
    Triangle& t = triangles_[triangle_count_];
    const TriangleFrame frame = coverage.frame(i);
    t.x0 = frame.x0;
    t.y0 = frame.y0;
    t.column = coverage.column(i);
    t.row = coverage.row(i);
    set_up(frame, r0, r1, r2, t);
    if (paint_.is_flat) t.packed = pack_pixel(hn::LoadU(hn::FixedTag<float, 4>(), flat));
    add_rows(coverage.pixels(i));
    ++triangle_count_;
  }

  /// Draws the triangles that were added.
  LoopCounts draw() {
    if (triangle_count_ == 0) return {};
    start_spans();
    const std::size_t shaded = paint_.is_flat   ? draw_flat_pixels()
                               : paint_.divides ? draw_smooth_pixels<true>()
                                                : draw_smooth_pixels<false>();
    const LoopCounts counts{row_count_, pixel_count_, shaded};
    triangle_count_ = row_count_ = pixel_count_ = 0;
    return counts;
  }

 private:
  static constexpr std::size_t kTriangles = 32;
  static constexpr std::size_t kRows = kTriangles * kTinySide;
  static constexpr std::size_t kPixels = kRows * kTinySide;

  struct Triangle {
    alignas(64) double base[kTinyQuantities];
    alignas(64) double ddx[kTinyQuantities];
    alignas(64) double ddy[kTinyQuantities];
    alignas(64) float slope[kTinyQuantities];  ///< Along x.
    double x0, y0;
    std::int32_t column, row;  ///< Of its square.
    std::uint32_t packed;      ///< Its colour, if flat.
  };
  struct Span {
    alignas(32) float values[kTinyQuantities];  ///< At its first pixel.
    const float* slope;
    std::int32_t at;  ///< Of the first pixel in the surface.
    std::uint32_t packed;
  };
  // A row: number of the triangle, row of its square, a bit for each covered column.
  static constexpr int kTriangleShift = 16;
  static constexpr int kRowShift = 8;
  // A pixel: number of the span, column from the span's first on.
  static constexpr int kSpanShift = 8;

  /// As set_up_triangle, for so many quantities and no polygon offset.
  static HWY_INLINE void set_up(const TriangleFrame& f, const float* r0, const float* r1, const float* r2,
                                Triangle& t) {
    const hn::CappedTag<double, kTinyQuantities> d;
    const hn::Rebind<float, decltype(d)> df;
    for (int i = 0; i < kTinyQuantities; i += static_cast<int>(hn::Lanes(d))) {
      const auto plane = plane_of(d, f, r0 + i, r1 + i, r2 + i);
      hn::Store(plane.base, d, t.base + i);
      hn::Store(plane.ddx, d, t.ddx + i);
      hn::Store(plane.ddy, d, t.ddy + i);
      hn::Store(hn::DemoteTo(df, plane.ddx), df, t.slope + i);
    }
  }

  /// Lists the rows that have pixels.
  HWY_INLINE void add_rows(std::uint64_t pixels) {
    const hn::CappedTag<std::uint32_t, kTinySide> d;
    const hn::Rebind<std::uint8_t, decltype(d)> d8;
    alignas(64) static constexpr std::uint32_t kRowNumbers[kTinySide] = {0,
                                                                         1 << kRowShift,
                                                                         2 << kRowShift,
                                                                         3 << kRowShift,
                                                                         4 << kRowShift,
                                                                         5 << kRowShift,
                                                                         6 << kRowShift,
                                                                         7 << kRowShift};
    std::uint8_t columns[kTinySide];
    std::memcpy(columns, &pixels, sizeof(pixels));
    const auto triangle = hn::Set(d, static_cast<std::uint32_t>(triangle_count_ << kTriangleShift));
    for (std::size_t r = 0; r < kTinySide; r += hn::Lanes(d)) {
      const auto bits = hn::PromoteTo(d, hn::LoadU(d8, columns + r));
      const auto entries = hn::Or(hn::Or(triangle, hn::Load(d, kRowNumbers + r)), bits);
      const auto has_pixels = hn::Ne(bits, hn::Zero(d));
      hn::StoreU(hn::Compress(entries, has_pixels), d, rows_ + row_count_);
      row_count_ += hn::CountTrue(d, has_pixels);
    }
  }

  /// Rows to spans: quantities at the first pixel, and the list of pixels. Entries past a span's end are
  /// written, and written over by the next span.
  HWY_INLINE void start_spans() {
    const hn::CappedTag<std::uint32_t, kTinySide> d;
    for (std::size_t s = 0; s < row_count_; ++s) {
      const std::uint32_t entry = rows_[s];
      const Triangle& t = triangles_[entry >> kTriangleShift];
      const std::uint32_t columns = entry & ((1u << kRowShift) - 1);
      const int column = t.column + __builtin_ctz(columns);
      const int row = t.row + static_cast<int>(entry >> kRowShift & (kTinySide - 1));
      Span& span = spans_[s];
      evaluate_planes(t.base, t.ddx, t.ddy, kTinyQuantities, tile_.pixel_x(column) - t.x0,
                      tile_.pixel_y(row) - t.y0, span.values);
      span.slope = t.slope;
      span.packed = t.packed;
      span.at = row * kTileWidth + column;
      const auto first = hn::Set(d, static_cast<std::uint32_t>(s << kSpanShift));
      for (std::size_t i = 0; i < kTinySide; i += hn::Lanes(d)) {
        hn::StoreU(hn::Add(first, hn::Load(d, kColumnNumbers + i)), d, pixels_ + pixel_count_ + i);
      }
      pixel_count_ += __builtin_popcount(columns);
    }
  }

  /// Depth test of one pixel. @return whether it is seen; then its depth has been written.
  HWY_INLINE bool test_pixel(const Span& span, float k, std::int32_t at) {
    float z = span.values[kRecordDepth] + span.slope[kRecordDepth] * k;
    z = z > 0.0f ? z : 0.0f;
    z = z < 1.0f ? z : 1.0f;
    if (!is_nearer(z, surface_.depth[at])) return false;
    surface_.depth[at] = z;
    return true;
  }

  /// Calls visit(span, k, at) for the pixels that are seen, k columns from their span's first. @return how
  /// many.
  template <class Visit>
  HWY_INLINE std::size_t for_each_seen(Visit&& visit) {
    std::size_t seen = 0;
    for (std::size_t i = 0; i < pixel_count_; ++i) {
      const Span& span = spans_[pixels_[i] >> kSpanShift];
      const std::uint32_t column = pixels_[i] & (kTinySide - 1);
      const std::int32_t at = span.at + static_cast<std::int32_t>(column);
      const float k = LaneNumberTable<float>::kNumbers[column];
      if (!test_pixel(span, k, at)) continue;
      ++seen;
      visit(span, k, at);
    }
    return seen;
  }

  std::size_t draw_flat_pixels() {
    return for_each_seen([&](const Span& span, float, std::int32_t at)
                             HWY_ATTR { surface_.color8[at] = span.packed; });
  }

  template <bool kDivides>
  std::size_t draw_smooth_pixels() {
    const hn::FixedTag<float, 4> d;
    return for_each_seen([&](const Span& span, float k, std::int32_t at) HWY_ATTR {
      auto color = hn::Add(hn::LoadU(d, span.values + paint_.color),
                           hn::Mul(hn::LoadU(d, span.slope + paint_.color), hn::Set(d, k)));
      if constexpr (kDivides) {
        const float q = span.values[kRecordQ] + span.slope[kRecordQ] * k;
        color = hn::Mul(color, hn::Set(d, inverse_q(q)));
      }
      surface_.color8[at] = pack_pixel(color);
    });
  }

  alignas(64) static constexpr std::uint32_t kColumnNumbers[kTinySide] = {0, 1, 2, 3, 4, 5, 6, 7};

  TileSurface& surface_;
  const TileArea tile_;
  TinyPaint paint_{};
  std::size_t triangle_count_ = 0, row_count_ = 0, pixel_count_ = 0;
  Triangle triangles_[kTriangles];
  Span spans_[kRows];
  std::uint32_t rows_[kRows + kTinySide];
  std::uint32_t pixels_[kPixels + kTinySide];
};

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
