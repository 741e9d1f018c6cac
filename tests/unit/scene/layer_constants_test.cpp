// Where the constants of the layers' conversion come from: computed here from what they stand for.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "pipeline/scene/material_conversion.h"

namespace barrido::scene {
namespace {

constexpr double kPi = std::numbers::pi;

/// Shadowing of the sheen's microfacets (A. Estevez, C. Kulla, "Production Friendly Microfacet Sheen BRDF",
/// SIGGRAPH 2017 course, section 3, with the table of its fit).
double sheen_lambda(double cosine, double alpha) {
  const double t = (1 - alpha) * (1 - alpha);
  const auto mix = [t](double rough, double smooth) { return t * rough + (1 - t) * smooth; };
  const auto fit = [&](double x) {
    return mix(25.3245, 21.5473) / (1 + mix(3.32435, 3.82987) * std::pow(x, mix(0.16801, 0.19823))) +
           mix(-1.27393, -1.97760) * x + mix(-4.85967, -4.32054);
  };
  return cosine < 0.5 ? std::exp(fit(cosine)) : std::exp(2 * fit(0.5) - fit(1 - cosine));
}

/// What the lobe sends back of light from everywhere, seen at this angle.
double sheen_albedo(double cos_view, double alpha) {
  constexpr int kSteps = 48;
  const double sin_view = std::sqrt(1 - cos_view * cos_view);
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double theta = (i + 0.5) / kSteps * kPi / 2;
    const double cos_light = std::cos(theta), sin_light = std::sin(theta);
    for (int k = 0; k < kSteps; ++k) {
      const double phi = (k + 0.5) / kSteps * kPi;  // the other half is the same again
      const double dot = sin_view * sin_light * std::cos(phi) + cos_view * cos_light;
      const double cos_half = (cos_view + cos_light) / std::sqrt(2 + 2 * dot);
      const double sin_half = std::sqrt(std::max(0.0, 1 - cos_half * cos_half));
      const double distribution = (2 + 1 / alpha) * std::pow(sin_half, 1 / alpha) / (2 * kPi);
      const double shadowing = 1 / (1 + sheen_lambda(cos_view, alpha) + sheen_lambda(cos_light, alpha));
      sum += distribution * shadowing / (4 * cos_view) * sin_light;
    }
  }
  return sum * 2 * (kPi / 2 / kSteps) * (kPi / kSteps);
}

TEST(LayerConstants, TheSheenSendsBackItsMean) {
  constexpr int kSteps = 12;
  double mean = 0.0;  // over all roughnesses, α = r², and over all directions by their cosine
  for (int r = 0; r < kSteps; ++r) {
    const double roughness = (r + 0.5) / kSteps;
    for (int v = 0; v < kSteps; ++v) {
      const double cosine = (v + 0.5) / kSteps;
      mean += 2 * cosine * sheen_albedo(cosine, roughness * roughness) / (kSteps * kSteps);
    }
  }
  EXPECT_NEAR(kSheenAlbedo, mean, 0.012) << mean;
}

/// CIE 1931, 2°, as sums of bells (C. Wyman, P.-P. Sloan, P. Shirley, "Simple Analytic Approximations to the
/// CIE XYZ Color Matching Functions", JCGT 2013).
std::array<double, 2> chromaticity_of(double nm) {
  const auto bell = [nm](double middle, double left, double right) {
    const double t = (nm - middle) * (nm < middle ? left : right);
    return std::exp(-0.5 * t * t);
  };
  const double x = 0.362 * bell(442.0, 0.0624, 0.0374) + 1.056 * bell(599.8, 0.0264, 0.0323) -
                   0.065 * bell(501.1, 0.0490, 0.0382);
  const double y = 0.821 * bell(568.8, 0.0213, 0.0247) + 0.286 * bell(530.9, 0.0613, 0.0322);
  const double z = 1.217 * bell(437.0, 0.0845, 0.0278) + 0.681 * bell(459.0, 0.0385, 0.0725);
  return {x / (x + y + z), y / (x + y + z)};
}

/// Where the line from white through a colour meets the colours of the spectrum.
double dominant_wavelength(double x, double y) {
  constexpr double kWhiteX = 0.3127, kWhiteY = 0.3290;  // D65
  double best = 0.0, least = 10.0;
  for (double nm = 440.0; nm < 640.0; nm += 0.1) {  // beyond, the spectrum hardly turns
    const auto [u, v] = chromaticity_of(nm);
    const double angle = std::atan2(v - kWhiteY, u - kWhiteX) - std::atan2(y - kWhiteY, x - kWhiteX);
    const double off = std::abs(std::remainder(angle, 2 * kPi));
    if (off < least) least = off, best = nm;
  }
  return best;
}

TEST(LayerConstants, FilmsAreLookedAtInTheWavelengthsOfThePrimaries) {
  const std::array<std::array<double, 2>, 3> primaries{{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}}};  // sRGB
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(kPrimaryWavelengthsNm[c], dominant_wavelength(primaries[c][0], primaries[c][1]), 1.5) << c;
  }
}

}  // namespace
}  // namespace barrido::scene
