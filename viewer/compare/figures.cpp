#include "viewer/compare/figures.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace barrido::compare {
namespace {

using scene::StoredPicture;

/// What one row adds to the figures. Rows are summed up in their order, so that no thread decides a digit.
struct Row {
  double sum = 0.0, sum_of_squares = 0.0, max = 0.0;
  float peak = 1.0f;
  WorstPixel worst;
  std::uint64_t over_fail = 0, over_warn = 0, over_zero = 0, incomparable = 0;
};

bool has_color(const StoredPicture& picture) { return picture.channels >= 3; }
bool has_alpha(const StoredPicture& picture) { return picture.channels % 2 == 0; }

/// Which of R, G, B, A are compared: the union of what the files store. Grey counts once.
std::vector<int> compared_channels(const StoredPicture& a, const StoredPicture& b) {
  std::vector<int> channels{0};
  if (has_color(a) || has_color(b)) channels = {0, 1, 2};
  if (has_alpha(a) || has_alpha(b)) channels.push_back(3);
  return channels;
}

constexpr std::array<float, 4> kNothing{};

const float* pixel(const StoredPicture& picture, int x, int y) {
  if (x >= picture.width || y >= picture.height) return kNothing.data();
  const auto index =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x);
  return picture.rgba.data() + index * 4;
}

/// Values that are no numbers are alike when they are the same kind of none.
bool same_kind(float a, float b) { return (std::isnan(a) && std::isnan(b)) || a == b; }

/// The absolute difference; infinite where only one value is finite, or they are different infinities.
double difference(float a, float b) {
  if (std::isfinite(a) && std::isfinite(b)) return std::fabs(a - b);
  return same_kind(a, b) ? 0.0 : std::numeric_limits<double>::infinity();
}

void add_pixel(Row& row, const float* expected, const float* actual, std::span<const int> channels, int x,
               int y, const Thresholds& thresholds) {
  double largest = 0.0;
  for (const int c : channels) {
    const double d = difference(expected[c], actual[c]);
    largest = std::max(largest, d);
    if (d > row.max) {
      row.max = d;
      row.worst = {x, y, c, {}, {}};
      std::copy_n(expected, 4, row.worst.expected.begin());
      std::copy_n(actual, 4, row.worst.actual.begin());
    }
    if (!std::isfinite(d)) {
      ++row.incomparable;
      continue;
    }
    row.sum += d;
    row.sum_of_squares += d * d;
    if (std::isfinite(expected[c])) row.peak = std::max({row.peak, expected[c], actual[c]});
  }
  row.over_fail += largest > thresholds.fail ? 1 : 0;
  row.over_warn += largest > thresholds.warn ? 1 : 0;
  row.over_zero += largest > 0.0 ? 1 : 0;
}

}  // namespace

double Figures::psnr() const { return 20.0 * std::log10(peak / rms); }

Figures measure(const StoredPicture& expected, const StoredPicture& actual, const Thresholds& thresholds) {
  const std::vector<int> channels = compared_channels(expected, actual);
  const int width = std::max(expected.width, actual.width);
  const int height = std::max(expected.height, actual.height);
  std::vector<Row> rows(static_cast<std::size_t>(height));
  tbb::parallel_for(0, height, [&](int y) {
    Row& row = rows[static_cast<std::size_t>(y)];
    for (int x = 0; x < width; ++x) {
      add_pixel(row, pixel(expected, x, y), pixel(actual, x, y), channels, x, y, thresholds);
    }
  });

  Figures figures;
  figures.channels = static_cast<int>(channels.size());
  figures.pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  double sum = 0.0, sum_of_squares = 0.0;
  for (const Row& row : rows) {
    sum += row.sum;
    sum_of_squares += row.sum_of_squares;
    figures.peak = std::max(figures.peak, static_cast<double>(row.peak));
    figures.over_fail += row.over_fail;
    figures.over_warn += row.over_warn;
    figures.over_zero += row.over_zero;
    figures.incomparable += row.incomparable;
    if (row.max > figures.max) {
      figures.max = row.max;
      figures.worst = row.worst;
    }
  }
  const double values = static_cast<double>(figures.pixels) * static_cast<double>(channels.size());
  figures.mean = sum / values;
  figures.rms = std::sqrt(sum_of_squares / values);
  // Of the values that are left a mean would look as if all were well.
  if (figures.incomparable > 0) figures.mean = figures.rms = std::numeric_limits<double>::quiet_NaN();
  return figures;
}

Verdict judge(const Figures& figures, const Thresholds& thresholds) {
  const auto pixels = static_cast<double>(figures.pixels);
  const auto failing = static_cast<double>(figures.over_fail);
  const auto warning = static_cast<double>(figures.over_warn);
  const double may_fail =
      std::max(thresholds.fail_percent / 100.0 * pixels, static_cast<double>(thresholds.allow_failures));
  if (failing > may_fail || figures.max > thresholds.hard_fail) return Verdict::different;
  const bool warned =
      warning > thresholds.warn_percent / 100.0 * pixels || figures.max > thresholds.hard_warn;
  return warned ? Verdict::warning : Verdict::same;
}

const char* channels_name(int channels) {
  constexpr const char* kNames[] = {"grey", "grey and alpha", "RGB", "RGBA"};
  return kNames[std::clamp(channels, 1, 4) - 1];
}

}  // namespace barrido::compare
