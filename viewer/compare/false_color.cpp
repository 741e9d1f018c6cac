#include "viewer/compare/false_color.h"

#include <algorithm>
#include <cmath>

#include "pipeline/pictures/transfer.h"

namespace barrido::compare {
namespace {

/// Hue in degrees and chroma of the colours, at even steps of lightness; chosen so that all lie in sRGB.
struct Station {
  double chroma, hue_deg;
};
constexpr std::array<Station, 9> kStations{
    {{0, 300}, {32, 302}, {55, 312}, {64, 328}, {66, 350}, {63, 20}, {51, 52}, {46, 82}, {30, 106}}};
constexpr double kMostLightness = 98.0;
constexpr int kSteps = 256;

double lab_inverse(double t) {
  constexpr double kDelta = 6.0 / 29.0;
  return t > kDelta ? t * t * t : 3.0 * kDelta * kDelta * (t - 4.0 / 29.0);
}

/// CIE Lab (D65) to sRGB bytes.
std::array<std::uint8_t, 3> bytes_from_lab(double lightness, double a, double b) {
  const double fy = (lightness + 16.0) / 116.0;
  const double x = 0.95047 * lab_inverse(fy + a / 500.0), y = lab_inverse(fy),
               z = 1.08883 * lab_inverse(fy - b / 200.0);
  const std::array<double, 3> linear{3.2404542 * x - 1.5371385 * y - 0.4985314 * z,
                                     -0.9692660 * x + 1.8760108 * y + 0.0415560 * z,
                                     0.0556434 * x - 0.2040259 * y + 1.0572252 * z};
  std::array<std::uint8_t, 3> bytes{};
  for (std::size_t c = 0; c < 3; ++c) bytes[c] = scene::srgb8_from_linear(static_cast<float>(linear[c]));
  return bytes;
}

std::array<std::uint8_t, 3> color_at(double error) {
  const double place = error * (kStations.size() - 1);
  const auto index = std::min(static_cast<std::size_t>(place), kStations.size() - 2);
  const double t = place - static_cast<double>(index);
  const auto ab = [&](const Station& station) {
    const double hue = radians(station.hue_deg);
    return std::array{station.chroma * portable_cos(hue), station.chroma * portable_sin(hue)};
  };
  const auto from = ab(kStations[index]), to = ab(kStations[index + 1]);
  return bytes_from_lab(kMostLightness * error, from[0] + t * (to[0] - from[0]),
                        from[1] + t * (to[1] - from[1]));
}

std::array<std::array<std::uint8_t, 3>, kSteps> make_table() {
  std::array<std::array<std::uint8_t, 3>, kSteps> table{};
  for (int i = 0; i < kSteps; ++i)
    table[static_cast<std::size_t>(i)] = color_at(static_cast<double>(i) / (kSteps - 1));
  return table;
}

}  // namespace

std::array<std::uint8_t, 3> false_color(float error) {
  static const auto table = make_table();
  const float clamped = error > 0.0f ? std::min(error, 1.0f) : 0.0f;
  return table[static_cast<std::size_t>(clamped * (kSteps - 1) + 0.5f)];
}

}  // namespace barrido::compare
