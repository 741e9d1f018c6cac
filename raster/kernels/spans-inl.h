// Where: the scanline spans of one primitive in one tile. Exact on the 1/256-pixel grid; see
// docs/arithmetic.md for the rule and for why the ceiling of a double division is exact. Enters: a primitive
// and a tile. Leaves: spans.
#if defined(BARRIDO_SPANS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_SPANS_INL_H
#undef BARRIDO_SPANS_INL_H
#else
#define BARRIDO_SPANS_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "raster/kernels/lanes-inl.h"
#include "raster/kernels/triangle_edges.h"
#include "raster/tiles/tile.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A triangle's spans in a tile: row r covers columns [first[r], end[r]) for r in [row_begin, row_end).
struct TriangleSpans {
  int row_begin = 0;
  int row_end = 0;
  alignas(64) std::int32_t first[kTileHeight + kTilePadding];
  alignas(64) std::int32_t end[kTileHeight + kTilePadding];
};

/// The triangle's corners from the lowest to the highest, in 1/256 pixel.
struct SortedCorners {
  std::int32_t x[3];
  std::int32_t y[3];
};

inline SortedCorners sort_by_y(const PrimitiveRecord& p) {
  SortedCorners c{{p.x[0], p.x[1], p.x[2]}, {p.y[0], p.y[1], p.y[2]}};
  const auto order = [&c](int i, int j) {
    if (c.y[i] <= c.y[j]) return;
    std::swap(c.y[i], c.y[j]);
    std::swap(c.x[i], c.x[j]);
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return c;
}

/// The lanes of a mask as bits, lane 0 lowest.
template <class D>
HWY_INLINE unsigned mask_bits([[maybe_unused]] D d, hn::Mask<D> mask) {
#if HWY_TARGET <= HWY_AVX3 && HWY_ARCH_X86
  return static_cast<unsigned>(mask.raw);  // no detour through memory
#else
  std::uint8_t bytes[8] = {0};
  hn::StoreMaskBits(d, mask, bytes);
  return bytes[0] | static_cast<unsigned>(bytes[1]) << 8;
#endif
}

/// An edge from its lower to its upper end: it crosses the centre line of row r of the tile at column
/// (start + r·step)·inverse, never on a pixel's centre; see docs/arithmetic.md for the half that start lacks.
struct Edge {
  double start, step, inverse;
};

inline Edge make_edge(const SortedCorners& c, int lower, int upper, const TileArea& tile) {
  const double dx = static_cast<double>(c.x[upper]) - c.x[lower];
  const double dy = static_cast<double>(c.y[upper]) - c.y[lower];
  const double x = c.x[lower] - tile.center_x(0);
  const double y = c.y[lower] - tile.center_y(0);
  return {(x * dy - y * dx) - 0.5, kSubpixelUnits * dx, 1.0 / (kSubpixelUnits * dy)};
}

/// Spans of rows [row_begin, row_end), which the triangle's height holds.
HWY_INLINE void find_spans(const PrimitiveRecord& p, const TileArea& tile, TriangleSpans& spans) {
  const SortedCorners c = sort_by_y(p);
  const Edge edge_long = make_edge(c, 0, 2, tile);
  const Edge edge_lower = make_edge(c, 0, 1, tile);
  const Edge edge_upper = make_edge(c, 1, 2, tile);

  const hn::ScalableTag<double> d;
  const hn::Rebind<std::int32_t, decltype(d)> di;
  const auto middle_row = hn::Set(d, static_cast<double>(tile.first_row_at(c.y[1])));
  const auto last_row = hn::Set(d, static_cast<double>(spans.row_end - 1));
  const auto width = hn::Set(di, tile.width);
  for (int r = spans.row_begin; r < spans.row_end; r += static_cast<int>(hn::Lanes(d))) {
    // No row past the last: there the edges may cross anywhere.
    const auto row = hn::Min(lanes_from(d, static_cast<double>(r)), last_row);
    const auto is_lower = hn::Lt(row, middle_row);
    const auto pick = [&](double lower, double upper)
                          HWY_ATTR { return hn::IfThenElse(is_lower, hn::Set(d, lower), hn::Set(d, upper)); };
    const auto first_after = [&](auto start, auto step, auto inverse) HWY_ATTR {
      const auto crossing = hn::Mul(hn::Add(start, hn::Mul(row, step)), inverse);
      return ceiling_to_integer(d, crossing);
    };
    const auto a =
        first_after(hn::Set(d, edge_long.start), hn::Set(d, edge_long.step), hn::Set(d, edge_long.inverse));
    const auto b =
        first_after(pick(edge_lower.start, edge_upper.start), pick(edge_lower.step, edge_upper.step),
                    pick(edge_lower.inverse, edge_upper.inverse));
    hn::StoreU(hn::Max(hn::Min(a, b), hn::Zero(di)), di, spans.first + r);
    hn::StoreU(hn::Min(hn::Max(a, b), width), di, spans.end + r);
  }
}

/// All rows from one end of the box to the other.
HWY_INLINE void whole_box_spans(const TriangleBox& box, TriangleSpans& spans) {
  const hn::ScalableTag<std::int32_t> di;
  for (int r = box.row_begin; r < box.row_end; r += static_cast<int>(hn::Lanes(di))) {
    hn::StoreU(hn::Set(di, box.column_begin), di, spans.first + r);
    hn::StoreU(hn::Set(di, box.column_end), di, spans.end + r);
  }
}

/// @return false when the triangle has no pixels in the tile; true does not say that it has.
HWY_INLINE bool triangle_spans(const PrimitiveRecord& p, const TileArea& tile, TriangleSpans& spans) {
  const std::int64_t area = signed_area(p);
  TriangleBox box;
  if (area == 0 || !triangle_box(p, tile, box)) return false;
  spans.row_begin = box.row_begin;
  spans.row_end = box.row_end;
  const Cover cover = box.is_small ? Cover::some : cover_of(p, area < 0, box, tile);
  if (cover == Cover::none) return false;
  if (cover == Cover::all) {
    whole_box_spans(box, spans);
  } else {
    find_spans(p, tile, spans);
  }
  return true;
}

/// Of a point's size or a line's width, in pixels.
inline int whole_size(float size) {
  return std::max(1, static_cast<int>(std::floor(std::min(size, 1.0f * kMaxFrameSide) + 0.5f)));
}

/// Points and lines follow rules about pixels' centres: those are where the samples are, the primitive moves
/// the other way.
inline PrimitiveRecord about_centers(PrimitiveRecord p, const TileArea& tile) {
  for (std::int32_t& x : p.x) x -= tile.sample.x - kSubpixelUnits / 2;
  for (std::int32_t& y : p.y) y -= tile.sample.y - kSubpixelUnits / 2;
  return p;
}

/// Visits the spans (row, first, end) of an n × n square point.
template <class Visit>
void point_spans(const PrimitiveRecord& point, float point_size, const TileArea& tile, Visit&& visit) {
  const PrimitiveRecord p = about_centers(point, tile);
  const int size = whole_size(point_size);
  const auto lowest = [size](std::int32_t v) {
    return (size & 1) != 0 ? (v >> kSubpixelBits) - (size - 1) / 2
                           : ((v + kSubpixelUnits / 2) >> kSubpixelBits) - size / 2;
  };
  const int x = lowest(p.x[0]) - tile.x;
  const int y = lowest(p.y[0]) - tile.y;
  const int first = std::max(x, 0);
  const int end = std::min(x + size, tile.width);
  for (int row = std::max(y, 0); first < end && row < std::min(y + size, tile.height); ++row)
    visit(row, first, end);
}

inline std::int64_t floor_div(std::int64_t a, std::int64_t b) {
  const std::int64_t q = a / b;
  return q - static_cast<std::int64_t>((a % b != 0) && ((a < 0) != (b < 0)));
}

/// Visits the pixels of a line as spans of one pixel, from its first end to its second.
template <class Visit>
void line_spans(const PrimitiveRecord& line, float line_width, const TileArea& tile, Visit&& visit) {
  const PrimitiveRecord p = about_centers(line, tile);
  const int width = whole_size(line_width);
  const std::int64_t dx = static_cast<std::int64_t>(p.x[1]) - p.x[0];
  const std::int64_t dy = static_cast<std::int64_t>(p.y[1]) - p.y[0];
  const bool x_major = std::abs(dx) >= std::abs(dy);
  const std::int64_t d_major = x_major ? dx : dy;
  const std::int64_t d_minor = x_major ? dy : dx;
  if (d_major == 0) return;
  const std::int64_t major_a = x_major ? p.x[0] : p.y[0];
  const std::int64_t major_b = x_major ? p.x[1] : p.y[1];
  // A wide line is first moved down by (width - 1)/2 (OpenGL 1.3, section 3.4.2).
  const std::int64_t minor_a = (x_major ? p.y[0] : p.x[0]) - (width - 1) * (kSubpixelUnits / 2);
  const int major_origin = x_major ? tile.x : tile.y;
  const int minor_origin = x_major ? tile.y : tile.x;
  const int major_size = x_major ? tile.width : tile.height;
  const int minor_size = x_major ? tile.height : tile.width;

  // Centres in [a, b) going up, in (b, a] going down: half-open at the second end.
  const bool up = d_major > 0;
  const std::int64_t low = first_centre_at(up ? major_a : major_b + 1);
  const std::int64_t high = first_centre_at(up ? major_b : major_a + 1);
  const std::int64_t begin = std::max<std::int64_t>(low, major_origin);
  const std::int64_t end = std::min<std::int64_t>(high, major_origin + major_size);
  for (std::int64_t k = 0; k < end - begin; ++k) {
    const std::int64_t pixel = up ? begin + k : end - 1 - k;
    const std::int64_t numerator = minor_a * d_major + (centre_of(pixel) - major_a) * d_minor;
    const int major = static_cast<int>(pixel) - major_origin;
    const int lowest = static_cast<int>(floor_div(numerator, d_major * kSubpixelUnits)) - minor_origin;
    for (int minor = std::max(lowest, 0); minor < std::min(lowest + width, minor_size); ++minor) {
      if (x_major) {
        visit(minor, major, major + 1);
      } else {
        visit(major, minor, minor + 1);
      }
    }
  }
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
