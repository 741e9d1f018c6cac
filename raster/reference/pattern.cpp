#include "raster/reference/pattern.h"

#include <cmath>

#include "raster/base/portable_math.h"
#include "raster/textures/perlin_noise.h"

namespace barrido::raster::reference {
namespace {

float clamped_to(float value, float limit) { return minimum(maximum(value, -limit), limit); }

/// Antiderivative of the wave that filtered_wave() averages.
float wave_integral(float x, float rise) {
  const float whole = std::floor(x);
  const float f = x - whole;
  const float rest = 1.0f - f;
  const float part = f < rise ? (f * f) * (0.5f / rise) : 0.5f - (rest * rest) * (0.5f / (1.0f - rise));
  return whole * 0.5f + part;
}

/// How much of octave `octave` a pixel can show: all of it where its lattice is several pixels wide, nothing
/// from Nyquist's limit on.
float octave_weight(float finest, int octave) {
  const float t = clamp_to_unit(((finest - static_cast<float>(octave)) - 0.3f) * 2.5f);
  return (t * t) * (3.0f - (t + t));
}

/// Σ gain^i noise(2^i p), or of its magnitude. What an octave cannot show counts as its mean.
float sum_of_octaves(const Pattern& pattern, const float (&at)[3], bool magnitudes, PatternTrace& trace) {
  const float mean = magnitudes ? kMeanAbsoluteNoise : 0.0f;
  const float finest = -1.0f - portable_log2(trace.footprint);
  float frequency = 1.0f, amplitude = 1.0f, sum = 0.0f;
  for (int octave = 0; octave < pattern.octaves; ++octave) {
    const float weight = octave_weight(finest, octave);
    float shown = mean;
    if (weight > 0.0f) {
      const auto along = [&](int i) { return clamped_to(at[i] * frequency, kLargestNoiseCoordinate); };
      const float noise = perlin_noise(along(0), along(1), along(2));
      shown = mean + weight * ((magnitudes ? std::fabs(noise) : noise) - mean);
      ++trace.noise;
      trace.octaves = trace.octaves + weight;
    }
    sum = sum + amplitude * shown;
    frequency = frequency * 2.0f;
    amplitude = amplitude * pattern.gain;
  }
  trace.sum = sum;
  return sum;
}

float noise_value(const Pattern& pattern, const float (&at)[3], PatternTrace& trace) {
  const float sum = sum_of_octaves(pattern, at, false, trace);
  if (!pattern.has_threshold) return clamp_to_unit(0.5f * sum + 0.5f);
  // Noise climbs by about 2 a unit, so an edge is as wide as a pixel.
  const float width = maximum(trace.footprint, 1e-6f) * 2.0f;
  return clamp_to_unit((sum - pattern.threshold) / width + 0.5f);
}

/// Wood where `place` is the distance from the axis, marble where it is the height.
float moved_wave(const Pattern& pattern, const float (&at)[3], float place, float width,
                 PatternTrace& trace) {
  const float moved = pattern.turbulence;
  if (moved != 0.0f) {
    place = place + moved * sum_of_octaves(pattern, at, true, trace);
    width = width + std::fabs(moved) * trace.footprint;
  }
  trace.place = place;
  return filtered_wave(place, width, pattern.kind == PatternKind::wood ? kWoodRise : kMarbleRise);
}

float value_at(const Pattern& pattern, const float (&at)[3], const float (&extent)[3], PatternTrace& trace) {
  switch (pattern.kind) {
    case PatternKind::stripes:
      return 0.5f - 0.5f * filtered_parity(at[1], extent[1]);
    case PatternKind::checker:
      return 0.5f - 0.5f * ((filtered_parity(at[0], extent[0]) * filtered_parity(at[1], extent[1])) *
                            filtered_parity(at[2], extent[2]));
    case PatternKind::noise:
      return noise_value(pattern, at, trace);
    case PatternKind::wood:
      return moved_wave(pattern, at, std::sqrt(at[0] * at[0] + at[2] * at[2]), maximum(extent[0], extent[2]),
                        trace);
    case PatternKind::marble:
      break;
  }
  return moved_wave(pattern, at, at[1], extent[1], trace);
}

}  // namespace

float filtered_parity(float x, float w) {
  x = clamped_to(x, kLargestNoiseCoordinate);
  w = minimum(maximum(w, 1e-20f), 4096.0f);
  const float place = x - 2.0f * std::floor(x * 0.5f);  // in [0, 2): cell 0 is even, cell 1 odd
  // A window not wider than a cell holds one edge at most: the nearest whole number.
  const float edge = std::floor(place + 0.5f);
  const float share = clamped_to(((place - edge) + (place - edge)) / w, 1.0f);
  if (!(w > 1.0f)) return edge == 1.0f ? -share : share;
  const auto fold = [](float y) { return std::fabs((y * 0.5f - std::floor(y * 0.5f)) - 0.5f); };
  const float h = w * 0.5f;
  const float difference = fold(place - h) - fold(place + h);
  return (difference + difference) / w;
}

float filtered_wave(float x, float w, float rise) {
  x = clamped_to(x, kLargestNoiseCoordinate);
  w = minimum(maximum(w, 1.0f / 64.0f), 1024.0f);
  const float place = x - std::floor(x);
  const float h = w * 0.5f;
  return (wave_integral(place + h, rise) - wave_integral(place - h, rise)) / w;
}

PatternTrace pattern_at(const Pattern& pattern, const float (&at)[3], const float (&extent)[3]) {
  PatternTrace trace;
  trace.footprint = maximum(maximum(extent[0], extent[1]), extent[2]);
  trace.value = clamp_to_unit(value_at(pattern, at, extent, trace));
  return trace;
}

}  // namespace barrido::raster::reference
