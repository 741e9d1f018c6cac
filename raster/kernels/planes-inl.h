// What: the planes of all quantities of a primitive (depth, q = 1/w, varyings), one vector lane a quantity.
// Enters: window positions and vertex records. Leaves: values at a span's first pixel and slopes along the
// scanline.
#if defined(BARRIDO_PLANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BARRIDO_PLANES_INL_H
#undef BARRIDO_PLANES_INL_H
#else
#define BARRIDO_PLANES_INL_H
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "raster/kernels/simd_math-inl.h"
#include "raster/tiles/tile.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

inline constexpr int kMaxQuantities = record_stride(kMaxVaryings);

/// f(x, y) = base + ddx·(x − x0) + ddy·(y − y0) in window coordinates, for each quantity.
struct Planes {
  double x0, y0;
  int count = 0;  ///< Quantities, padded to a multiple of eight.
  alignas(64) double base[kMaxQuantities];
  alignas(64) double ddx[kMaxQuantities];
  alignas(64) double ddy[kMaxQuantities];
  alignas(64) float slope_x[kMaxQuantities];
  alignas(64) float slope_y[kMaxQuantities];
};

/// The perspective division: 1/q, by which varyings that stand divided by w are multiplied, for pixels in
/// vectors and for one. q is bounded below (docs/arithmetic.md, "What: planes").
template <class V>
HWY_INLINE V inverse_q(V q) {
  const hn::DFromV<V> d;
  return hn::Div(hn::Set(d, 1.0f), maximum(q, hn::Set(d, kSmallestQ)));
}
inline float inverse_q(float q) { return 1.0f / (q > kSmallestQ ? q : kSmallestQ); }

/// The inverse of the triangle's edge matrix: ddx = e1·a + e2·b with the differences e1, e2 of a quantity.
struct TriangleFrame {
  double x0, y0, dx1, dy1, dx2, dy2, inverse;
};

inline TriangleFrame triangle_frame(const PrimitiveRecord& p) {
  constexpr double kUnit = 1.0 / kSubpixelUnits;
  TriangleFrame f;
  f.x0 = p.x[0] * kUnit;
  f.y0 = p.y[0] * kUnit;
  f.dx1 = p.x[1] * kUnit - f.x0;
  f.dy1 = p.y[1] * kUnit - f.y0;
  f.dx2 = p.x[2] * kUnit - f.x0;
  f.dy2 = p.y[2] * kUnit - f.y0;
  f.inverse = 1.0 / (f.dx1 * f.dy2 - f.dx2 * f.dy1);
  return f;
}

inline double offset_depth(double base, double ddx, double ddy, const PolygonOffset& offset) {
  if (!offset.enabled) return base;
  return base + (static_cast<double>(offset.factor) * std::max(std::fabs(ddx), std::fabs(ddy)) +
                 static_cast<double>(offset.units) * 0x1p-24);
}

/// The plane of depth alone, for the visibility pass: the same operations as in `set_up_triangle`.
inline DepthPlane triangle_depth_plane(const TriangleFrame& f, float z0, float z1, float z2,
                                       const PolygonOffset& offset) {
  const double e1 = static_cast<double>(z1) - static_cast<double>(z0);
  const double e2 = static_cast<double>(z2) - static_cast<double>(z0);
  DepthPlane plane{f.x0, f.y0, static_cast<double>(z0), (e1 * f.dy2 - e2 * f.dy1) * f.inverse,
                   (e2 * f.dx1 - e1 * f.dx2) * f.inverse};
  plane.base = offset_depth(plane.base, plane.ddx, plane.ddy, offset);
  return plane;
}

/// Quantities of a triangle at its first vertex, and their derivatives.
template <class D>
struct PlaneOf {
  hn::Vec<D> base, ddx, ddy;
};

/// Of as many quantities as `d` has lanes, from those of the three vertices.
template <class D>
HWY_INLINE PlaneOf<D> plane_of(D d, const TriangleFrame& f, const float* r0, const float* r1,
                               const float* r2) {
  const hn::Rebind<float, D> df;
  const auto v0 = hn::PromoteTo(d, hn::LoadU(df, r0));
  const auto e1 = hn::Sub(hn::PromoteTo(d, hn::LoadU(df, r1)), v0);
  const auto e2 = hn::Sub(hn::PromoteTo(d, hn::LoadU(df, r2)), v0);
  const auto inverse = hn::Set(d, f.inverse);
  return {v0, hn::Mul(hn::Sub(hn::Mul(e1, hn::Set(d, f.dy2)), hn::Mul(e2, hn::Set(d, f.dy1))), inverse),
          hn::Mul(hn::Sub(hn::Mul(e2, hn::Set(d, f.dx1)), hn::Mul(e1, hn::Set(d, f.dx2))), inverse)};
}

HWY_INLINE void set_up_triangle(const TriangleFrame& f, const float* r0, const float* r1, const float* r2,
                                int count, const PolygonOffset& offset, Planes& planes) {
  const hn::ScalableTag<double> d;
  const hn::Rebind<float, decltype(d)> df;
  planes.x0 = f.x0;
  planes.y0 = f.y0;
  planes.count = count;
  for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d))) {
    const auto plane = plane_of(d, f, r0 + i, r1 + i, r2 + i);
    hn::Store(plane.base, d, planes.base + i);
    hn::Store(plane.ddx, d, planes.ddx + i);
    hn::Store(plane.ddy, d, planes.ddy + i);
    hn::Store(hn::DemoteTo(df, plane.ddx), df, planes.slope_x + i);
    hn::Store(hn::DemoteTo(df, plane.ddy), df, planes.slope_y + i);
  }
  planes.base[kRecordDepth] =
      offset_depth(planes.base[kRecordDepth], planes.ddx[kRecordDepth], planes.ddy[kRecordDepth], offset);
}

/// Quantities of a line vary along its major axis only, those of a point not at all: `r1` is null.
inline void set_up_line(const PrimitiveRecord& p, const float* r0, const float* r1, int count,
                        Planes& planes) {
  constexpr double kUnit = 1.0 / kSubpixelUnits;
  planes.x0 = p.x[0] * kUnit;
  planes.y0 = p.y[0] * kUnit;
  planes.count = count;
  const double dx = p.x[1] * kUnit - planes.x0;
  const double dy = p.y[1] * kUnit - planes.y0;
  const bool x_major = std::fabs(dx) >= std::fabs(dy);
  for (int i = 0; i < count; ++i) {
    const double e = r1 != nullptr ? r1[i] - static_cast<double>(r0[i]) : 0.0;
    planes.base[i] = r0[i];
    planes.ddx[i] = r1 != nullptr && x_major ? e / dx : 0.0;
    planes.ddy[i] = r1 != nullptr && !x_major ? e / dy : 0.0;
    planes.slope_x[i] = static_cast<float>(planes.ddx[i]);
    planes.slope_y[i] = static_cast<float>(planes.ddy[i]);
  }
}

/// Values of the first `count` quantities, a multiple of eight, (dx, dy) from the planes' reference point.
HWY_INLINE void evaluate_planes(const double* base, const double* ddx, const double* ddy, int count,
                                double dx, double dy, float* values) {
  const hn::ScalableTag<double> d;
  const hn::Rebind<float, decltype(d)> df;
  const auto to_x = hn::Set(d, dx);
  const auto to_y = hn::Set(d, dy);
  for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d))) {
    const auto along_x = hn::Add(hn::Load(d, base + i), hn::Mul(hn::Load(d, ddx + i), to_x));
    const auto value = hn::Add(along_x, hn::Mul(hn::Load(d, ddy + i), to_y));
    hn::Store(hn::DemoteTo(df, value), df, values + i);
  }
}

/// Values of all quantities at a place in the window, in pixels.
HWY_INLINE void evaluate_row(const Planes& planes, double x, double y, float* row) {
  evaluate_planes(planes.base, planes.ddx, planes.ddy, planes.count, x - planes.x0, y - planes.y0, row);
}

}  // namespace barrido::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
