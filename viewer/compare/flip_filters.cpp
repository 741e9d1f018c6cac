#include "viewer/compare/flip_filters.h"

#include <algorithm>
#include <cmath>

#include "raster/base/portable_math.h"

namespace barrido::compare {
namespace {

constexpr double kLog2E = 1.4426950408889634;

double exponential(double x) { return static_cast<double>(portable_exp2(static_cast<float>(x * kLog2E))); }

/// One of the Gaussians that the sensitivity to contrast is a sum of: a·√(π/b)·e^(−π²x²/b), x in degrees
/// (table 1).
struct Sensitivity {
  double a, b;
};
constexpr Sensitivity kAchromatic{1.0, 0.0047}, kRedGreen{1.0, 0.0053}, kBlueYellow{34.1, 0.04},
    kBlueYellowWide{13.5, 0.025};
constexpr double kWidestB = 0.04;
/// The width of what is found to be an edge, in degrees.
constexpr double kFeatureWidth = 0.082;

int sensitivity_radius(double pixels_per_degree) {
  return static_cast<int>(std::ceil(3.0 * std::sqrt(kWidestB / (2.0 * kPi * kPi)) * pixels_per_degree));
}

/// The square root of the Gaussian's height stands before each of the row and the column.
std::vector<double> gaussian_row(const Sensitivity& gaussian, int radius, double pixels_per_degree) {
  const double height = std::sqrt(gaussian.a * std::sqrt(kPi / gaussian.b));
  std::vector<double> row;
  for (int i = -radius; i <= radius; ++i) {
    const double x = i / pixels_per_degree;
    row.push_back(height * exponential(-kPi * kPi * x * x / gaussian.b));
  }
  return row;
}

double sum(const std::vector<double>& row) {
  double total = 0.0;
  for (const double weight : row) total += weight;
  return total;
}

/// `row` times `factor`, without outer weights that are too small to count.
Kernel kernel_of(const std::vector<double>& row, double factor) {
  constexpr double kNegligible = 1e-9;
  const double largest = std::fabs(*std::max_element(
      row.begin(), row.end(), [](double a, double b) { return std::fabs(a) < std::fabs(b); }));
  std::size_t skipped = 0;
  while (std::fabs(row[skipped]) < kNegligible * largest) ++skipped;
  Kernel kernel;
  kernel.radius = static_cast<int>(row.size() / 2 - skipped);
  for (std::size_t i = skipped; i < row.size() - skipped; ++i) {
    kernel.weights.push_back(static_cast<float>(row[i] * factor));
  }
  return kernel;
}

/// Positive weights add up to 1, negative ones to −1.
Kernel derivative_kernel(std::vector<double> row) {
  double positive = 0.0, negative = 0.0;
  for (const double weight : row) (weight > 0.0 ? positive : negative) += weight;
  for (double& weight : row) weight /= weight > 0.0 ? positive : -negative;
  Kernel kernel;
  kernel.radius = static_cast<int>(row.size() / 2);
  kernel.weights.assign(row.begin(), row.end());
  return kernel;
}

void add_feature_filters(FlipFilters& filters, double pixels_per_degree) {
  const double deviation = 0.5 * kFeatureWidth * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3.0 * deviation));
  std::vector<double> gaussian, first, second;
  for (int i = -radius; i <= radius; ++i) {
    const double t = i / deviation;
    const double g = exponential(-0.5 * t * t);
    gaussian.push_back(g);
    first.push_back(-i * g);
    second.push_back((t * t - 1.0) * g);
  }
  filters.gaussian = kernel_of(gaussian, 1.0 / sum(gaussian));
  filters.edge = derivative_kernel(first);
  filters.point = derivative_kernel(second);
}

}  // namespace

int FlipFilters::max_radius() const {
  return std::max({achromatic.radius, red_green.radius, blue_yellow.radius, blue_yellow_wide.radius,
                   gaussian.radius, edge.radius, point.radius});
}

FlipFilters make_flip_filters(double pixels_per_degree) {
  const int radius = sensitivity_radius(pixels_per_degree);
  const auto row = [&](const Sensitivity& gaussian) {
    return gaussian_row(gaussian, radius, pixels_per_degree);
  };
  const auto normalized = [&](const Sensitivity& gaussian) {
    return kernel_of(row(gaussian), 1.0 / sum(row(gaussian)));
  };
  FlipFilters filters;
  filters.achromatic = normalized(kAchromatic);
  filters.red_green = normalized(kRedGreen);
  // The two Gaussians together have the weight 1: the sum of both products of row and column.
  const double narrow = sum(row(kBlueYellow)), wide = sum(row(kBlueYellowWide));
  const double factor = 1.0 / std::sqrt(narrow * narrow + wide * wide);
  filters.blue_yellow = kernel_of(row(kBlueYellow), factor);
  filters.blue_yellow_wide = kernel_of(row(kBlueYellowWide), factor);
  add_feature_filters(filters, pixels_per_degree);
  return filters;
}

}  // namespace barrido::compare
