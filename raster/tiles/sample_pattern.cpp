#include "raster/tiles/sample_pattern.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "raster/base/hash.h"
#include "raster/base/portable_math.h"

namespace barrido::raster {
namespace {

/// What of a sample a random number is for.
enum Purpose : std::uint32_t { kTimeOrder = 1, kTimePlace, kLensOrder, kLensX, kLensY };

/// From the unit square to the unit disc: squares become discs, areas keep their ratios (Shirley and Chiu
/// 1997).
void to_disc(double x, double y, SampleMoment& moment) {
  const double a = 2.0 * x - 1.0;
  const double b = 2.0 * y - 1.0;
  if (a == 0.0 && b == 0.0) return;
  const bool is_wide = std::abs(a) > std::abs(b);
  const double radius = is_wide ? a : b;
  const double angle = is_wide ? kPi / 4.0 * (b / a) : kPi / 2.0 - kPi / 4.0 * (a / b);
  moment.lens_x = radius * portable_cos(angle);
  moment.lens_y = radius * portable_sin(angle);
}

/// Nearest multiple of 1/256, halves away from 0: what is symmetric stays so.
std::int32_t to_units(double pixels) {
  const double units = pixels * kSubpixelUnits;
  return static_cast<std::int32_t>(units < 0.0 ? -std::floor(0.5 - units) : std::floor(units + 0.5));
}

}  // namespace

SquareCell square_cell(int number, int count) {
  const int rows = std::max(1, static_cast<int>(std::floor(std::sqrt(static_cast<double>(count)) + 0.5)));
  // Row r has cells [r·count/rows, (r + 1)·count/rows).
  const auto begin_of = [&](int row) {
    return static_cast<int>(static_cast<std::int64_t>(row) * count / rows);
  };
  int row = static_cast<int>(static_cast<std::int64_t>(number) * rows / count);
  while (begin_of(row + 1) <= number) ++row;
  const int begin = begin_of(row);
  const int length = begin_of(row + 1) - begin;
  const double all = count;
  return {static_cast<double>(number - begin) / length, static_cast<double>(number - begin + 1) / length,
          begin / all, (begin + length) / all};
}

std::vector<Sample> uniform_samples(int count, const PixelFilter& filter) {
  if (count < 1) throw std::invalid_argument("a pixel needs at least one sample");
  const double r = static_cast<double>(filter.radius);
  std::vector<Sample> samples;
  bool any = false;
  for (int i = 0; i < count; ++i) {
    const SquareCell cell = square_cell(i, count);
    const std::int32_t x = to_units(r * (cell.x_begin + cell.x_end - 1.0));
    const std::int32_t y = to_units(r * (cell.y_begin + cell.y_end - 1.0));
    const double weight = filter_value(filter, static_cast<double>(x) / kSubpixelUnits,
                                       static_cast<double>(y) / kSubpixelUnits);
    any = any || weight != 0.0;
    samples.push_back({{kSubpixelUnits / 2 + x, kSubpixelUnits / 2 + y}, static_cast<float>(weight)});
  }
  if (!any || !(total_weight(samples) > 0.0f)) {
    for (Sample& sample : samples) sample.weight = 1.0f;
  }
  return samples;
}

float total_weight(const std::vector<Sample>& samples) {
  float total = 0.0f;
  for (const Sample& sample : samples) total += sample.weight;
  return total;
}

SampleMoment sample_moment(int number, int count, std::uint32_t seed, bool random) {
  const auto n = static_cast<std::uint32_t>(number);
  const auto all = static_cast<std::uint32_t>(count);
  const auto place = [&](Purpose purpose, double begin, double end) {
    const double share = random ? static_cast<double>(unit_float(hash_of(seed, purpose, n))) : 0.5;
    return begin + (end - begin) * share;
  };
  SampleMoment moment;
  const double time = permuted(n, all, hash_of(seed, kTimeOrder));
  moment.time = place(kTimePlace, time / all, (time + 1.0) / all);
  const SquareCell cell = square_cell(static_cast<int>(permuted(n, all, hash_of(seed, kLensOrder))), count);
  to_disc(place(kLensX, cell.x_begin, cell.x_end), place(kLensY, cell.y_begin, cell.y_end), moment);
  return moment;
}

}  // namespace barrido::raster
