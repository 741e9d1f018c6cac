#include "pipeline/scene/subdivision.h"

#include <algorithm>
#include <unordered_map>

namespace barrido::scene {

TriangleGrid::TriangleGrid(int n) : pieces(n) {
  const auto side = static_cast<std::uint32_t>(n);
  // Row j lies j parts towards corner 1; along it the parts go from corner 0 to corner 2.
  for (std::uint32_t j = 0; j <= side; ++j) {
    for (std::uint32_t k = 0; j + k <= side; ++k) points.push_back({{side - j - k, j, k}});
  }
  std::uint32_t row = 0;
  for (std::uint32_t j = 0; j < side; ++j) {
    const std::uint32_t in_row = side - j + 1;
    for (std::uint32_t k = 0; j + k < side; ++k) {
      const std::uint32_t here = row + k, above = row + in_row + k;
      triangles.push_back({here, above, here + 1});
      if (j + k + 1 < side) triangles.push_back({here + 1, above, above + 1});
    }
    row += in_row;
  }
}

FinePoints::FinePoints(std::span<const std::uint32_t> corner_class, std::uint32_t classes, int pieces)
    : corner_class_(corner_class), pieces_(static_cast<std::uint32_t>(pieces)), classes_(classes) {
  std::unordered_map<std::uint64_t, std::uint32_t> numbers;
  edge_.resize(corner_class.size());
  for (std::size_t c = 0; c < corner_class.size(); ++c) {
    const std::size_t next = c % 3 == 2 ? c - 2 : c + 1;
    const auto [low, high] = std::minmax(corner_class[c], corner_class[next]);
    const std::uint64_t key = static_cast<std::uint64_t>(low) << 32 | high;
    edge_[c] = numbers.try_emplace(key, static_cast<std::uint32_t>(numbers.size())).first->second;
  }
  edges_ = static_cast<std::uint32_t>(numbers.size());
  const std::uint32_t inside = (pieces_ - 1) * (pieces_ - 2) / 2;
  count_ = classes_ + edges_ * (pieces_ - 1) + static_cast<std::uint32_t>(corner_class.size() / 3) * inside;
}

/// `steps` from corner `from` towards the next.
std::uint32_t FinePoints::edge_point(std::size_t t, std::size_t from, std::uint32_t steps) const {
  const std::uint32_t a = corner_class_[3 * t + from];
  const std::uint32_t b = corner_class_[3 * t + (from + 1) % 3];
  if (a == b) return a;  // An edge without length is one point.
  const std::uint32_t from_lower = a < b ? steps : pieces_ - steps;
  return classes_ + edge_[3 * t + from] * (pieces_ - 1) + from_lower - 1;
}

std::uint32_t FinePoints::number(std::size_t t, const GridPoint& point) const {
  const std::uint32_t(&w)[3] = point.weight;
  for (std::size_t k = 0; k < 3; ++k) {
    if (w[k] == pieces_) return corner_class_[3 * t + k];
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (w[k] == 0) return edge_point(t, (k + 1) % 3, w[(k + 2) % 3]);
  }
  const std::uint32_t rows_before = (w[1] - 1) * (pieces_ - 1) - (w[1] - 1) * w[1] / 2;
  const std::uint32_t inside = (pieces_ - 1) * (pieces_ - 2) / 2;
  return classes_ + edges_ * (pieces_ - 1) + static_cast<std::uint32_t>(t) * inside + rows_before + w[2] - 1;
}

}  // namespace barrido::scene
