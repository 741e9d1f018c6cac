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
#include "raster/tile.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The tile's place in the window; all columns and rows below are relative to it.
struct TileArea {
  int x;       ///< Window x of column 0.
  int y;       ///< Window y of row 0.
  int width;   ///< Columns that lie in the frame.
  int height;  ///< Rows that lie in the frame.
};

/// Columns and rows, relative to the tile, that the scissor leaves.
struct ScissorBox {
  int x_begin = 0, y_begin = 0, x_end = kTileWidth, y_end = kTileHeight;
};

inline ScissorBox scissor_in(const Scissor& scissor, const TileArea& tile) {
  if (!scissor.enabled) return {};
  const auto relative = [](std::int64_t v, int origin, int limit) {
    return static_cast<int>(std::clamp<std::int64_t>(v - origin, 0, limit));
  };
  return {relative(scissor.x, tile.x, kTileWidth), relative(scissor.y, tile.y, kTileHeight),
          relative(static_cast<std::int64_t>(scissor.x) + std::max(scissor.width, 0), tile.x, kTileWidth),
          relative(static_cast<std::int64_t>(scissor.y) + std::max(scissor.height, 0), tile.y, kTileHeight)};
}

/// Whether the scissor leaves less than the tile's part of the frame.
inline bool cuts(const ScissorBox& scissor, const TileArea& tile) {
  return scissor.x_begin > 0 || scissor.y_begin > 0 || scissor.x_end < tile.width ||
         scissor.y_end < tile.height;
}

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

/// First pixel, in window coordinates, whose centre is at or after the coordinate (1/256 pixel).
inline int first_centre_at(std::int32_t v) { return (v + kSubpixelUnits / 2 - 1) >> kSubpixelBits; }

/// The lanes of a mask as bits, lane 0 lowest.
template <class D>
HWY_INLINE unsigned mask_bits(D d, hn::Mask<D> mask) {
  std::uint8_t bytes[8] = {0};
  hn::StoreMaskBits(d, mask, bytes);
  return bytes[0] | static_cast<unsigned>(bytes[1]) << 8;
}

/// An edge from its lower to its upper end: the crossing of row centre Y is the ceiling of
/// (start + (Y − y)·dx) / denominator, start = (x − 128)·dy.
struct Edge {
  double y, dx, dy, start, denominator;
};

inline Edge make_edge(std::int32_t xa, std::int32_t ya, std::int32_t xb, std::int32_t yb) {
  const double dy = static_cast<double>(yb) - ya;
  return {static_cast<double>(ya), static_cast<double>(xb) - xa, dy,
          (static_cast<double>(xa) - kSubpixelUnits / 2) * dy, kSubpixelUnits * dy};
}

/// Spans by exact division, for triangles of any size; the rows are known already.
HWY_INLINE void large_triangle_spans(const PrimitiveRecord& p, const TileArea& tile, TriangleSpans& spans) {
  const SortedCorners c = sort_by_y(p);
  const int middle_row = first_centre_at(c.y[1]) - tile.y;
  const Edge edge_long = make_edge(c.x[0], c.y[0], c.x[2], c.y[2]);
  const Edge edge_lower = make_edge(c.x[0], c.y[0], c.x[1], c.y[1]);
  const Edge edge_upper = make_edge(c.x[1], c.y[1], c.x[2], c.y[2]);

  const hn::ScalableTag<double> d;
  const hn::Rebind<std::int32_t, decltype(d)> di;
  const auto crossing = [&](auto center, auto y, auto dx, auto start, auto denominator) HWY_ATTR {
    const auto numerator = hn::Add(start, hn::Mul(hn::Sub(center, y), dx));
    // Held within the guard band so that the conversion is defined for slivers of rows past the last one as
    // well.
    return hn::DemoteTo(di, hn::Ceil(hn::Div(numerator, denominator)));
  };
  const auto low = hn::Set(di, tile.x);
  const auto high = hn::Set(di, tile.x + tile.width);
  const auto last_row = hn::Set(d, static_cast<double>(spans.row_end - 1));
  for (int r = spans.row_begin; r < spans.row_end; r += static_cast<int>(hn::Lanes(d))) {
    const auto row = hn::Min(barrido::HWY_NAMESPACE::lanes_from(d, static_cast<double>(r)), last_row);
    const auto center = hn::Add(hn::Mul(hn::Add(row, hn::Set(d, static_cast<double>(tile.y))),
                                        hn::Set(d, static_cast<double>(kSubpixelUnits))),
                                hn::Set(d, kSubpixelUnits / 2.0));
    const auto is_lower = hn::Lt(row, hn::Set(d, static_cast<double>(middle_row)));
    const auto pick = [&](double lower, double upper)
                          HWY_ATTR { return hn::IfThenElse(is_lower, hn::Set(d, lower), hn::Set(d, upper)); };
    const auto a = crossing(center, hn::Set(d, edge_long.y), hn::Set(d, edge_long.dx),
                            hn::Set(d, edge_long.start), hn::Set(d, edge_long.denominator));
    const auto b = crossing(center, pick(edge_lower.y, edge_upper.y), pick(edge_lower.dx, edge_upper.dx),
                            pick(edge_lower.start, edge_upper.start),
                            pick(edge_lower.denominator, edge_upper.denominator));
    const auto first = hn::Max(hn::Min(a, b), low);
    const auto end = hn::Min(hn::Max(a, b), high);
    hn::StoreU(hn::Sub(first, low), di, spans.first + r);
    hn::StoreU(hn::Sub(end, low), di, spans.end + r);
  }
}

/// The edge function of a counter-clockwise triangle's side, at least 0 inside: the rule of
/// docs/arithmetic.md gives left and lower sides their own pixel centres; the others lose one unit.
struct EdgeFunction {
  std::int32_t value;   ///< At the first centre of the box.
  std::int32_t step_x;  ///< To the next column.
  std::int32_t step_y;  ///< To the next row.
};

inline EdgeFunction edge_function(std::int32_t ax, std::int32_t ay, std::int32_t bx, std::int32_t by,
                                  std::int32_t center_x, std::int32_t center_y) {
  const std::int32_t dx = bx - ax;
  const std::int32_t dy = by - ay;
  const bool owns_centres = dy < 0 || (dy == 0 && dx > 0);
  return {dx * (center_y - ay) - dy * (center_x - ax) - (owns_centres ? 0 : 1), -dy * kSubpixelUnits,
          dx * kSubpixelUnits};
}

/// Spans of a triangle whose pixels in the tile lie in a box no wider than a vector: one lane a column. All
/// numbers fit 32 bits while the triangle is smaller than kSmallTriangle.
inline constexpr std::int32_t kSmallTriangle = 40 * kSubpixelUnits;

HWY_INLINE void small_triangle_spans(const PrimitiveRecord& p, bool clockwise, int column,
                                     const TileArea& tile, TriangleSpans& spans) {
  const hn::ScalableTag<std::int32_t> di;
  const int second = clockwise ? 2 : 1;
  const int third = 3 - second;
  const std::int32_t center_x = (tile.x + column) * kSubpixelUnits + kSubpixelUnits / 2;
  const std::int32_t center_y = (tile.y + spans.row_begin) * kSubpixelUnits + kSubpixelUnits / 2;
  const EdgeFunction e0 = edge_function(p.x[0], p.y[0], p.x[second], p.y[second], center_x, center_y);
  const EdgeFunction e1 = edge_function(p.x[second], p.y[second], p.x[third], p.y[third], center_x, center_y);
  const EdgeFunction e2 = edge_function(p.x[third], p.y[third], p.x[0], p.y[0], center_x, center_y);
  const auto lane = barrido::HWY_NAMESPACE::lanes_from(di, 0);
  const auto row_values = [&](const EdgeFunction& e) HWY_ATTR {
    return hn::Add(hn::Set(di, e.value), hn::Mul(lane, hn::Set(di, e.step_x)));
  };
  auto v0 = row_values(e0);
  auto v1 = row_values(e1);
  auto v2 = row_values(e2);
  const auto in_tile = barrido::HWY_NAMESPACE::lanes_below(di, tile.width - column);
  for (int r = spans.row_begin; r < spans.row_end; ++r) {
    const auto inside = hn::And(in_tile, hn::Gt(hn::Or(hn::Or(v0, v1), v2), hn::Set(di, -1)));
    const unsigned bits = mask_bits(di, inside);
    spans.first[r] = bits == 0 ? 0 : column + __builtin_ctz(bits);
    spans.end[r] = bits == 0 ? 0 : column + 32 - __builtin_clz(bits);
    v0 = hn::Add(v0, hn::Set(di, e0.step_y));
    v1 = hn::Add(v1, hn::Set(di, e1.step_y));
    v2 = hn::Add(v2, hn::Set(di, e2.step_y));
  }
}

/// Twice the signed area in (1/256 pixel)²; positive when counter-clockwise with y up.
inline std::int64_t signed_area(const PrimitiveRecord& p) {
  const std::int64_t dx1 = static_cast<std::int64_t>(p.x[1]) - p.x[0];
  const std::int64_t dy1 = static_cast<std::int64_t>(p.y[1]) - p.y[0];
  const std::int64_t dx2 = static_cast<std::int64_t>(p.x[2]) - p.x[0];
  const std::int64_t dy2 = static_cast<std::int64_t>(p.y[2]) - p.y[0];
  return dx1 * dy2 - dx2 * dy1;
}

/// The pixels of the tile that a triangle's bounding box holds, relative to the tile, half-open.
struct TriangleBox {
  int column_begin, column_end, row_begin, row_end;
  bool is_small;  ///< The triangle is smaller than kSmallTriangle, in and outside the tile.
};

/// @return false when there are none.
inline bool triangle_box(const PrimitiveRecord& p, const TileArea& tile, TriangleBox& box) {
  const std::int32_t x_min = std::min(std::min(p.x[0], p.x[1]), p.x[2]);
  const std::int32_t x_max = std::max(std::max(p.x[0], p.x[1]), p.x[2]);
  const std::int32_t y_min = std::min(std::min(p.y[0], p.y[1]), p.y[2]);
  const std::int32_t y_max = std::max(std::max(p.y[0], p.y[1]), p.y[2]);
  box.column_begin = std::max(first_centre_at(x_min) - tile.x, 0);
  box.column_end = std::min(first_centre_at(x_max) - tile.x, tile.width);
  box.row_begin = std::max(first_centre_at(y_min) - tile.y, 0);
  box.row_end = std::min(first_centre_at(y_max) - tile.y, tile.height);
  box.is_small = x_max - x_min < kSmallTriangle && y_max - y_min < kSmallTriangle;
  return box.column_begin < box.column_end && box.row_begin < box.row_end;
}

/// How much of a box of pixels a triangle covers.
enum class Cover : std::uint8_t { none, some, all };

/// By the edge functions at the box's corners. `none` and `all` are certain; `some` may turn out to be none.
inline Cover cover_of(const PrimitiveRecord& p, bool clockwise, const TriangleBox& box,
                      const TileArea& tile) {
  const int corner[4] = {0, clockwise ? 2 : 1, clockwise ? 1 : 2, 0};
  const std::int64_t x = (tile.x + box.column_begin) * kSubpixelUnits + kSubpixelUnits / 2;
  const std::int64_t y = (tile.y + box.row_begin) * kSubpixelUnits + kSubpixelUnits / 2;
  const std::int64_t width = (box.column_end - box.column_begin - 1) * kSubpixelUnits;
  const std::int64_t height = (box.row_end - box.row_begin - 1) * kSubpixelUnits;
  Cover cover = Cover::all;
  for (int e = 0; e < 3; ++e) {
    const std::int64_t ax = p.x[corner[e]];
    const std::int64_t ay = p.y[corner[e]];
    const std::int64_t dx = p.x[corner[e + 1]] - ax;
    const std::int64_t dy = p.y[corner[e + 1]] - ay;
    const bool owns_centres = dy < 0 || (dy == 0 && dx > 0);
    const std::int64_t value = dx * (y - ay) - dy * (x - ax) - (owns_centres ? 0 : 1);
    const std::int64_t along_x = -dy * width;
    const std::int64_t along_y = dx * height;
    const std::int64_t zero = 0;
    if (value + std::max(along_x, zero) + std::max(along_y, zero) < 0) return Cover::none;
    if (value + std::min(along_x, zero) + std::min(along_y, zero) < 0) cover = Cover::some;
  }
  return cover;
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
  const hn::ScalableTag<std::int32_t> di;
  if (box.is_small && box.column_end - box.column_begin <= static_cast<int>(hn::Lanes(di))) {
    small_triangle_spans(p, area < 0, box.column_begin, tile, spans);
    return true;
  }
  const Cover cover = box.is_small ? Cover::some : cover_of(p, area < 0, box, tile);
  if (cover == Cover::none) return false;
  if (cover == Cover::all) {
    whole_box_spans(box, spans);
  } else {
    large_triangle_spans(p, tile, spans);
  }
  return true;
}

/// Visits the spans (row, first, end) of an n × n square point.
template <class Visit>
void point_spans(const PrimitiveRecord& p, float point_size, const TileArea& tile, Visit&& visit) {
  const int size =
      std::max(1, static_cast<int>(std::floor(std::min(point_size, 1.0f * kMaxFrameSide) + 0.5f)));
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
void line_spans(const PrimitiveRecord& p, float line_width, const TileArea& tile, Visit&& visit) {
  const int width =
      std::max(1, static_cast<int>(std::floor(std::min(line_width, 1.0f * kMaxFrameSide) + 0.5f)));
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
  const auto at_or_after = [](std::int64_t v) { return (v + kSubpixelUnits / 2 - 1) >> kSubpixelBits; };
  const auto after = [](std::int64_t v) { return (v + kSubpixelUnits / 2) >> kSubpixelBits; };
  const bool up = d_major > 0;
  const std::int64_t begin = std::max<std::int64_t>(up ? at_or_after(major_a) : after(major_b), major_origin);
  const std::int64_t end =
      std::min<std::int64_t>(up ? at_or_after(major_b) : after(major_a), major_origin + major_size);
  for (std::int64_t k = 0; k < end - begin; ++k) {
    const std::int64_t pixel = up ? begin + k : end - 1 - k;
    const std::int64_t center = pixel * kSubpixelUnits + kSubpixelUnits / 2;
    const std::int64_t numerator = minor_a * d_major + (center - major_a) * d_minor;
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
