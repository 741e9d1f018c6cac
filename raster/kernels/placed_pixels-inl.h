// Pixels with places of their own: which of a tile's pixels a primitive covers when each is sampled somewhere
// else. Edges are those of triangle_edges.h, evaluated at every pixel: differences have 25 bits, products 50,
// so doubles hold all of it. Enters: primitives, places. Leaves: a bit a pixel, row by row.
#if defined(BARRIDO_PLACED_PIXELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_PLACED_PIXELS_INL_H
#undef BARRIDO_PLACED_PIXELS_INL_H
#else
#define BARRIDO_PLACED_PIXELS_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "raster/kernels/spans-inl.h"
#include "raster/tiles/tile.h"
#include "raster/tiles/tile_places.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The pixels of a tile that have places in a box of the window.
inline TriangleBox box_in_reach(std::int32_t x_min, std::int32_t y_min, std::int32_t x_max,
                                std::int32_t y_max, const TileArea& tile, const SampleReach& reach) {
  TileArea least = tile, most = tile;
  least.sample = reach.least;
  most.sample = reach.most;
  return {std::max(most.first_column_at(x_min), 0), std::min(least.first_column_at(x_max), tile.width),
          std::max(most.first_row_at(y_min), 0), std::min(least.first_row_at(y_max), tile.height), false};
}

/// A triangle's sides at the lower left corner of the tile's column 0 in some row, at least 0 inside, and
/// what a unit along either axis adds.
struct PlacedEdges {
  double value[3], along_x[3], along_y[3];

  PlacedEdges(const PrimitiveRecord& p, bool clockwise, const TileArea& tile, int row) {
    const int corner[4] = {0, clockwise ? 2 : 1, clockwise ? 1 : 2, 0};
    const std::int64_t x = static_cast<std::int64_t>(tile.x) * kSubpixelUnits;
    const std::int64_t y = static_cast<std::int64_t>(tile.y + row) * kSubpixelUnits;
    for (int e = 0; e < 3; ++e) {
      const std::int64_t ax = p.x[corner[e]];
      const std::int64_t ay = p.y[corner[e]];
      const std::int64_t dx = p.x[corner[e + 1]] - ax;
      const std::int64_t dy = p.y[corner[e + 1]] - ay;
      const bool owns_places = dy < 0 || (dy == 0 && dx > 0);
      value[e] = static_cast<double>(dx * (y - ay) - dy * (x - ax) - (owns_places ? 0 : 1));
      along_x[e] = static_cast<double>(-dy);
      along_y[e] = static_cast<double>(dx);
    }
  }

  void next_row() {
    for (int e = 0; e < 3; ++e) value[e] += along_y[e] * kSubpixelUnits;
  }
};

/// Of columns [begin, end) of a row those whose places are inside.
HWY_INLINE PixelBits covered_in_row(const PlacedEdges& edges, const TilePlaces& places, int row, int begin,
                                    int end) {
  const hn::ScalableTag<double> d;
  const hn::Rebind<float, decltype(d)> df;
  const int lanes = static_cast<int>(hn::Lanes(d));
  PixelBits bits;
  for (int x = begin & ~(lanes - 1); x < end; x += lanes) {
    const int at = row * kTileWidth + x;
    const auto units = [&](const float* offset) HWY_ATTR {
      return hn::Add(hn::Mul(hn::PromoteTo(d, hn::LoadU(df, offset + at)), hn::Set(d, kSubpixelUnits)),
                     hn::Set(d, kSubpixelUnits / 2));
    };
    const auto px =
        hn::Add(units(places.x), hn::Mul(lanes_from(d, static_cast<double>(x)), hn::Set(d, kSubpixelUnits)));
    const auto py = units(places.y);
    auto least = hn::Set(d, 1.0);
    for (int e = 0; e < 3; ++e) {
      const auto value =
          hn::Add(hn::Add(hn::Set(d, edges.value[e]), hn::Mul(hn::Set(d, edges.along_x[e]), px)),
                  hn::Mul(hn::Set(d, edges.along_y[e]), py));
      least = hn::Min(least, value);
    }
    bits.put(x, mask_bits(d, hn::Ge(least, hn::Zero(d))));
  }
  return bits & PixelBits::of(begin, end);
}

/// Calls visit(row, bits) for the rows of a triangle in which pixels that are wanted are covered.
template <class Visit>
HWY_INLINE void placed_triangle(const PrimitiveRecord& p, const TileArea& tile, const TilePlaces& places,
                                Visit&& visit) {
  const std::int64_t area = signed_area(p);
  if (area == 0) return;
  const TriangleBox box = box_in_reach(std::min({p.x[0], p.x[1], p.x[2]}), std::min({p.y[0], p.y[1], p.y[2]}),
                                       std::max({p.x[0], p.x[1], p.x[2]}), std::max({p.y[0], p.y[1], p.y[2]}),
                                       tile, places.reach);
  if (box.column_begin >= box.column_end || box.row_begin >= box.row_end) return;
  const PixelBits columns = PixelBits::of(box.column_begin, box.column_end);
  PlacedEdges edges(p, area < 0, tile, box.row_begin);
  for (int row = box.row_begin; row < box.row_end; ++row, edges.next_row()) {
    const PixelBits wanted = places.wanted[row] & columns;
    if (wanted.none()) continue;
    const PixelBits bits = covered_in_row(edges, places, row, wanted.first(), wanted.last() + 1) & wanted;
    if (!bits.none()) visit(row, bits);
  }
}

/// The same for what follows rules about centres: `covers(column, row, moved)` says whether the primitive
/// `moved` so that the pixel's place comes to its centre covers the pixel.
template <class Covers, class Visit>
void placed_pixels(const PrimitiveRecord& p, const TriangleBox& box, const TilePlaces& places,
                   const Covers& covers, Visit&& visit) {
  for (int row = box.row_begin; row < box.row_end; ++row) {
    PixelBits bits;
    const PixelBits wanted = places.wanted[row] & PixelBits::of(box.column_begin, box.column_end);
    if (wanted.none()) continue;
    for (int column = wanted.first(); column <= wanted.last(); ++column) {
      if (!wanted.has(column)) continue;
      const int at = row * kTileWidth + column;
      PrimitiveRecord moved = p;
      for (std::int32_t& x : moved.x) x -= static_cast<std::int32_t>(places.x[at] * kSubpixelUnits);
      for (std::int32_t& y : moved.y) y -= static_cast<std::int32_t>(places.y[at] * kSubpixelUnits);
      if (covers(column, row, moved)) bits.put(column, 1);
    }
    if (!bits.none()) visit(row, bits);
  }
}

/// The box of a point or line of this width, and of all that its rounding may add.
inline TriangleBox placed_box(const PrimitiveRecord& p, int ends, float width, const TilePlaces& places,
                              const TileArea& tile) {
  const int margin = (whole_size(width) / 2 + 1) * kSubpixelUnits;
  const auto [x_min, x_max] = std::minmax(p.x[0], p.x[ends - 1]);
  const auto [y_min, y_max] = std::minmax(p.y[0], p.y[ends - 1]);
  return box_in_reach(x_min - margin, y_min - margin, x_max + margin + kSubpixelUnits,
                      y_max + margin + kSubpixelUnits, tile, places.reach);
}

/// Whether a line's spans (spans-inl.h) hold the pixel: the same rule, asked of a single one.
inline bool line_covers(const PrimitiveRecord& p, float line_width, std::int64_t x, std::int64_t y) {
  const int width = whole_size(line_width);
  const std::int64_t dx = static_cast<std::int64_t>(p.x[1]) - p.x[0];
  const std::int64_t dy = static_cast<std::int64_t>(p.y[1]) - p.y[0];
  const bool x_major = std::abs(dx) >= std::abs(dy);
  const std::int64_t d_major = x_major ? dx : dy;
  const std::int64_t d_minor = x_major ? dy : dx;
  if (d_major == 0) return false;
  const std::int64_t a = x_major ? p.x[0] : p.y[0];
  const std::int64_t b = x_major ? p.x[1] : p.y[1];
  const std::int64_t center = centre_of(x_major ? x : y);
  if (d_major > 0 ? center < a || center >= b : center > a || center <= b) return false;
  const std::int64_t minor_a = (x_major ? p.y[0] : p.x[0]) - (width - 1) * (kSubpixelUnits / 2);
  const std::int64_t lowest = floor_div(minor_a * d_major + (center - a) * d_minor, d_major * kSubpixelUnits);
  const std::int64_t minor = x_major ? y : x;
  return minor >= lowest && minor < lowest + width;
}

/// Calls visit(row, bits) for what a primitive covers.
template <class Visit>
HWY_INLINE void placed_primitive(const PrimitiveChunk& chunk, const PrimitiveRecord& p, const TileArea& tile,
                                 const TilePlaces& places, Visit&& visit) {
  if (chunk.topology == Topology::triangles) return placed_triangle(p, tile, places, visit);
  if (chunk.topology == Topology::lines) {
    const auto covers = [&](int column, int row, const PrimitiveRecord& moved) {
      return line_covers(moved, chunk.line_width, tile.x + column, tile.y + row);
    };
    return placed_pixels(p, placed_box(p, 2, chunk.line_width, places, tile), places, covers, visit);
  }
  const auto covers = [&](int column, int row, const PrimitiveRecord& moved) {
    bool is_covered = false;
    const TileArea pixel{tile.x + column, tile.y + row, 1, 1, {}};
    point_spans(moved, chunk.point_size, pixel, [&](int, int, int) { is_covered = true; });
    return is_covered;
  };
  placed_pixels(p, placed_box(p, 1, chunk.point_size, places, tile), places, covers, visit);
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
