#include "raster/reference/spans.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace barrido::raster::reference {
namespace {

constexpr int kHalfPixel = kSubpixelUnits / 2;

/// Larger points and wider lines count as this.
constexpr float kMaxSize = kMaxFrameSide;

std::int64_t floor_divide(std::int64_t numerator, std::int64_t denominator) {
  if (denominator < 0) return floor_divide(-numerator, -denominator);
  const std::int64_t quotient = numerator / denominator;
  return numerator % denominator < 0 ? quotient - 1 : quotient;
}

std::int64_t ceil_divide(std::int64_t numerator, std::int64_t denominator) {
  return -floor_divide(-numerator, denominator);
}

/// The first pixel whose centre is at or beyond `position` (1/256 pixel).
int first_center_from(int position) {
  return static_cast<int>(ceil_divide(position - kHalfPixel, kSubpixelUnits));
}

/// The last pixel whose centre is at or before `position`.
int last_center_to(int position) {
  return static_cast<int>(floor_divide(position - kHalfPixel, kSubpixelUnits));
}

int integer_size(float size) {
  const float bounded = size > kMaxSize ? kMaxSize : size;
  const float rounded = std::floor(bounded + 0.5f);
  return rounded > 1.0f ? static_cast<int>(rounded) : 1;
}

/// Cuts [begin, end) of row y to the frame and at the borders of tiles.
void append_pieces(int y, int begin, int end, FrameSize frame, std::vector<Span>& spans) {
  if (y < 0 || y >= frame.height) return;
  begin = std::max(begin, 0);
  end = std::min(end, frame.width);
  while (begin < end) {
    const int tile_end = (begin / kTileWidth + 1) * kTileWidth;
    spans.push_back({y, begin, std::min(end, tile_end)});
    begin = tile_end;
  }
}

std::int64_t twice_area(const PrimitiveRecord& p) {
  return static_cast<std::int64_t>(p.x[1] - p.x[0]) * (p.y[2] - p.y[0]) -
         static_cast<std::int64_t>(p.x[2] - p.x[0]) * (p.y[1] - p.y[0]);
}

/// The first pixel at or right of where row y crosses the edge from a to b (ya < yb).
int crossing(std::int64_t xa, std::int64_t ya, std::int64_t xb, std::int64_t yb, int y) {
  const std::int64_t center = static_cast<std::int64_t>(kSubpixelUnits) * y + kHalfPixel;
  const std::int64_t numerator = (xa - kHalfPixel) * (yb - ya) + (center - ya) * (xb - xa);
  const std::int64_t denominator = kSubpixelUnits * (yb - ya);
  return static_cast<int>(ceil_divide(numerator, denominator));
}

/// The first pixels right of the edges that row y crosses; two of them when the row meets the triangle.
std::vector<int> crossings(const PrimitiveRecord& p, int y) {
  const int center = kSubpixelUnits * y + kHalfPixel;
  std::vector<int> result;
  for (int k = 0; k < 3; ++k) {
    int a = k;
    int b = (k + 1) % 3;
    if (p.y[a] > p.y[b]) std::swap(a, b);
    if (p.y[a] <= center && center < p.y[b]) {
      result.push_back(crossing(p.x[a], p.y[a], p.x[b], p.y[b], y));
    }
  }
  return result;
}

}  // namespace

std::vector<Span> triangle_spans(const PrimitiveRecord& triangle, FrameSize frame, RowRange rows) {
  std::vector<Span> spans;
  if (twice_area(triangle) == 0) return spans;
  const auto [lowest, highest] = std::minmax_element(std::begin(triangle.y), std::end(triangle.y));
  const int begin = std::max({first_center_from(*lowest), 0, rows.begin});
  const int end = std::min({first_center_from(*highest), frame.height, rows.end});
  for (int y = begin; y < end; ++y) {
    const std::vector<int> ends = crossings(triangle, y);
    append_pieces(y, std::min(ends[0], ends[1]), std::max(ends[0], ends[1]), frame, spans);
  }
  return spans;
}

std::vector<Span> point_spans(const PrimitiveRecord& point, float size, FrameSize frame, RowRange rows) {
  const int n = integer_size(size);
  const auto lowest_pixel = [n](int position) {
    if (n % 2 == 1) return static_cast<int>(floor_divide(position, kSubpixelUnits)) - (n - 1) / 2;
    return static_cast<int>(floor_divide(position + kHalfPixel, kSubpixelUnits)) - n / 2;
  };
  const int left = lowest_pixel(point.x[0]);
  const int bottom = lowest_pixel(point.y[0]);
  std::vector<Span> spans;
  for (int y = std::max(bottom, rows.begin); y < std::min(bottom + n, rows.end); ++y) {
    append_pieces(y, left, left + n, frame, spans);
  }
  return spans;
}

bool is_x_major(const PrimitiveRecord& line) {
  return std::abs(line.x[1] - line.x[0]) >= std::abs(line.y[1] - line.y[0]);
}

std::vector<Span> line_spans(const PrimitiveRecord& line, float width, FrameSize frame, RowRange rows) {
  const bool x_major = is_x_major(line);
  const std::int32_t(&along)[3] = x_major ? line.x : line.y;
  const std::int32_t(&across)[3] = x_major ? line.y : line.x;
  const std::int64_t length = along[1] - along[0];
  const std::int64_t rise = across[1] - across[0];
  const int n = integer_size(width);
  std::vector<Span> spans;
  const auto append_column = [&](int major) {
    // The line's minor coordinate at the pixel's centre is a ratio with denominator `length`, in 1/256 pixel.
    const std::int64_t center = static_cast<std::int64_t>(kSubpixelUnits) * major + kHalfPixel;
    // A wide line is first moved down by (n - 1)/2 (OpenGL 1.3, section 3.4.2).
    const std::int64_t start = across[0] - (n - 1) * kHalfPixel;
    const std::int64_t numerator = start * length + (center - along[0]) * rise;
    const int lowest = static_cast<int>(floor_divide(numerator, kSubpixelUnits * length));
    for (int minor = lowest; minor < lowest + n; ++minor) {
      const int x = x_major ? major : minor;
      const int y = x_major ? minor : major;
      if (rows.holds(y)) append_pieces(y, x, x + 1, frame, spans);
    }
  };
  // Half-open at the end point, whichever way the line runs.
  if (length > 0) {
    const int end = first_center_from(along[1]);
    for (int major = first_center_from(along[0]); major < end; ++major) append_column(major);
  } else {
    const int end = last_center_to(along[1]);
    for (int major = last_center_to(along[0]); major > end; --major) append_column(major);
  }
  return spans;
}

}  // namespace barrido::raster::reference
