// Mip chains: enters a level's interior, leaves the next level's. Integer arithmetic throughout, so the same
// texels everywhere. Knows nothing of aprons, encodings or faces.
#include <cstring>
#include <type_traits>

#include "raster/base/parallel_rows.h"
#include "raster/textures/texture_level.h"

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

/// The common case, both sides even: the mean of 2 × 2 texels, two channels of a texel in one sum.
template <class Channel>
void halve_even_row(const Channel* lower, const Channel* upper, Channel* out, int out_width) {
  using Texel = std::conditional_t<sizeof(Channel) == 1, std::uint32_t, std::uint64_t>;
  constexpr int kBits = 8 * sizeof(Channel);
  constexpr Texel kChannel = (Texel{1} << kBits) - 1;
  constexpr Texel kEven = kChannel << 2 * kBits | kChannel;  // the first and the third channel
  constexpr Texel kHalf = Texel{2} << 2 * kBits | 2;
  const auto load = [](const Channel* from) {
    Texel texel;
    std::memcpy(&texel, from, sizeof(texel));
    return texel;
  };
  for (int i = 0; i < out_width; ++i, lower += 8, upper += 8, out += 4) {
    const Texel texels[4] = {load(lower), load(lower + 4), load(upper), load(upper + 4)};
    Texel even = kHalf;
    Texel odd = kHalf;
    for (const Texel texel : texels) {
      even += texel & kEven;
      odd += texel >> kBits & kEven;
    }
    const Texel mean = (even >> 2 & kEven) | (odd >> 2 & kEven) << kBits;
    std::memcpy(out, &mean, sizeof(mean));
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
