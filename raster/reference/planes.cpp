#include "raster/reference/planes.h"

#include <algorithm>
#include <cmath>

namespace barrido::raster::reference {
namespace {

/// Differences of two vertices' window positions to the first one's, in pixels.
struct Edges {
  double dx1, dy1, dx2, dy2;
};

double pixels(std::int32_t units) { return units / static_cast<double>(kSubpixelUnits); }

Edges edges_of(const PrimitiveRecord& p) {
  return {pixels(p.x[1]) - pixels(p.x[0]), pixels(p.y[1]) - pixels(p.y[0]), pixels(p.x[2]) - pixels(p.x[0]),
          pixels(p.y[2]) - pixels(p.y[0])};
}

Plane triangle_plane(double f0, double f1, double f2, const Edges& e, double inverse) {
  const double e1 = f1 - f0;
  const double e2 = f2 - f0;
  return {f0, (e1 * e.dy2 - e2 * e.dy1) * inverse, (e2 * e.dx1 - e1 * e.dx2) * inverse};
}

void offset_depth(const PolygonOffset& offset, Plane& depth) {
  if (!offset.enabled) return;
  const double steepest = std::max(std::fabs(depth.ddx), std::fabs(depth.ddy));
  constexpr double kDepthUnit = 1.0 / (1 << 24);
  depth.f0 = depth.f0 +
             (static_cast<double>(offset.factor) * steepest + static_cast<double>(offset.units) * kDepthUnit);
}

void make_triangle_planes(const PrimitiveRecord& p, const float* const (&records)[3], int count,
                          std::vector<Plane>& planes) {
  const Edges e = edges_of(p);
  const double inverse = 1.0 / (e.dx1 * e.dy2 - e.dx2 * e.dy1);
  for (int k = 0; k < count; ++k) {
    planes.push_back(triangle_plane(records[0][k], records[1][k], records[2][k], e, inverse));
  }
}

void make_line_planes(const PrimitiveRecord& p, const float* const (&records)[3], int count,
                      std::vector<Plane>& planes) {
  const Edges e = edges_of(p);
  const bool x_major = is_x_major(p);
  for (int k = 0; k < count; ++k) {
    const double f0 = records[0][k];
    const double e1 = records[1][k] - f0;
    planes.push_back(x_major ? Plane{f0, e1 / e.dx1, 0.0} : Plane{f0, 0.0, e1 / e.dy1});
  }
}

}  // namespace

PlaneSet make_planes(const PrimitiveChunk& chunk, const PrimitiveRecord& primitive) {
  const int varying_count = chunk.state->varyings.count;
  const int stride = record_stride(varying_count);
  const int count = kRecordVaryings + varying_count;
  const float* records[3] = {nullptr, nullptr, nullptr};
  const int vertices = chunk.topology == Topology::points ? 1 : chunk.topology == Topology::lines ? 2 : 3;
  for (int k = 0; k < vertices; ++k) records[k] = chunk.record(primitive.vertex[k], stride);

  PlaneSet set{pixels(primitive.x[0]), pixels(primitive.y[0]), {}};
  switch (chunk.topology) {
    case Topology::points:
      for (int k = 0; k < count; ++k) set.planes.push_back({records[0][k], 0.0, 0.0});
      break;
    case Topology::lines:
      make_line_planes(primitive, records, count, set.planes);
      break;
    case Topology::triangles:
      make_triangle_planes(primitive, records, count, set.planes);
      offset_depth(chunk.state->polygon_offset, set.planes[kRecordDepth]);
      break;
  }
  return set;
}

SpanQuantities quantities_along(const PlaneSet& set, const Span& span) {
  SpanQuantities along{span.first, span.end - 1, {}};
  for (const Plane& plane : set.planes) {
    const double row =
        (plane.f0 + plane.ddx * ((along.anchor + 0.5) - set.x0)) + plane.ddy * ((span.y + 0.5) - set.y0);
    along.quantities.push_back(
        {static_cast<float>(row), static_cast<float>(plane.ddx), static_cast<float>(plane.ddy)});
  }
  return along;
}

}  // namespace barrido::raster::reference
