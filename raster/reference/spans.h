// Where: the pixels of points, lines and triangles as spans of scanlines, by exact integer arithmetic. Enters
// a primitive's snapped positions; knows nothing of depth, colours or textures.
#pragma once

#include <vector>

#include "raster/fragments/primitive.h"

namespace barrido::raster::reference {

/// The pieces of a primitive in different tiles are interpolated from different anchors, so tiles belong to
/// the arithmetic.
inline constexpr int kTileWidth = 128;
inline constexpr int kTileHeight = 32;

struct FrameSize {
  int width = 0;
  int height = 0;
};

/// Rows [begin, end) that are asked for.
struct RowRange {
  int begin = 0;
  int end = kMaxFrameSide;

  bool holds(int y) const { return y >= begin && y < end; }
};

/// Pixels [first, end) of row y, not empty, within the frame and within one tile.
struct Span {
  int y = 0;
  int first = 0;
  int end = 0;
};

/// "Spans": the pixels whose centres are inside the triangle, either orientation; none without area.
std::vector<Span> triangle_spans(const PrimitiveRecord& triangle, FrameSize frame, RowRange rows = {});

/// "Points and lines": the square of pixels of a point; `size` in pixels.
std::vector<Span> point_spans(const PrimitiveRecord& point, float size, FrameSize frame, RowRange rows = {});

/// The pixels of a line, a span each; `width` in pixels.
std::vector<Span> line_spans(const PrimitiveRecord& line, float width, FrameSize frame, RowRange rows = {});

/// True when the line advances along x (|xb − xa| ≥ |yb − ya|).
bool is_x_major(const PrimitiveRecord& line);

}  // namespace barrido::raster::reference
