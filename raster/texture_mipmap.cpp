// Mip chains: enters a level's interior, leaves the next level's. Integer arithmetic throughout, so the same
// texels everywhere. Knows nothing of aprons, encodings or faces.
#include "raster/parallel_rows.h"
#include "raster/texture_level.h"

namespace barrido::raster {
namespace {

/// What one texel of the smaller level covers along one axis: `count` texels from `first`, with integer
/// weights.
struct Footprint {
  int first = 0;
  int count = 1;
  std::uint64_t weight[3] = {1, 0, 0};
};

/// Texel j of m covers [j·n/m, (j+1)·n/m) of n texels. For n = 2m + 1 that is the last (m − j)/m of texel 2j,
/// all of 2j + 1 and the first (j + 1)/m of 2j + 2 (Guthe and Heckbert, Non-power-of-two mipmap creation,
/// 2005).
Footprint footprint(int full, int index) {
  if (full == 1) return {};
  const int half = full / 2;
  if (full % 2 == 0) return {2 * index, 2, {1, 1, 0}};
  return {2 * index,
          3,
          {static_cast<std::uint64_t>(half - index), static_cast<std::uint64_t>(half),
           static_cast<std::uint64_t>(index + 1)}};
}

std::uint64_t total_weight(int full) {
  if (full == 1) return 1;
  return full % 2 == 0 ? 2 : static_cast<std::uint64_t>(full);
}

/// The common case, both sides even: the mean of 2 × 2 texels, written so that compilers vectorize it.
template <class Channel>
void halve_even_row(const Channel* lower, const Channel* upper, Channel* out, int out_width) {
  for (int i = 0; i < out_width; ++i) {
    for (int c = 0; c < 4; ++c) {
      const std::uint32_t sum =
          std::uint32_t{lower[8 * i + c]} + lower[8 * i + 4 + c] + upper[8 * i + c] + upper[8 * i + 4 + c];
      out[4 * i + c] = static_cast<Channel>((sum + 2) >> 2);
    }
  }
}

template <class Channel>
void weighted_mean(const LevelView<Channel>& full, const Footprint& across, const Footprint& down,
                   std::uint64_t total, Channel* out) {
  // At most 16384² · 65535 < 2^44: no overflow.
  std::uint64_t sum[4] = {0, 0, 0, 0};
  for (int y = 0; y < down.count; ++y) {
    for (int x = 0; x < across.count; ++x) {
      const Channel* texel = full.at(across.first + x, down.first + y);
      const std::uint64_t weight = across.weight[x] * down.weight[y];
      for (int c = 0; c < 4; ++c) sum[c] += weight * texel[c];
    }
  }
  for (int c = 0; c < 4; ++c) out[c] = static_cast<Channel>((sum[c] + total / 2) / total);
}

}  // namespace

template <class Channel>
void halve_level(const LevelView<Channel>& full, const LevelView<Channel>& half) {
  if (full.width % 2 == 0 && full.height % 2 == 0) {
    return for_each_row(half.width, half.height, [&](int j) {
      halve_even_row<Channel>(full.at(0, 2 * j), full.at(0, 2 * j + 1), half.at(0, j), half.width);
    });
  }
  const std::uint64_t total = total_weight(full.width) * total_weight(full.height);
  for_each_row(half.width, half.height, [&](int j) {
    const Footprint down = footprint(full.height, j);
    for (int i = 0; i < half.width; ++i) {
      weighted_mean(full, footprint(full.width, i), down, total, half.at(i, j));
    }
  });
}

template void halve_level(const LevelView<std::uint8_t>&, const LevelView<std::uint8_t>&);
template void halve_level(const LevelView<std::uint16_t>&, const LevelView<std::uint16_t>&);

}  // namespace barrido::raster
