// The colours that stand for mip levels where they are to be seen. Eight of them, then the first again; sRGB.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace barrido::scene {

using MipColor = std::array<std::uint8_t, 3>;

inline constexpr std::array<MipColor, 8> kMipColors{{{235, 87, 87},
                                                     {242, 170, 76},
                                                     {240, 222, 94},
                                                     {120, 200, 110},
                                                     {86, 190, 214},
                                                     {84, 120, 220},
                                                     {160, 96, 205},
                                                     {205, 205, 205}}};

inline constexpr const MipColor& mip_color(int level) {
  return kMipColors[static_cast<std::size_t>(level) % kMipColors.size()];
}

}  // namespace barrido::scene
