// Perlin's improved noise (K. Perlin, "Improving Noise", SIGGRAPH 2002) in plain arithmetic: published values
// hold for doubles, pictures are made of floats.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace barrido::raster {

/// Perlin's permutation of 0 … 255.
extern const std::array<std::uint8_t, 256> kNoisePermutation;

/// Coordinates beyond ± this count as it: there floats have no fractions worth the name any more.
inline constexpr float kLargestNoiseCoordinate = 2097152.0f;

/// The six-fold smooth step 6t⁵ − 15t⁴ + 10t³.
template <class Real>
Real noise_fade(Real t) {
  return ((t * t) * t) * (t * (t * Real(6) - Real(15)) + Real(10));
}

/// (x, y, z) · one of twelve gradients, by the low four bits of the hash.
template <class Real>
Real noise_gradient(int hash, Real x, Real y, Real z) {
  const int h = hash & 15;
  const Real u = h < 8 ? x : y;
  const Real v = h < 4 ? y : (h == 12 || h == 14) ? x : z;
  return ((h & 1) == 0 ? u : -u) + ((h & 2) == 0 ? v : -v);
}

/// Noise in about [−1, 1] with period 256 along each axis; 0 at whole numbers.
template <class Real>
Real perlin_noise(Real x, Real y, Real z) {
  const Real floors[3] = {std::floor(x), std::floor(y), std::floor(z)};
  const auto hash = [](int i) { return static_cast<int>(kNoisePermutation[static_cast<unsigned>(i) & 255]); };
  const auto cell = [&](int axis) { return static_cast<int>(floors[axis]) & 255; };
  const Real fx = x - floors[0], fy = y - floors[1], fz = z - floors[2];
  const Real u = noise_fade(fx), v = noise_fade(fy), w = noise_fade(fz);
  const auto lerp = [](Real t, Real a, Real b) { return a + t * (b - a); };
  // Corners of the cell: `low` and `high` are the hashes of its two sides in x.
  const int low = hash(cell(0)) + cell(1), high = hash(cell(0) + 1) + cell(1);
  const auto edge = [&](int dy, int dz) {
    const int a = hash(hash(low + dy) + cell(2) + dz), b = hash(hash(high + dy) + cell(2) + dz);
    return lerp(u, noise_gradient(a, fx, fy - Real(dy), fz - Real(dz)),
                noise_gradient(b, fx - Real(1), fy - Real(dy), fz - Real(dz)));
  };
  return lerp(w, lerp(v, edge(0, 0), edge(1, 0)), lerp(v, edge(0, 1), edge(1, 1)));
}

}  // namespace barrido::raster
