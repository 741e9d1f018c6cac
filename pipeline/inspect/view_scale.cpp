#include "pipeline/inspect/view_scale.h"

#include <algorithm>
#include <cmath>

#include "pipeline/inspect/story_words.h"

namespace barrido::inspect {

double ViewScale::place_of(double value) const {
  if (is_signed) {
    // Thin bands are weak beside edges; a square root shows both.
    const double t = std::sqrt(std::min(std::abs(value) / most, 1.0));
    return value < 0.0 ? -t : t;
  }
  const double t = most > least ? (value - least) / (most - least) : 0.0;
  return square_root ? std::sqrt(std::max(t, 0.0)) : t;
}

double ViewScale::value_at(double t) const {
  if (is_signed) {
    const double place = 2.0 * t - 1.0;
    return place * std::abs(place) * most;
  }
  return least + (square_root ? t * t : t) * (most - least);
}

ViewScale scale_of(const ViewValues& values) {
  ViewScale scale;
  const auto on_both_sides_of_0 = [&](double limit, const char* below, const char* above) {
    scale.is_signed = true;
    scale.most = limit;
    scale.least = -limit;
    scale.least_word = below + (" " + number(scale.least));
    scale.most_word = "+" + number(scale.most) + " " + above;
    return scale;
  };
  switch (values.view) {
    case StructureView::mach_bands:
      return on_both_sides_of_0(kMachBandLimit, "light", "dark");
    case StructureView::texel_density:
      return on_both_sides_of_0(kDensityLimit, "magnified", "minified");
    case StructureView::depth:
      scale.least = values.least;
      scale.most = values.most;
      scale.least_word = number(scale.least) + " near";
      scale.most_word = number(scale.most) + " far";
      return scale;
    default:
      break;
  }
  scale.least = 0.0;
  scale.most = std::max(values.most, 1.0);
  scale.least_word = number(scale.least);
  scale.most_word = number(scale.most);
  // A pole where many vertices meet would leave all others dark.
  scale.square_root = values.view == StructureView::illuminations;
  return scale;
}

}  // namespace barrido::inspect
