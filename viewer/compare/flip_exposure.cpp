#include "viewer/compare/flip_exposure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "raster/base/portable_math.h"

namespace barrido::compare {
namespace {

/// (k0 x² + k1 x) / (k3 x² + k4 x + k5): Narkowicz's fit with x times 0.6, which takes back its brightening.
constexpr float kNumerator2 = 0.6f * 0.6f * 2.51f, kNumerator1 = 0.6f * 0.03f;
constexpr float kDenominator2 = 0.6f * 0.6f * 2.43f, kDenominator1 = 0.6f * 0.59f, kDenominator0 = 0.14f;
/// Where the brightest pixel, or the median, shall come to.
constexpr double kTarget = 0.85;
constexpr float kBrightest = 1e15f;

/// The x whose tone-mapped value is kTarget: the greater root of a quadratic.
double radiance_of_target() {
  const double a = kNumerator2 - kTarget * kDenominator2, b = kNumerator1 - kTarget * kDenominator1,
               c = -kTarget * kDenominator0;
  return (-b + std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a);
}

double log2_of(double x) { return static_cast<double>(portable_log2(static_cast<float>(x))); }

float curve(float x) {
  const float value =
      (kNumerator2 * x * x + kNumerator1 * x) / (kDenominator2 * x * x + kDenominator1 * x + kDenominator0);
  return std::min(value, 1.0f);
}

}  // namespace

float usable_radiance(float value) { return value > 0.0f ? std::min(value, kBrightest) : 0.0f; }

FlipFigures::Exposures choose_exposures(const scene::StoredPicture& reference) {
  std::vector<float> luminances;
  luminances.reserve(reference.rgba.size() / 4);
  const auto finite = [](float value) { return std::isfinite(value) ? usable_radiance(value) : 0.0f; };
  for (std::size_t i = 0; i < reference.rgba.size(); i += 4) {
    luminances.push_back(
        luminance({finite(reference.rgba[i]), finite(reference.rgba[i + 1]), finite(reference.rgba[i + 2])}));
  }
  const auto middle = luminances.begin() + static_cast<std::ptrdiff_t>(luminances.size() / 2);
  std::nth_element(luminances.begin(), middle, luminances.end());
  // The median of a picture that is mostly black would be 0.
  const double median = std::max(*middle, std::numeric_limits<float>::epsilon());
  const double brightest =
      std::max(median, static_cast<double>(*std::max_element(luminances.begin(), luminances.end())));
  FlipFigures::Exposures exposures;
  exposures.start = log2_of(radiance_of_target() / brightest);
  exposures.stop = log2_of(radiance_of_target() / median);
  exposures.count = std::max(2, static_cast<int>(std::ceil(exposures.stop - exposures.start)));
  return exposures;
}

Triple tone_mapped(const Triple& rgb, float gain) {
  const auto mapped = [gain](float value) {
    return curve(std::min(usable_radiance(value) * gain, kBrightest));
  };
  return {mapped(rgb.x), mapped(rgb.y), mapped(rgb.z)};
}

}  // namespace barrido::compare
