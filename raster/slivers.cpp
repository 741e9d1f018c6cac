#include "raster/slivers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace barrido::raster {
namespace {

struct Point {
  double x, y;
};

/// A convex polygon cut by the sides of a pixel: a triangle and four cuts leave at most seven corners.
struct Polygon {
  int count = 0;
  std::array<Point, 8> corner;

  void add(const Point& p) { corner[static_cast<std::size_t>(count++)] = p; }
};

/// The part of `polygon` on which `distance` is not negative.
template <class Distance>
Polygon cut(const Polygon& polygon, const Distance& distance) {
  Polygon inside;
  for (int i = 0; i < polygon.count; ++i) {
    const Point& a = polygon.corner[static_cast<std::size_t>(i)];
    const Point& b = polygon.corner[static_cast<std::size_t>((i + 1) % polygon.count)];
    const double da = distance(a), db = distance(b);
    if (da >= 0.0) inside.add(a);
    if ((da >= 0.0) != (db >= 0.0)) {
      const double t = da / (da - db);
      inside.add({a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t});
    }
  }
  return inside;
}

/// A triangle within the pixel whose lower left corner is at (x, y); 1/256 pixel, about that corner.
Polygon within_pixel(const PrimitiveRecord& t, double x, double y) {
  Polygon polygon;
  for (int i = 0; i < 3; ++i) polygon.add({t.x[i] - x, t.y[i] - y});
  polygon = cut(polygon, [](const Point& p) { return p.x; });
  polygon = cut(polygon, [](const Point& p) { return kSubpixelUnits - p.x; });
  polygon = cut(polygon, [](const Point& p) { return p.y; });
  return cut(polygon, [](const Point& p) { return kSubpixelUnits - p.y; });
}

double doubled_area(const Polygon& polygon) {
  double area = 0.0;
  for (int i = 2; i < polygon.count; ++i) {
    const Point& o = polygon.corner[0];
    const Point& a = polygon.corner[static_cast<std::size_t>(i - 1)];
    const Point& b = polygon.corner[static_cast<std::size_t>(i)];
    area += (a.x - o.x) * (b.y - o.y) - (b.x - o.x) * (a.y - o.y);
  }
  return std::abs(area);
}

Point mean(const Polygon& polygon) {
  Point sum{0.0, 0.0};
  for (int i = 0; i < polygon.count; ++i) {
    sum.x += polygon.corner[static_cast<std::size_t>(i)].x;
    sum.y += polygon.corner[static_cast<std::size_t>(i)].y;
  }
  return {sum.x / polygon.count, sum.y / polygon.count};
}

/// The multiple of 1/256 nearest to `wanted`, or a neighbour of it, that is inside the triangle.
/// @return false when there is none.
bool find_place(const PrimitiveRecord& t, std::int64_t x, std::int64_t y, const Point& wanted,
                SamplePlace& place) {
  const auto near = [](double v) {
    return std::clamp(static_cast<int>(std::floor(v + 0.5)), 0, kSubpixelUnits);
  };
  constexpr int kAround[9][2] = {{0, 0}, {1, 0},   {-1, 0}, {0, 1}, {0, -1},
                                 {1, 1}, {-1, -1}, {1, -1}, {-1, 1}};
  for (const auto& [dx, dy] : kAround) {
    place = {std::clamp(near(wanted.x) + dx, 0, kSubpixelUnits),
             std::clamp(near(wanted.y) + dy, 0, kSubpixelUnits)};
    if (is_inside(t, x + place.x, y + place.y)) return true;
  }
  return false;
}

/// Columns [begin, end) that a triangle may touch between two heights, generously.
std::pair<int, int> touched_columns(const PrimitiveRecord& t, const TileArea& tile, int row) {
  const double low = static_cast<double>(tile.y + row) * kSubpixelUnits;
  const double high = low + kSubpixelUnits;
  double least = 1e30, most = -1e30;
  const auto take = [&](double x) {
    least = std::min(least, x);
    most = std::max(most, x);
  };
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if (t.y[i] >= low && t.y[i] <= high) take(t.x[i]);
    for (const double y : {low, high}) {
      const double a = t.y[i] - y, b = t.y[j] - y;
      if ((a < 0.0) == (b < 0.0)) continue;
      take(t.x[i] + (static_cast<double>(t.x[j]) - t.x[i]) * (a / (a - b)));
    }
  }
  if (least > most) return {0, 0};
  const double origin = static_cast<double>(tile.x) * kSubpixelUnits;
  const auto column = [&](double x) {
    return static_cast<int>(std::clamp(std::floor((x - origin) / kSubpixelUnits), -2.0, kTileWidth + 2.0));
  };
  return {std::max(column(least - 1.0), 0), std::min(column(most + 1.0) + 1, tile.width)};
}

/// The last column from `first` on, whose lower left corner is inside, up to `last` that has it inside: such
/// columns of a convex shape are neighbours.
int last_corner_inside(const PrimitiveRecord& t, int origin, std::int64_t y, int first, int last) {
  int outside = last + 1;
  while (outside - first > 1) {
    const int middle = first + (outside - first) / 2;
    if (is_inside(t, static_cast<std::int64_t>(origin + middle) * kSubpixelUnits, y)) {
      first = middle;
    } else {
      outside = middle;
    }
  }
  return first;
}

}  // namespace

bool is_inside(const PrimitiveRecord& t, std::int64_t x, std::int64_t y) {
  const std::int64_t area = signed_area(t);
  if (area == 0) return false;
  const int corner[4] = {0, area < 0 ? 2 : 1, area < 0 ? 1 : 2, 0};
  for (int e = 0; e < 3; ++e) {
    const std::int64_t ax = t.x[corner[e]], ay = t.y[corner[e]];
    const std::int64_t dx = t.x[corner[e + 1]] - ax, dy = t.y[corner[e + 1]] - ay;
    const bool owns_places = dy < 0 || (dy == 0 && dx > 0);
    if (dx * (y - ay) - dy * (x - ax) < (owns_places ? 0 : 1)) return false;
  }
  return true;
}

SliverSearch::SliverSearch(const TileArea& tile,
                           std::function<const std::vector<SamplePlace>&(int at)> samples_of)
    : tile_(tile),
      samples_of_(std::move(samples_of)),
      pixels_(static_cast<std::size_t>(kTileWidth) * static_cast<std::size_t>(tile.height)) {}

void SliverSearch::add(const PrimitiveRecord& triangle) {
  if (signed_area(triangle) == 0) return;
  const auto [low, high] = std::minmax({triangle.y[0], triangle.y[1], triangle.y[2]});
  const int begin = std::max((low >> kSubpixelBits) - tile_.y, 0);
  const int end = std::min((high >> kSubpixelBits) + 1 - tile_.y, tile_.height);
  for (int row = begin; row < end; ++row) {
    const auto [first, last] = touched_columns(triangle, tile_, row);
    for (int column = first; column < last; ++column) {
      const std::int64_t x = static_cast<std::int64_t>(tile_.x + column) * kSubpixelUnits;
      const std::int64_t y = static_cast<std::int64_t>(tile_.y + row) * kSubpixelUnits;
      if (is_inside(triangle, x + kSubpixelUnits, y)) {
        column = last_corner_inside(triangle, tile_.x, y, column + 1, last);
        continue;
      }
      look_at_pixel(triangle, column, row);
    }
  }
}

void SliverSearch::look_at_pixel(const PrimitiveRecord& triangle, int column, int row) {
  const int at = row * kTileWidth + column;
  const std::int64_t x = static_cast<std::int64_t>(tile_.x + column) * kSubpixelUnits;
  const std::int64_t y = static_cast<std::int64_t>(tile_.y + row) * kSubpixelUnits;
  for (const SamplePlace& place : samples_of_(at)) {
    if (is_inside(triangle, x + place.x, y + place.y)) return;
  }
  const Polygon polygon = within_pixel(triangle, static_cast<double>(x), static_cast<double>(y));
  if (polygon.count < 3) return;
  Sliver sliver;
  sliver.area = static_cast<float>(doubled_area(polygon) / (2.0 * kSubpixelUnits * kSubpixelUnits));
  if (!(sliver.area > 0.0f) || !find_place(triangle, x, y, mean(polygon), sliver.place)) return;
  any_ = true;
  PixelSlivers& pixel = pixels_[static_cast<std::size_t>(at)];
  if (pixel.count < kMostSlivers) {
    pixel.slivers[static_cast<std::size_t>(pixel.count++)] = sliver;
    return;
  }
  const auto smallest = std::min_element(pixel.slivers.begin(), pixel.slivers.end(),
                                         [](const Sliver& a, const Sliver& b) { return a.area < b.area; });
  if (smallest->area >= sliver.area) return;
  std::move(smallest + 1, pixel.slivers.end(), smallest);  // drawing order stays
  pixel.slivers.back() = sliver;
}

}  // namespace barrido::raster
