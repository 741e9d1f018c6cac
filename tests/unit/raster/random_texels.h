// Random pictures for the texture tests: the same bytes everywhere (only raw bits of std::mt19937_64).
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "raster/textures/texture.h"

namespace barrido::raster::testing {

inline std::vector<std::uint8_t> random_rgba(int width, int height, std::uint64_t seed) {
  std::mt19937_64 bits(seed);
  std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  for (std::uint8_t& byte : rgba) byte = static_cast<std::uint8_t>(bits() >> 56);
  return rgba;
}

/// One texel of a picture as four numbers.
inline std::array<int, 4> texel_of(const std::vector<std::uint8_t>& rgba, int width, int i, int j) {
  std::array<int, 4> result{};
  for (std::size_t c = 0; c < 4; ++c) {
    result[c] =
        rgba[(static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i)) *
                 4 +
             c];
  }
  return result;
}

/// One texel of a texture in units of 1/255.
inline std::array<int, 4> byte_texel(const Texture& texture, int level, int face, int i, int j) {
  const std::array<float, 4> color = texture.texel(level, face, i, j);
  std::array<int, 4> result{};
  for (std::size_t c = 0; c < 4; ++c) result[c] = static_cast<int>(color[c] * 255.0f + 0.5f);
  return result;
}

}  // namespace barrido::raster::testing
