#include "models/tool/noise.h"

#include <cmath>
#include <cstdint>

#include "models/tool/vector.h"

namespace barrido::models {
namespace {

/// A number in [0, 1] for each lattice point: the bits of its coordinates, well mixed (multiply and shift).
double lattice(std::int64_t x, std::int64_t y) {
  auto h = static_cast<std::uint32_t>(x) * 0x9e3779b1u ^ static_cast<std::uint32_t>(y) * 0x85ebca77u;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  h = (h ^ (h >> 12)) * 0x297a2d39u;
  return (h ^ (h >> 15)) / 4294967295.0;
}

double fade(double t) { return t * t * (3.0 - 2.0 * t); }

}  // namespace

double value_noise(double x, double y, int period) {
  const double floor_x = std::floor(x);
  const double floor_y = std::floor(y);
  const auto wrap = [period](std::int64_t i) { return period > 0 ? ((i % period) + period) % period : i; };
  const auto x0 = static_cast<std::int64_t>(floor_x);
  const auto y0 = static_cast<std::int64_t>(floor_y);
  const double u = fade(x - floor_x);
  const double v = fade(y - floor_y);
  const double upper = lerp(lattice(wrap(x0), wrap(y0)), lattice(wrap(x0 + 1), wrap(y0)), u);
  const double lower = lerp(lattice(wrap(x0), wrap(y0 + 1)), lattice(wrap(x0 + 1), wrap(y0 + 1)), u);
  return lerp(upper, lower, v);
}

double turbulence(double x, double y, int octaves, int period) {
  double sum = 0.0;
  double height = 1.0;
  double heights = 0.0;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += height * value_noise(x, y, period);
    heights += height;
    height *= 0.5;
    x *= 2.0;
    y *= 2.0;
    period *= 2;
  }
  return sum / heights;
}

}  // namespace barrido::models
