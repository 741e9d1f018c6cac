// The sky: a colour for every direction, so that the faces of the cube meet without seams.
#include <algorithm>
#include <cmath>

#include "models/tool/noise.h"
#include "models/tool/pictures.h"

namespace barrido::models {
namespace {

/// Direction through (s, t) of a face: the reverse of OpenGL 1.3, table 3.19.
Vec3 direction_of(int face, double s, double t) {
  const double sc = 2.0 * s - 1.0;
  const double tc = 2.0 * t - 1.0;
  switch (face) {
    case 0:
      return {1, -tc, -sc};
    case 1:
      return {-1, -tc, sc};
    case 2:
      return {sc, 1, tc};
    case 3:
      return {sc, -1, -tc};
    case 4:
      return {sc, -tc, 1};
    default:
      return {-sc, -tc, -1};
  }
}

double clamped_step(double a, double b, double x) { return std::clamp((x - a) / (b - a), 0.0, 1.0); }

/// x^(2^doublings)
double power_of_two_power(double x, int doublings) {
  for (int i = 0; i < doublings; ++i) x *= x;
  return x;
}

Vec3 sky_color(const Vec3& d) {
  constexpr Vec3 kHorizon{0.86, 0.90, 0.93};
  constexpr Vec3 kZenith{0.16, 0.36, 0.72};
  const double height = std::max(d.y, 0.0);
  Vec3 color = lerp(kHorizon, kZenith, std::sqrt(height));
  // A layer of clouds, seen in perspective; it thins out towards the horizon.
  const double x = d.x / (height + 0.12);
  const double z = d.z / (height + 0.12);
  const double cloud = clamped_step(0.50, 0.72, turbulence(x * 1.3 + 11.2, z * 1.3 + 4.7, 5));
  color = lerp(color, Vec3(0.97, 0.97, 0.97), 0.85 * cloud * clamped_step(0.02, 0.25, height));
  const Vec3 to_sun = unit(Vec3(0.55, 0.62, 0.56));
  const double towards_sun = std::max(glm::dot(d, to_sun), 0.0);
  color += Vec3(1.0, 0.85, 0.6) * (0.35 * power_of_two_power(towards_sun, 5));
  return color + Vec3(1.0, 1.0, 0.9) * (1.5 * power_of_two_power(towards_sun, 10));
}

Vec3 ground_color(const Vec3& d) {
  constexpr Vec3 kNear{0.28, 0.31, 0.17};
  constexpr Vec3 kFar{0.62, 0.68, 0.58};
  const double depth = std::max(-d.y, 0.0);
  const double x = d.x / (depth + 0.06);
  const double z = d.z / (depth + 0.06);
  const double patches = turbulence(x * 1.7 + 3.1, z * 1.7 + 8.9, 3) - 0.5;
  return lerp(kFar, kNear, std::sqrt(clamped_step(0.0, 0.6, depth))) * (1.0 + 0.5 * patches);
}

/// Height of the hills (sine of the elevation) around the horizon.
double skyline(const Vec3& d) {
  const double across = std::sqrt(d.x * d.x + d.z * d.z);
  if (across == 0.0) return 0.0;
  const double x = d.x / across;
  const double z = d.z / across;
  return 0.16 * turbulence(x * 2.5 + 20.3, z * 2.5 + 30.9, 4) - 0.03;
}

Vec3 environment_color(const Vec3& d) {
  if (d.y < 0.0) return ground_color(d);
  const double hill = skyline(d);
  if (d.y < hill) return lerp(Vec3(0.46, 0.56, 0.54), Vec3(0.36, 0.46, 0.52), d.y / hill);
  return sky_color(d);
}

/// Mean colour of a pixel of a face: n × n samples where the skyline crosses it, else one.
Vec3 pixel_color(int face, int x, int y, int size) {
  const Vec3 middle = unit(direction_of(face, (x + 0.5) / size, (y + 0.5) / size));
  const bool is_on_edge = std::min(std::fabs(middle.y), std::fabs(middle.y - skyline(middle))) < 4.0 / size;
  const int n = is_on_edge ? 4 : 1;
  Vec3 sum{0, 0, 0};
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const Vec3 direction = direction_of(face, (x + (i + 0.5) / n) / size, (y + (j + 0.5) / n) / size);
      sum += glm::min(environment_color(unit(direction)), Vec3(1.0));
    }
  }
  return sum / static_cast<double>(n * n);
}

}  // namespace

Picture draw_sky(int face, int size) {
  Picture picture{size, size, {}};
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) append_pixel(picture, pixel_color(face, x, y, size));
  }
  return picture;
}

}  // namespace barrido::models
