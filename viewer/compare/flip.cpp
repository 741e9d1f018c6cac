#include "viewer/compare/flip.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/pictures/transfer.h"
#include "viewer/compare/flip_band.h"
#include "viewer/compare/flip_exposure.h"

namespace barrido::compare {
namespace {

using scene::StoredPicture;

/// Rows that are computed together: enough that those around them do not cost much.
constexpr int kBandRows = 64;
constexpr float kGrey = 127.5f / 255.0f;

/// Linear light of an sRGB code; the 256 codes of bytes come from a table.
float linear_of_code(float code) {
  static const auto table = [] {
    std::array<float, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = scene::linear_from_srgb(static_cast<float>(i) / 255.0f);
    return values;
  }();
  const float clamped = code > 0.0f ? std::min(code, 1.0f) : 0.0f;
  const float byte = clamped * 255.0f;
  const auto nearest = static_cast<std::size_t>(byte + 0.5f);
  return std::fabs(byte - static_cast<float>(nearest)) < 1e-4f ? table[nearest]
                                                               : scene::linear_from_srgb(clamped);
}

const float* row_of(const StoredPicture& picture, int y) {
  return picture.rgba.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) * 4;
}

/// Fractions, over grey where they are transparent.
RowReader fractions_of(const StoredPicture& picture, int width) {
  return [&picture, width](int y, const LinearRow& row) {
    const float* rgba = row_of(picture, y);
    const auto seen = [&](float code, float alpha) {
      if (alpha == 1.0f) return linear_of_code(code);
      return linear_of_code((picture.is_associated ? code : code * alpha) + kGrey * (1.0f - alpha));
    };
    for (int x = 0; x < width; ++x, rgba += 4) {
      row.red[x] = seen(rgba[0], rgba[3]);
      row.green[x] = seen(rgba[1], rgba[3]);
      row.blue[x] = seen(rgba[2], rgba[3]);
    }
  };
}

/// Floats, over black where they are transparent, at one exposure.
RowReader radiances_of(const StoredPicture& picture, int width, float gain) {
  return [&picture, width, gain](int y, const LinearRow& row) {
    const float* rgba = row_of(picture, y);
    for (int x = 0; x < width; ++x, rgba += 4) {
      const float alpha = picture.is_associated ? 1.0f : rgba[3];
      const Triple mapped = tone_mapped({rgba[0] * alpha, rgba[1] * alpha, rgba[2] * alpha}, gain);
      row.red[x] = mapped.x;
      row.green[x] = mapped.y;
      row.blue[x] = mapped.z;
    }
  };
}

/// The greatest of what is there and the errors between `expected` and `actual`.
void add_errors(FlipMap& map, const RowReader& expected, const RowReader& actual) {
  static const FlipFilters filters = make_flip_filters(kPixelsPerDegree);
  const int bands = (map.height + kBandRows - 1) / kBandRows;
  tbb::parallel_for(0, bands, [&](int index) {
    const Band band{map.width, map.height, index * kBandRows, std::min((index + 1) * kBandRows, map.height)};
    const auto width = static_cast<std::size_t>(map.width);
    std::vector<float> errors(width * static_cast<std::size_t>(band.end - band.begin));
    flip_band(band, filters, expected, actual, errors);
    float* out = map.errors.data() + static_cast<std::size_t>(band.begin) * width;
    for (std::size_t i = 0; i < errors.size(); ++i) out[i] = std::max(out[i], errors[i]);
  });
}

/// The error with half of the sum of all errors below it, to 1/65536.
double weighted_median(const std::vector<float>& errors, double sum) {
  constexpr std::size_t kBuckets = 65536;
  std::vector<double> sums(kBuckets, 0.0);
  for (const float error : errors) {
    sums[std::min(static_cast<std::size_t>(error * kBuckets), kBuckets - 1)] += static_cast<double>(error);
  }
  double below = 0.0;
  for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) {
    below += sums[bucket];
    if (below > 0.5 * sum) return (static_cast<double>(bucket) + 0.5) / kBuckets;
  }
  return 0.0;
}

/// What is no number cannot be looked at: beside something else it is as wrong as can be.
void add_missing_numbers(FlipMap& map, const StoredPicture& expected, const StoredPicture& actual) {
  const auto is_wrong = [](float a, float b) {
    if (std::isfinite(a) && std::isfinite(b)) return false;
    return !(a == b) && !(std::isnan(a) && std::isnan(b));
  };
  tbb::parallel_for(0, map.height, [&](int y) {
    const float *a = row_of(expected, y), *b = row_of(actual, y);
    float* errors = map.errors.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width);
    for (int x = 0; x < map.width; ++x, a += 4, b += 4) {
      for (int c = 0; c < 4; ++c) {
        if (is_wrong(a[c], b[c])) errors[x] = 1.0f;
      }
    }
  });
}

void add_figures(FlipMap& map) {
  double sum = 0.0;
  for (const float error : map.errors) sum += static_cast<double>(error);
  FlipFigures& figures = map.figures;
  figures.mean = sum / static_cast<double>(map.errors.size());
  figures.weighted_median = weighted_median(map.errors, sum);
  const auto largest = std::max_element(map.errors.begin(), map.errors.end());
  const auto index = static_cast<int>(largest - map.errors.begin());
  figures.max = static_cast<double>(*largest);
  figures.max_x = index % map.width;
  figures.max_y = index / map.width;
}

}  // namespace

FlipMap flip(const StoredPicture& expected, const StoredPicture& actual) {
  FlipMap map;
  map.width = std::min(expected.width, actual.width);
  map.height = std::min(expected.height, actual.height);
  map.errors.resize(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height));
  if (expected.is_linear) {
    const FlipFigures::Exposures exposures = choose_exposures(expected);
    const double step = (exposures.stop - exposures.start) / (exposures.count - 1);
    for (int i = 0; i < exposures.count; ++i) {
      const auto stops = static_cast<float>(exposures.start + i * step);
      const float gain = portable_exp2(stops);
      add_errors(map, radiances_of(expected, map.width, gain), radiances_of(actual, map.width, gain));
    }
    map.figures.exposures = exposures;
  } else {
    add_errors(map, fractions_of(expected, map.width), fractions_of(actual, map.width));
  }
  add_missing_numbers(map, expected, actual);
  add_figures(map);
  return map;
}

}  // namespace barrido::compare
