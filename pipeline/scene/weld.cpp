#include "pipeline/scene/weld.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace barrido::scene {

Welded weld(std::span<const float> values, std::size_t components) {
  const std::size_t count = values.size() / components;
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  // Compared as bits, which is a strict order even where a number is not one; + 0 makes −0 equal to 0.
  const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value + 0.0f); };
  const auto less = [&](std::uint32_t a, std::uint32_t b) {
    const float* left = values.data() + components * a;
    const float* right = values.data() + components * b;
    for (std::size_t c = 0; c < components; ++c) {
      if (bits(left[c]) != bits(right[c])) return bits(left[c]) < bits(right[c]);
    }
    return false;
  };
  std::stable_sort(order.begin(), order.end(), less);
  Welded welded;
  welded.number.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (i == 0 || less(order[i - 1], order[i])) ++welded.count;
    welded.number[order[i]] = welded.count - 1;
  }
  return welded;
}

}  // namespace barrido::scene
