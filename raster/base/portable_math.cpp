#include "raster/base/portable_math.h"

namespace barrido {
namespace {

/// sin r for |r| ≤ π/4: Taylor series to r¹⁷, remainder below 1e-18.
double sine_core(double r) {
  const double r2 = r * r;
  double p = 2.8114572543455206e-15;
  p = p * r2 - 7.6471637318198164e-13;
  p = p * r2 + 1.6059043836821613e-10;
  p = p * r2 - 2.5052108385441720e-08;
  p = p * r2 + 2.7557319223985893e-06;
  p = p * r2 - 1.9841269841269841e-04;
  p = p * r2 + 8.3333333333333333e-03;
  p = p * r2 - 1.6666666666666667e-01;
  return r + r * r2 * p;
}

/// cos r for |r| ≤ π/4: Taylor series to r¹⁶.
double cosine_core(double r) {
  const double r2 = r * r;
  double p = 4.7794773323873853e-14;
  p = p * r2 - 1.1470745597729725e-11;
  p = p * r2 + 2.0876756987868099e-09;
  p = p * r2 - 2.7557319223985891e-07;
  p = p * r2 + 2.4801587301587302e-05;
  p = p * r2 - 1.3888888888888889e-03;
  p = p * r2 + 4.1666666666666667e-02;
  p = p * r2 - 0.5;
  return 1.0 + r2 * p;
}

/// sin(x + quarter·π/2) by Cody and Waite's reduction: π/2 as a sum of two doubles, the first with 33 bits,
/// so that its product with the quadrant count is exact for |x| < 1e6.
double sine_of_quadrant(double x, long long quarter) {
  if (!std::isfinite(x)) return 0.0;
  constexpr double kHalfPiHigh = 1.57079632673412561417e+00;
  constexpr double kHalfPiLow = 6.07710050650619224932e-11;
  const double turns = std::floor(x * (2.0 / kPi) + 0.5);
  const double r = (x - turns * kHalfPiHigh) - turns * kHalfPiLow;
  const long long quadrant = (static_cast<long long>(std::fmod(turns, 4.0)) + 4 + quarter) & 3;
  const double value = (quadrant & 1) != 0 ? cosine_core(r) : sine_core(r);
  return (quadrant & 2) != 0 ? -value : value;
}

/// atan t for 0 ≤ t ≤ 1. Three halvings, atan t = 2 atan(t/(1 + √(1 + t²))), bring t below 0.0985, where
/// twelve terms of the series suffice.
double arc_tangent_core(double t) {
  double scale = 1.0;
  for (int i = 0; i < 3; ++i) {
    t = t / (1.0 + std::sqrt(1.0 + t * t));
    scale *= 2.0;
  }
  const double t2 = t * t;
  double p = 0.0;
  for (int k = 11; k >= 0; --k) {
    const double term = ((k & 1) != 0 ? -1.0 : 1.0) / (2.0 * k + 1.0);
    p = p * t2 + term;
  }
  return scale * t * p;
}

}  // namespace

double portable_sin(double x) { return sine_of_quadrant(x, 0); }
double portable_cos(double x) { return sine_of_quadrant(x, 1); }

double portable_atan2(double y, double x) {
  const double ax = std::fabs(x);
  const double ay = std::fabs(y);
  if (ax == 0.0 && ay == 0.0) return 0.0;
  double angle = ay <= ax ? arc_tangent_core(ay / ax) : kPi / 2.0 - arc_tangent_core(ax / ay);
  if (x < 0.0) angle = kPi - angle;
  return y < 0.0 ? -angle : angle;
}

}  // namespace barrido
