// Elementary functions that give the same bits on every machine. The C library's sin, exp and pow differ
// between versions and pick instructions at run time, so nothing that decides a pixel may call them. Only
// IEEE addition, multiplication, division and square root are used here, all correctly rounded everywhere.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace barrido {

inline constexpr double kPi = 3.14159265358979323846;

/// log2(x), relative error below 2e-7 near 1; x below the smallest normal float counts as that. The same bits
/// as the vector form in raster/kernels/simd_math-inl.h.
///
/// x = 2^e·m with m in [√½, √2), s = (m − 1)/(m + 1), log2 m = (2/ln 2)(s + s³/3 + s⁵/5 + …).
inline float portable_log2(float x) {
  x = std::max(1.17549435e-38f, x);  // in this order a NaN counts as the smallest number too
  const std::int32_t bits = std::bit_cast<std::int32_t>(x);
  const std::int32_t exponent = (bits - 0x3f3504f3) >> 23;
  const float m = std::bit_cast<float>(bits - (exponent << 23));
  const float s = (m - 1.0f) / (m + 1.0f);
  const float s2 = s * s;
  float p = 0.32059889f;
  p = p * s2 + 0.41219858f;
  p = p * s2 + 0.57707802f;
  p = p * s2 + 0.96179669f;
  p = p * s2 + 2.88539008f;
  return p * s + static_cast<float>(exponent);
}

/// 2^x, relative error below 2e-7; 0 below 2^-126, and x above 127.49 counts as that. Same bits as the vector
/// form.
///
/// x = n + f with f in [−½, ½]; the Taylor polynomial of 2^f of degree 7 is exact to float precision there.
inline float portable_exp2(float x) {
  const float clamped = std::min(std::max(-126.0f, x), 127.49f);
  const float n = std::floor(clamped + 0.5f);
  const float f = clamped - n;
  float p = 1.52527338e-5f;
  p = p * f + 1.54035304e-4f;
  p = p * f + 1.33335581e-3f;
  p = p * f + 9.61812911e-3f;
  p = p * f + 5.55041087e-2f;
  p = p * f + 2.40226507e-1f;
  p = p * f + 6.93147181e-1f;
  p = p * f + 1.0f;
  // 2^n as n/2 twice would be needed for n = 128 only, which the clamp above rules out: p < 2 keeps 2^127·p
  // finite.
  const float scale = std::bit_cast<float>((static_cast<std::int32_t>(n) + 127) << 23);
  return x < -126.0f ? 0.0f : p * scale;
}

/// x^n for x ≥ 0 (negative x counts as 0); x^0 = 1, 0^n = 0 for n > 0. Same bits as the vector form.
inline float portable_pow(float x, float n) {
  if (n == 0.0f) return 1.0f;
  return x > 0.0f ? portable_exp2(n * portable_log2(x)) : 0.0f;
}

/// The angle of (x, y) in turns, from −½ to ½, counter-clockwise from +x; 0 for (0, 0). Absolute error below
/// 4e-8. Same bits as the vector form.
///
/// atan(r)/2π for r in [0, 1] is r times a polynomial in r² (Chebyshev interpolation of degree 9).
inline float portable_turn(float y, float x) {
  const float ax = std::fabs(x);
  const float ay = std::fabs(y);
  const bool is_steep = ay > ax;
  const float larger = is_steep ? ay : ax;
  const float r = (is_steep ? ax : ay) / (larger > 1e-30f ? larger : 1e-30f);
  const float r2 = r * r;
  float p = -0.000270749611f;
  p = p * r2 + 0.00166916116f;
  p = p * r2 - 0.0048306492f;
  p = p * r2 + 0.00908608492f;
  p = p * r2 - 0.013289f;
  p = p * r2 + 0.0173993619f;
  p = p * r2 - 0.0226955205f;
  p = p * r2 + 0.0318279253f;
  p = p * r2 - 0.0530515569f;
  p = p * r2 + 0.159154943f;
  float turn = p * r;
  if (is_steep) turn = 0.25f - turn;
  if (x < 0.0f) turn = 0.5f - turn;
  return y < 0.0f ? -turn : turn;
}

/// Sine and cosine of x radians, absolute error below 1e-15 for |x| < 1e6.
double portable_sin(double x);
double portable_cos(double x);
inline double portable_tan(double x) { return portable_sin(x) / portable_cos(x); }
/// Arc tangent of y/x in [−π, π] with the quadrant of (x, y); 0 for (0, 0).
double portable_atan2(double y, double x);
/// Arc cosine of x, clamped to [−1, 1].
inline double portable_acos(double x) {
  const double c = std::clamp(x, -1.0, 1.0);
  return portable_atan2(std::sqrt((1.0 - c) * (1.0 + c)), c);
}
inline double portable_asin(double x) {
  const double s = std::clamp(x, -1.0, 1.0);
  return portable_atan2(s, std::sqrt((1.0 - s) * (1.0 + s)));
}
inline double radians(double degrees) { return degrees * (kPi / 180.0); }

}  // namespace barrido
