// What: depth, 1/w and the varyings of a primitive as planes over the screen, and their values along a span.
// Enters vertex records; knows nothing of what the quantities mean.
#pragma once

#include <vector>

#include "raster/fragments/primitive.h"
#include "raster/reference/spans.h"

namespace barrido::raster::reference {

/// f(x, y) = f0 + ddx·(x − x0) + ddy·(y − y0), in pixels.
struct Plane {
  double f0 = 0.0;
  double ddx = 0.0;
  double ddy = 0.0;
};

/// The planes of all quantities of a vertex record, in its order, through the primitive's first vertex.
struct PlaneSet {
  double x0 = 0.0;  ///< Pixels.
  double y0 = 0.0;
  std::vector<Plane> planes;
};

/// The primitive must cover at least one pixel.
PlaneSet make_planes(const PrimitiveChunk& chunk, const PrimitiveRecord& primitive);

/// One quantity along a span: its value at the anchor's centre and its slopes, per pixel.
struct SpanQuantity {
  float row = 0.0f;
  float ddx = 0.0f;
  float ddy = 0.0f;

  float at(float distance) const { return row + ddx * distance; }
};

/// All quantities of a record along one span.
struct SpanQuantities {
  int anchor = 0;  ///< First pixel of the span.
  int last = 0;    ///< Last pixel of the span.
  std::vector<SpanQuantity> quantities;
};

SpanQuantities quantities_along(const PlaneSet& set, const Span& span);

}  // namespace barrido::raster::reference
