#include "raster/tiles/pixel_places.h"

#include <algorithm>
#include <cmath>

#include "raster/tiles/sample_pattern.h"

namespace barrido::raster {

PlaceCell place_cell(int number, int count, float radius) {
  const SquareCell cell = square_cell(number, count);
  const double scale = 2.0 * static_cast<double>(radius) * 65536.0;
  const double corner = (0.5 - static_cast<double>(radius)) * 65536.0;
  const auto whole = [&](double share) {
    return static_cast<std::int32_t>(std::floor(corner + scale * share + 0.5));
  };
  const std::int32_t x = whole(cell.x_begin);
  const std::int32_t y = whole(cell.y_begin);
  return {x, y, static_cast<std::uint32_t>(whole(cell.x_end) - x),
          static_cast<std::uint32_t>(whole(cell.y_end) - y)};
}

PlaceWeights::PlaceWeights(const PixelFilter& filter) : filter_(filter) {
  if (filter.kind == PixelFilterKind::box || filter.kind == PixelFilterKind::cone) return;
  reach_ = static_cast<int>(std::ceil(filter.radius * kSubpixelUnits)) + 1;
  // f(x, 0)/√f(0, 0) is the one of either axis: their products are f(x, y).
  const double middle = std::sqrt(filter_value(filter, 0.0, 0.0));
  for (int i = -reach_; i <= reach_; ++i) {
    const double value = filter_value(filter, static_cast<double>(i) / kSubpixelUnits, 0.0) / middle;
    along_.push_back(static_cast<float>(value));
  }
}

float PlaceWeights::cone(int x, int y) const {
  constexpr float kUnit = 1.0f / kSubpixelUnits;
  const float squared = static_cast<float>(x * x + y * y) * (kUnit * kUnit);
  return std::max(0.0f, 1.0f - std::sqrt(squared) / filter_.radius);
}

}  // namespace barrido::raster
