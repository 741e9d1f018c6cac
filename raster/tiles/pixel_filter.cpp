#include "raster/tiles/pixel_filter.h"

#include <cmath>

#include "raster/base/portable_math.h"

namespace barrido::raster {
namespace {

/// e^x for x ≤ 0, to double precision on every machine: 2^k·e^f, the Taylor series of e^f.
double portable_exp(double x) {
  constexpr double kLn2 = 0.693147180559945309417232121458;
  const double k = std::floor(x / kLn2 + 0.5);
  if (k < -1000.0) return 0.0;
  const double f = x - k * kLn2;
  double sum = 1.0, term = 1.0;
  for (int n = 1; n < 20; ++n) {
    term *= f / n;
    sum += term;
  }
  return std::ldexp(sum, static_cast<int>(k));
}

constexpr double kSigma = 0.5;

/// The normal density with σ = ½.
double normal_density(double x) {
  const double t = x / kSigma;
  return portable_exp(-0.5 * t * t) / (kSigma * std::sqrt(2.0 * kPi));
}

/// Of |x| up to 2, integral 1.
double mitchell(double x) {
  constexpr double kB = 1.0 / 3.0, kC = 1.0 / 3.0;
  x = std::abs(x);
  if (x >= 2.0) return 0.0;
  if (x < 1.0)
    return ((12 - 9 * kB - 6 * kC) * x * x * x + (-18 + 12 * kB + 6 * kC) * x * x + (6 - 2 * kB)) / 6;
  return ((-kB - 6 * kC) * x * x * x + (6 * kB + 30 * kC) * x * x + (-12 * kB - 48 * kC) * x +
          (8 * kB + 24 * kC)) /
         6;
}

/// Of the filters that are products of the same function of x and of y, that function.
double along(const PixelFilter& filter, double x) {
  const double r = static_cast<double>(filter.radius);
  switch (filter.kind) {
    case PixelFilterKind::triangle:
      return r - std::abs(x);
    case PixelFilterKind::gaussian:
      return normal_density(x) - normal_density(r);
    case PixelFilterKind::mitchell:
      return mitchell(2.0 * x / r);
    default:
      return 1.0;
  }
}

/// The integral over y of the filter.
double marginal(const PixelFilter& filter, double x) {
  if (filter.kind != PixelFilterKind::cone) return along(filter, x);
  // ∫ (1 − √(x² + y²)/r) dy over |y| ≤ √(r² − x²) by the midpoint rule in the angle, which is smooth there.
  const double r = static_cast<double>(filter.radius);
  const double half = std::sqrt(std::max(0.0, r * r - x * x));
  constexpr int kSteps = 256;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double y = half * (i + 0.5) / kSteps;
    sum += 1.0 - std::sqrt(x * x + y * y) / r;
  }
  return 2.0 * half * sum / kSteps;
}

}  // namespace

float default_radius(PixelFilterKind kind) {
  constexpr float kRadius[] = {0.5f, 1.0f, 1.0f, 1.5f, 2.0f};
  return kRadius[static_cast<int>(kind)];
}

double filter_value(const PixelFilter& filter, double x, double y) {
  const double r = static_cast<double>(filter.radius);
  if (filter.kind == PixelFilterKind::cone) return std::max(0.0, 1.0 - std::sqrt(x * x + y * y) / r);
  if (std::abs(x) > r || std::abs(y) > r) return 0.0;
  return along(filter, x) * along(filter, y);
}

double filter_integral(const PixelFilter& filter) {
  const double r = static_cast<double>(filter.radius);
  switch (filter.kind) {
    case PixelFilterKind::box:
      return 4.0 * r * r;
    case PixelFilterKind::triangle:
      return r * r * r * r;
    case PixelFilterKind::cone:
      return kPi * r * r / 3.0;
    case PixelFilterKind::gaussian: {
      const double side = std::erf(r / (kSigma * std::sqrt(2.0))) - 2.0 * r * normal_density(r);
      return side * side;
    }
    case PixelFilterKind::mitchell:
      break;
  }
  return r * r / 4.0;
}

double filter_response(const PixelFilter& filter, double f) {
  constexpr int kSteps = 2048;  // even
  const double r = static_cast<double>(filter.radius);
  double response = 0.0, whole = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double x = -r + 2.0 * r * i / kSteps;
    const double share = (i == 0 || i == kSteps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * marginal(filter, x);
    response += share * portable_cos(2.0 * kPi * f * x);
    whole += share;
  }
  return response / whole;
}

}  // namespace barrido::raster
