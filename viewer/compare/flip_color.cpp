#include "viewer/compare/flip_color.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "raster/base/portable_math.h"

namespace barrido::compare {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

/// Linear sRGB to XYZ, exact for the primaries of ITU-R BT.709 and the white (0.3127, 0.3290).
constexpr Matrix kXyzFromRgb{{{10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0},
                              {2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0},
                              {1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0}}};

/// Rows divided by their sums: XYZ relative to that of white.
constexpr Matrix relative_to_white(Matrix m) {
  for (auto& row : m) {
    const double white = row[0] + row[1] + row[2];
    for (double& value : row) value /= white;
  }
  return m;
}

/// By Cramer's rule.
constexpr Matrix inverse(const Matrix& m) {
  const auto minor = [&](int row, int column) {
    const auto r0 = static_cast<std::size_t>((row + 1) % 3), r1 = static_cast<std::size_t>((row + 2) % 3);
    const auto c0 = static_cast<std::size_t>((column + 1) % 3),
               c1 = static_cast<std::size_t>((column + 2) % 3);
    return m[r0][c0] * m[r1][c1] - m[r0][c1] * m[r1][c0];
  };
  const double determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  Matrix result{};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      result[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] =
          minor(column, row) / determinant;
    }
  }
  return result;
}

constexpr Matrix kRelativeFromRgb = relative_to_white(kXyzFromRgb);
constexpr Matrix kRgbFromRelative = inverse(kRelativeFromRgb);

inline Triple transform(const Matrix& m, const Triple& v) {
  const auto row = [&](std::size_t r) {
    return static_cast<float>(m[r][0]) * v.x + static_cast<float>(m[r][1]) * v.y +
           static_cast<float>(m[r][2]) * v.z;
  };
  return {row(0), row(1), row(2)};
}

inline float clamped(float value) { return value > 0.0f ? std::min(value, 1.0f) : 0.0f; }

/// CIE's cube root with a straight part near 0.
inline float lab_root(float t) {
  constexpr float kDelta = 6.0f / 29.0f;
  return t > kDelta * kDelta * kDelta ? portable_pow(t, 1.0f / 3.0f)
                                      : t / (3.0f * kDelta * kDelta) + 4.0f / 29.0f;
}

Triple hunt_lab_from_linear(const Triple& rgb) {
  const Triple relative = transform(kRelativeFromRgb, rgb);
  const float fx = lab_root(relative.x), fy = lab_root(relative.y), fz = lab_root(relative.z);
  const float lightness = 116.0f * fy - 16.0f;
  const float hunt = 0.01f * lightness;
  return {lightness, hunt * 500.0f * (fx - fy), hunt * 200.0f * (fy - fz)};
}

constexpr float kExponent = 0.7f;     // q_c
constexpr float kLowerPart = 0.4f;    // p_c
constexpr float kSpreadOver = 0.95f;  // p_t

float powered_distance(const Triple& a, const Triple& b) {
  const float da = a.y - b.y, db = a.z - b.z;
  return portable_pow(std::fabs(a.x - b.x) + std::sqrt(da * da + db * db), kExponent);
}

}  // namespace

Triple ycxcz_from_linear(const Triple& rgb) {
  const Triple relative = transform(kRelativeFromRgb, rgb);
  return {116.0f * relative.y - 16.0f, 500.0f * (relative.x - relative.y),
          200.0f * (relative.y - relative.z)};
}

Triple hunt_lab_from_ycxcz(const Triple& ycxcz) {
  const float y = (ycxcz.x + 16.0f) / 116.0f;
  const Triple rgb = transform(kRgbFromRelative, {y + ycxcz.y / 500.0f, y, y - ycxcz.z / 200.0f});
  return hunt_lab_from_linear({clamped(rgb.x), clamped(rgb.y), clamped(rgb.z)});
}

float color_error(const Triple& hunt_lab_a, const Triple& hunt_lab_b) {
  // Green and blue are the two colours that are farthest from each other.
  static const float farthest =
      powered_distance(hunt_lab_from_linear({0.0f, 1.0f, 0.0f}), hunt_lab_from_linear({0.0f, 0.0f, 1.0f}));
  static const float knee = kLowerPart * farthest;
  const float distance = powered_distance(hunt_lab_a, hunt_lab_b);
  if (distance < knee) return distance * (kSpreadOver / knee);
  return kSpreadOver + (distance - knee) / (farthest - knee) * (1.0f - kSpreadOver);
}

float luminance(const Triple& rgb) { return transform(kXyzFromRgb, rgb).y; }

}  // namespace barrido::compare
