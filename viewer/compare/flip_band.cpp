#include "viewer/compare/flip_band.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "raster/base/portable_math.h"
#include "viewer/compare/flip_color.h"

namespace barrido::compare {
namespace {

using Row = std::vector<float>;

/// What is left of a row after filtering along it.
enum Plane : std::size_t { kY, kCx, kCz, kCzWide, kSmooth, kSlope, kBend, kPlanes };

/// `out`[x] = Σ weight·in[x + i]; `in` has `padding` more values on both sides.
void filter_along(const Row& in, int padding, const Kernel& kernel, Row& out) {
  std::fill(out.begin(), out.end(), 0.0f);
  float* result = out.data();
  const std::size_t width = out.size();
  for (std::size_t tap = 0; tap < kernel.weights.size(); ++tap) {
    const float weight = kernel.weights[tap];
    const float* from = in.data() + static_cast<std::size_t>(padding - kernel.radius) + tap;
    for (std::size_t x = 0; x < width; ++x) result[x] += weight * from[x];
  }
}

/// Repeats the outermost values of a row that stands in the middle of `padded`.
void repeat_ends(Row& padded, int padding) {
  const auto inner = static_cast<std::ptrdiff_t>(padding);
  std::fill(padded.begin(), padded.begin() + inner, padded[static_cast<std::size_t>(padding)]);
  std::fill(padded.end() - inner, padded.end(),
            padded[padded.size() - static_cast<std::size_t>(padding) - 1]);
}

/// One picture's rows of a band and around it, filtered along the rows.
class FilteredRows {
 public:
  FilteredRows(const Band& band, const FlipFilters& filters, const RowReader& read)
      : band_(band), first_(std::max(0, band.begin - filters.max_radius())) {
    const int end = std::min(band.height, band.end + filters.max_radius());
    const int padding = filters.max_radius();
    const auto width = static_cast<std::size_t>(band.width);
    std::array<Row, 3> rgb{Row(width), Row(width), Row(width)};
    std::array<Row, 4> padded;  // Y, Cx, Cz, and Y in 0..1 for the features
    for (Row& row : padded) row.resize(width + 2 * static_cast<std::size_t>(padding));
    for (int y = first_; y < end; ++y) {
      read(y, {rgb[0].data(), rgb[1].data(), rgb[2].data()});
      to_opponents(rgb, padded, padding);
      filter_row(padded, padding, filters);
    }
  }

  /// Σ weight·row[y + i] of a plane.
  void filter_across(Plane plane, int y, const Kernel& kernel, Row& out) const {
    std::fill(out.begin(), out.end(), 0.0f);
    add_across(plane, y, kernel, out);
  }

  void add_across(Plane plane, int y, const Kernel& kernel, Row& out) const {
    float* result = out.data();
    const std::size_t width = out.size();
    for (int i = -kernel.radius; i <= kernel.radius; ++i) {
      const float weight = kernel.weights[static_cast<std::size_t>(i + kernel.radius)];
      const int row = std::clamp(y + i, 0, band_.height - 1) - first_;
      const float* from = rows_[static_cast<std::size_t>(row)][plane].data();
      for (std::size_t x = 0; x < width; ++x) result[x] += weight * from[x];
    }
  }

 private:
  static void to_opponents(const std::array<Row, 3>& rgb, std::array<Row, 4>& padded, int padding) {
    for (std::size_t x = 0; x < rgb[0].size(); ++x) {
      const Triple opponents = ycxcz_from_linear({rgb[0][x], rgb[1][x], rgb[2][x]});
      const std::size_t at = x + static_cast<std::size_t>(padding);
      padded[0][at] = opponents.x;
      padded[1][at] = opponents.y;
      padded[2][at] = opponents.z;
      padded[3][at] = (opponents.x + 16.0f) / 116.0f;
    }
    for (Row& row : padded) repeat_ends(row, padding);
  }

  void filter_row(const std::array<Row, 4>& padded, int padding, const FlipFilters& filters) {
    auto& planes = rows_.emplace_back();
    for (Row& plane : planes) plane.resize(static_cast<std::size_t>(band_.width));
    filter_along(padded[0], padding, filters.achromatic, planes[kY]);
    filter_along(padded[1], padding, filters.red_green, planes[kCx]);
    filter_along(padded[2], padding, filters.blue_yellow, planes[kCz]);
    filter_along(padded[2], padding, filters.blue_yellow_wide, planes[kCzWide]);
    filter_along(padded[3], padding, filters.gaussian, planes[kSmooth]);
    filter_along(padded[3], padding, filters.edge, planes[kSlope]);
    filter_along(padded[3], padding, filters.point, planes[kBend]);
  }

  Band band_;
  int first_;
  std::vector<std::array<Row, kPlanes>> rows_;
};

/// One row as the eye gets it: colours, and how much of an edge or a point is at each pixel.
struct Seen {
  Row y, cx, cz, edge, point;
  Row across, along;  // Scratch.

  explicit Seen(std::size_t width)
      : y(width), cx(width), cz(width), edge(width), point(width), across(width), along(width) {}

  void look(const FilteredRows& rows, int row, const FlipFilters& filters) {
    rows.filter_across(kY, row, filters.achromatic, y);
    rows.filter_across(kCx, row, filters.red_green, cx);
    rows.filter_across(kCz, row, filters.blue_yellow, cz);
    rows.add_across(kCzWide, row, filters.blue_yellow_wide, cz);
    find(rows, row, kSlope, filters.gaussian, filters.edge, edge);
    find(rows, row, kBend, filters.gaussian, filters.point, point);
  }

 private:
  /// The length of the two derivatives, along the row and across it.
  void find(const FilteredRows& rows, int row, Plane derived, const Kernel& gaussian,
            const Kernel& derivative, Row& feature) {
    rows.filter_across(derived, row, gaussian, along);
    rows.filter_across(kSmooth, row, derivative, across);
    for (std::size_t x = 0; x < feature.size(); ++x) {
      feature[x] = std::sqrt(along[x] * along[x] + across[x] * across[x]);
    }
  }
};

/// Both errors in one: features raise the error of colours (section 4.3), e = c^(1 − f).
void combine(const Seen& a, const Seen& b, float* errors) {
  constexpr float kHalfRoot = 0.70710678f;  // 1/√2
  for (std::size_t x = 0; x < a.y.size(); ++x) {
    const float color = color_error(hunt_lab_from_ycxcz({a.y[x], a.cx[x], a.cz[x]}),
                                    hunt_lab_from_ycxcz({b.y[x], b.cx[x], b.cz[x]}));
    const float larger = std::max(std::fabs(a.edge[x] - b.edge[x]), std::fabs(a.point[x] - b.point[x]));
    const float feature = std::min(std::sqrt(kHalfRoot * larger), 1.0f);  // q_f = 0.5
    errors[x] = std::min(portable_pow(color, 1.0f - feature), 1.0f);
  }
}

}  // namespace

void flip_band(const Band& band, const FlipFilters& filters, const RowReader& expected,
               const RowReader& actual, std::span<float> errors) {
  const auto width = static_cast<std::size_t>(band.width);
  const FilteredRows expected_rows(band, filters, expected), actual_rows(band, filters, actual);
  Seen expected_seen(width), actual_seen(width);
  for (int y = band.begin; y < band.end; ++y) {
    expected_seen.look(expected_rows, y, filters);
    actual_seen.look(actual_rows, y, filters);
    combine(expected_seen, actual_seen, errors.data() + static_cast<std::size_t>(y - band.begin) * width);
  }
}

}  // namespace barrido::compare
