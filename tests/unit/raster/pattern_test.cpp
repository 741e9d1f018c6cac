// Textures by procedure: Perlin's published noise, the closed forms of filtered stripes and checkers against
// sums of samples, and how octaves fade.
#include "raster/reference/pattern.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "raster/textures/perlin_noise.h"

namespace barrido::raster {
namespace {

struct PublishedNoise {
  double x, y, z, value;
};

/// Improved noise in doubles. The first two stand in the test suites of several projects.
constexpr PublishedNoise kPublished[] = {{3.14, 42, 7, 0.13691995878400012},
                                         {-4.2, 10, 6, 0.14208000000000043},
                                         {0.5, 0.5, 0.5, -0.25},
                                         {0.1, 0.1, 0.1, 0.1861607143544832},
                                         {1.5, 2.5, 3.5, 0.125},
                                         {0.25, 0.5, 0.75, -0.2697153091430664},
                                         {3.14, 42, 0, 0.13691995878400012},
                                         {-4.2, 10, 0, -0.14208000000000043},
                                         {10.3, 20.7, 30.9, 0.14808666234708512}};

TEST(PerlinNoise, HasThePublishedValues) {
  for (const PublishedNoise& p : kPublished) {
    EXPECT_NEAR(perlin_noise(p.x, p.y, p.z), p.value, 1e-15) << p.x;
    // As floats the coordinates are off by up to 2^-21, times a slope of about 2.
    EXPECT_NEAR(perlin_noise(static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)),
                p.value, 3e-6)
        << p.x;
  }
  EXPECT_FLOAT_EQ(perlin_noise(3.14f, 42.0f, 7.0f), 0.13692005f);
  EXPECT_EQ(noise_fade(0.75), 0.896484375);
}

TEST(PerlinNoise, IsZeroOnTheLatticeAndRepeatsAfter256) {
  for (int i = -300; i < 300; i += 7) {
    const auto at = static_cast<double>(i);
    EXPECT_EQ(perlin_noise(at, at * 2.0, 5.0 - at), 0.0);
    EXPECT_EQ(perlin_noise(at + 0.25, 0.5, 0.125), perlin_noise(at + 256.25, 0.5 - 256.0, 512.125));
  }
}

TEST(PerlinNoise, HasTheKnownVarianceAndMeanMagnitude) {
  std::mt19937 bits(1);
  const auto number = [&] { return static_cast<double>(bits()) * (256.0 / 4294967296.0); };
  double squares = 0.0, magnitudes = 0.0, largest = 0.0;
  constexpr int kCount = 400000;
  for (int k = 0; k < kCount; ++k) {
    const double noise = perlin_noise(number(), number(), number());
    squares += noise * noise;
    magnitudes += std::fabs(noise);
    largest = std::max(largest, std::fabs(noise));
  }
  EXPECT_NEAR(squares / kCount, 0.0732, 5e-4);
  EXPECT_NEAR(magnitudes / kCount, static_cast<double>(kMeanAbsoluteNoise), 1e-3);
  EXPECT_LT(largest, 1.0);
}

/// Parity of a cell: +1 or −1.
double parity(double x) { return std::fmod(std::floor(x), 2.0) == 0.0 ? 1.0 : -1.0; }

/// Of a wave that rises in `rise` of its period.
double wave(double x, double rise) {
  const double f = x - std::floor(x);
  return f < rise ? f / rise : (1.0 - f) / (1.0 - rise);
}

template <class Function>
double mean_over(double x, double w, const Function& function) {
  constexpr int kSamples = 20000;
  double sum = 0.0;
  for (int k = 0; k < kSamples; ++k) sum += function(x + w * ((k + 0.5) / kSamples - 0.5));
  return sum / kSamples;
}

TEST(Patterns, StripesAndWavesAreMeansOverThePixel) {
  std::mt19937 bits(2);
  const auto number = [&](double least, double most) {
    return least + (most - least) * (static_cast<double>(bits()) / 4294967296.0);
  };
  for (int k = 0; k < 300; ++k) {
    const double x = number(-5.0, 5.0), w = std::exp(number(-3.0, 2.0));
    const auto xf = static_cast<float>(x), wf = static_cast<float>(w);
    EXPECT_NEAR(reference::filtered_parity(xf, wf), mean_over(x, w, parity), 1e-3) << x << " " << w;
    for (const float rise : {kWoodRise, kMarbleRise}) {
      const double expected = mean_over(x, w, [&](double at) { return wave(at, static_cast<double>(rise)); });
      EXPECT_NEAR(reference::filtered_wave(xf, wf, rise), expected, 1e-4) << x << " " << w;
    }
  }
}

struct AreaAverage {
  float x, y, w, mean;
};

TEST(Patterns, CheckersHaveThePublishedAreaAverages) {
  constexpr AreaAverage kAverages[] = {{0.25f, 0.25f, 1.0f, 0.375f},
                                       {0.25f, 0.75f, 1.5f, 0.444444f},
                                       {0.3f, 0.6f, 3.0f, 0.473333f},
                                       {1.0f, 0.5f, 0.5f, 0.5f},
                                       {0.123f, 7.77f, 2.0f, 0.5f}};
  Pattern checker;
  checker.kind = PatternKind::checker;
  for (const AreaAverage& a : kAverages) {
    const auto trace = reference::pattern_at(checker, {a.x, a.y, 0.5f}, {a.w, a.w, 0.0f});
    EXPECT_NEAR(trace.value, a.mean, 1e-6f) << a.x << " " << a.y;
  }
}

TEST(Patterns, SharpWhereAPixelIsSmall) {
  Pattern pattern;
  for (const PatternKind kind : {PatternKind::stripes, PatternKind::checker}) {
    pattern.kind = kind;
    for (int i = -4; i < 4; ++i) {
      const float y = static_cast<float>(i) + 0.3f;
      const auto trace = reference::pattern_at(pattern, {0.5f, y, 0.5f}, {1e-4f, 1e-4f, 1e-4f});
      EXPECT_EQ(trace.value, (i & 1) != 0 ? 1.0f : 0.0f) << i;
    }
  }
}

/// Octave i has ended when the pixel is half a cell of its lattice; nothing jumps on the way there.
TEST(Patterns, OctavesFadeBeforeTheyAlias) {
  Pattern noise;
  noise.kind = PatternKind::noise;
  noise.octaves = 6;
  const float at[3] = {1.3f, 2.7f, 3.1f};
  float before = 0.0f;
  for (int k = 0; k <= 400; ++k) {
    const float w = std::exp2(-8.0f + static_cast<float>(k) * 0.025f);
    const auto trace = reference::pattern_at(noise, at, {w, w, w});
    if (k > 0) {
      EXPECT_NEAR(trace.value, before, 0.02f) << w;
    }
    before = trace.value;
    for (int octave = 0; octave < 6; ++octave) {
      if (w * static_cast<float>(1 << octave) >= 0.5f) {
        EXPECT_LE(trace.noise, octave) << w;
      }
    }
  }
  EXPECT_EQ(before, 0.5f);
  EXPECT_EQ(reference::pattern_at(noise, at, {1e-3f, 1e-3f, 1e-3f}).noise, 6);
  EXPECT_EQ(reference::pattern_at(noise, at, {1e-3f, 1e-3f, 1e-3f}).octaves, 6.0f);
}

/// A distant marble keeps the mean of the turbulence that it can no longer show.
TEST(Patterns, FadedTurbulenceKeepsItsMean) {
  Pattern marble;
  marble.kind = PatternKind::marble;
  marble.octaves = 4;
  marble.turbulence = 0.5f;
  const auto far = reference::pattern_at(marble, {0.2f, 0.4f, 0.7f}, {9.0f, 1e-6f, 9.0f});
  EXPECT_EQ(far.noise, 0);
  EXPECT_NEAR(far.place, 0.4f + 0.5f * kMeanAbsoluteNoise * 1.875f, 1e-6f);
}

TEST(Patterns, AThresholdDividesInTwo) {
  Pattern noise;
  noise.kind = PatternKind::noise;
  noise.has_threshold = true;
  noise.threshold = 0.1f;
  std::mt19937 bits(4);
  for (int k = 0; k < 1000; ++k) {
    const auto number = [&] { return static_cast<float>(bits() >> 8) * (16.0f / 16777216.0f); };
    const float at[3] = {number(), number(), number()};
    const auto trace = reference::pattern_at(noise, at, {0, 0, 0});
    const float exact = perlin_noise(at[0], at[1], at[2]);
    if (std::fabs(exact - 0.1f) > 1e-5f) {
      EXPECT_EQ(trace.value, exact > 0.1f ? 1.0f : 0.0f);
    }
  }
}

}  // namespace
}  // namespace barrido::raster
