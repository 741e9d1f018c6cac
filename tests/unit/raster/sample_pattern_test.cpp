// Patterns of samples and their filters: integrals and responses against closed forms, what a grid and what
// jitter make of frequencies above the grid's, how fast errors fall, and that hashes are spread evenly.
#include "raster/tiles/sample_pattern.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>
#include <set>

#include "raster/base/hash.h"
#include "raster/tiles/pixel_places.h"

namespace barrido::raster {
namespace {

constexpr double kPi = 3.14159265358979323846;

double unit(std::int32_t place) { return static_cast<double>(place - kSubpixelUnits / 2) / kSubpixelUnits; }

/// What is left of a wave of `f` cycles a pixel along x.
double response(const std::vector<Sample>& samples, double f) {
  std::complex<double> sum = 0.0;
  double weight = 0.0;
  for (const Sample& s : samples) {
    sum += static_cast<double>(s.weight) * std::polar(1.0, 2.0 * kPi * f * unit(s.place.x));
    weight += static_cast<double>(s.weight);
  }
  return sum.real() / weight;
}

struct FilterRow {
  PixelFilter filter;
  double integral;
  double at[5];  ///< Responses to 1/8, 1/4, 1/2, 3/4 and 1 cycle a pixel.
};

const FilterRow kRows[] = {
    {{PixelFilterKind::box, 0.5f}, 1.0, {0.97450, 0.90032, 0.63662, 0.30011, 0.0}},
    {{PixelFilterKind::triangle, 1.0f}, 1.0, {0.94964, 0.81057, 0.40528, 0.09006, 0.0}},
    {{PixelFilterKind::gaussian, 1.5f}, 0.942276, {0.93148, 0.75085, 0.30476, 0.06102, 0.00893}},
    {{PixelFilterKind::mitchell, 2.0f}, 1.0, {0.96427, 0.84502, 0.38326, 0.04441, 0.0}},
    {{PixelFilterKind::cone, 1.0f}, kPi / 3, {0.95458, 0.82800, 0.44572, 0.11652, -0.01511}},
    {{PixelFilterKind::cone, 1.5f}, kPi * 0.75, {0.90011, 0.64657, 0.11652, -0.01942, 0.02079}},
};
constexpr double kFrequencies[] = {0.125, 0.25, 0.5, 0.75, 1.0};

TEST(PixelFilter, IntegralsAndResponsesAreTheClosedForms) {
  for (const FilterRow& row : kRows) {
    const auto kind = static_cast<int>(row.filter.kind);
    EXPECT_NEAR(filter_integral(row.filter), row.integral, 1e-5) << kind;
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_NEAR(filter_response(row.filter, kFrequencies[i]), row.at[i], 2e-4) << kind << " " << i;
    }
  }
  EXPECT_NEAR(filter_integral({PixelFilterKind::gaussian, 1.0f}), 0.545435, 1e-6);
  EXPECT_NEAR(filter_integral({PixelFilterKind::gaussian, 2.0f}), 0.997733, 1e-6);
}

TEST(SamplePattern, GridsHaveTheFiltersResponse) {
  for (const FilterRow& row : kRows) {
    const std::vector<Sample> samples = uniform_samples(256, row.filter);
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_NEAR(response(samples, kFrequencies[i]), row.at[i], 0.005)
          << static_cast<int>(row.filter.kind) << " at " << kFrequencies[i];
    }
  }
}

/// Four along x: waves of four cycles a pixel come back at full strength.
TEST(SamplePattern, AGridShowsItsAlias) {
  const std::vector<Sample> grid = uniform_samples(16, {});
  EXPECT_NEAR(response(grid, 0.5), 0.65328, 1e-5);
  EXPECT_NEAR(response(grid, 1.5), -0.2706, 1e-4);
  for (const double f : {1.0, 2.0, 3.0}) EXPECT_NEAR(response(grid, f), 0.0, 1e-9) << f;
  EXPECT_NEAR(std::abs(response(grid, 4.0)), 1.0, 1e-9);
}

/// Over many pixels the mean is the box filter's, above the grid's frequency too.
TEST(SamplePattern, JitterShowsNoAlias) {
  double sum = 0.0;
  constexpr int kPixels = 4000;
  for (int sample = 0; sample < 16; ++sample) {
    const PlaceCell cell = place_cell(sample, 16, 0.5f);
    const std::uint32_t key = hash_of(static_cast<std::uint32_t>(sample), 3u);
    for (int pixel = 0; pixel < kPixels; ++pixel) {
      const SamplePlace place = place_in(cell, pixel % 200, pixel / 200, key);
      EXPECT_GE(place.x, sample % 4 * 64);
      EXPECT_LT(place.x, sample % 4 * 64 + 64);
      EXPECT_GE(place.y, sample / 4 * 64);
      EXPECT_LT(place.y, sample / 4 * 64 + 64);
      sum += std::cos(2.0 * kPi * 4.0 * unit(place.x));
    }
  }
  EXPECT_NEAR(sum / (16.0 * kPixels), 0.0, 0.02);
}

/// Root of the mean square error of the area right of random edges through the pixel.
template <class Places>
double edge_error(int count, const Places& places) {
  std::mt19937 engine(11);
  const auto random = [&] { return std::ldexp(static_cast<double>(engine()), -32); };
  double squares = 0.0;
  constexpr int kEdges = 3000;
  for (int edge = 0; edge < kEdges; ++edge) {
    const double angle = 2.0 * kPi * random(), distance = 0.5 * random();
    const double nx = std::cos(angle), ny = std::sin(angle);
    const auto inside = [&](double x, double y) { return nx * x + ny * y > distance; };
    int exact = 0;
    constexpr int kFine = 64;
    for (int i = 0; i < kFine * kFine; ++i) {
      exact += inside((i % kFine + 0.5) / kFine - 0.5, (i / kFine + 0.5) / kFine - 0.5);
    }
    int hits = 0;
    for (int i = 0; i < count; ++i) {
      const SamplePlace place = places(i, edge);
      hits += inside((place.x + 0.5) / kSubpixelUnits - 0.5, (place.y + 0.5) / kSubpixelUnits - 0.5);
    }
    const double error = static_cast<double>(hits) / count - static_cast<double>(exact) / (kFine * kFine);
    squares += error * error;
  }
  return std::log(squares / kEdges);
}

/// The mean square error of an edge falls as N⁻¹ for random places and N⁻³ᐟ² for one in each cell.
TEST(SamplePattern, ErrorsFallAsTheyMust) {
  const auto slope = [](auto error) { return (error(100) - error(9)) / std::log(100.0 / 9.0); };
  const auto jittered = [](int count) {
    return edge_error(count, [count](int i, int pixel) {
      return place_in(place_cell(i, count, 0.5f), pixel, 0, hash_of(static_cast<std::uint32_t>(i), 0u));
    });
  };
  const auto random = [](int count) {
    return edge_error(
        count, [](int i, int pixel) { return place_in(place_cell(0, 1, 0.5f), pixel, i, hash_of(0u, 0u)); });
  };
  EXPECT_NEAR(slope(jittered), -1.5, 0.12);
  EXPECT_NEAR(slope(random), -1.0, 0.1);
}

TEST(SamplePattern, AnyNumberHasCellsOfEqualArea) {
  for (const int count : {1, 2, 3, 5, 7, 12, 16, 37, 64, 1000}) {
    double covered = 0.0;
    for (int i = 0; i < count; ++i) {
      const SquareCell cell = square_cell(i, count);
      const double area = (cell.x_end - cell.x_begin) * (cell.y_end - cell.y_begin);
      EXPECT_NEAR(area, 1.0 / count, 1e-12) << count << " " << i;
      covered += area;
    }
    EXPECT_NEAR(covered, 1.0, 1e-9);
    EXPECT_EQ(uniform_samples(count, {}).size(), static_cast<std::size_t>(count));
  }
  EXPECT_THROW(uniform_samples(0, {}), std::invalid_argument);
  const std::vector<Sample> one = uniform_samples(1, {PixelFilterKind::mitchell, 2.0f});
  EXPECT_EQ(one[0].place, SamplePlace{});
}

/// Each stretch of time and each cell of the lens once, for any number.
TEST(SamplePattern, TimeAndLensAreSpreadEvenly) {
  for (const int count : {1, 2, 6, 16, 37, 100}) {
    for (const bool random : {false, true}) {
      std::set<int> stretches;
      double x = 0.0, y = 0.0, squares = 0.0;
      for (int i = 0; i < count; ++i) {
        const SampleMoment moment = sample_moment(i, count, 9, random);
        stretches.insert(static_cast<int>(moment.time * count));
        x += moment.lens_x / count;
        y += moment.lens_y / count;
        squares += (moment.lens_x * moment.lens_x + moment.lens_y * moment.lens_y) / count;
      }
      EXPECT_EQ(stretches.size(), static_cast<std::size_t>(count)) << count;
      if (count < 16) continue;
      EXPECT_NEAR(x, 0.0, 0.1);
      EXPECT_NEAR(y, 0.0, 0.1);
      EXPECT_NEAR(squares, 0.5, 0.07);  // of a disc of radius 1; middles of cells are a little less
    }
  }
}

TEST(Hash, PermutationsAreOneToOne) {
  for (const std::uint32_t count : {1u, 2u, 3u, 16u, 37u, 4096u}) {
    std::set<std::uint32_t> seen;
    for (std::uint32_t i = 0; i < count; ++i) seen.insert(permuted(i, count, 77));
    EXPECT_EQ(seen.size(), count);
    EXPECT_LT(*seen.rbegin(), count);
  }
}

/// Pearson's test over the places of neighbouring pixels.
TEST(Hash, PlacesAreSpreadEvenly) {
  constexpr int kCells = 16, kSide = 512;
  std::vector<int> counts(kCells * kCells);
  for (int pixel = 0; pixel < kSide * kSide; ++pixel) {
    const SamplePlace place = place_in(place_cell(0, 1, 0.5f), pixel % kSide, pixel / kSide, hash_of(0u, 1u));
    ++counts[static_cast<std::size_t>(place.y / 16 * kCells + place.x / 16)];
  }
  const double expected = static_cast<double>(kSide) * kSide / (kCells * kCells);
  double chi = 0.0;
  for (const int count : counts) chi += (count - expected) * (count - expected) / expected;
  EXPECT_GT(chi, 180.0);  // 255 degrees of freedom: within some three and a half deviations
  EXPECT_LT(chi, 340.0);
}

}  // namespace
}  // namespace barrido::raster
