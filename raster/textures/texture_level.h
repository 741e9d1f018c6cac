// Internal to the texture module: one mip level of one face while its texels are being written, as an array
// of channels with an apron of one texel on every side. Knows no wrap modes and no files.
#pragma once

#include <cstddef>
#include <cstdint>

#include "raster/textures/texture.h"

namespace barrido::raster {

/// Four channels a texel; Channel is std::uint8_t (TexelFormat::rgba8) or std::uint16_t (rgba16).
template <class Channel>
struct LevelView {
  Channel* corner = nullptr;  ///< Texel (-1, -1).
  int width = 0;
  int height = 0;
  std::ptrdiff_t pitch = 0;  ///< Channels from one row to the next.

  /// The four channels of texel (i, j), i in [-1, width], j in [-1, height].
  Channel* at(int i, int j) const {
    return corner + (j + 1) * pitch + (static_cast<std::ptrdiff_t>(i) + 1) * 4;
  }
};

template <class Channel>
LevelView<Channel> view_level(std::uint8_t* data, const MipLevel& level) {
  return {reinterpret_cast<Channel*>(data + level.offset_bytes), level.width, level.height,
          static_cast<std::ptrdiff_t>(level.pitch_texels) * 4};
}

/// Fills `half`'s interior from `full`'s interior: each texel is the mean, weighted by area, of the texels it
/// covers (a box filter), rounded to nearest. Sides must be max(1, full / 2); an odd side n gives texels that
/// cover n / (n / 2) of the old ones.
template <class Channel>
void halve_level(const LevelView<Channel>& full, const LevelView<Channel>& half);

/// Fills the apron of a two-dimensional level as the wrap modes want it; `border` is the border colour.
template <class Channel>
void fill_apron(const LevelView<Channel>& level, Wrap wrap_s, Wrap wrap_t, const Channel border[4]);

/// Fills the aprons of the six faces of one level. Seamless: from the neighbouring faces, and at a corner,
/// where three faces meet, with the mean of the three texels there. Otherwise with the face's own edge
/// texels.
template <class Channel>
void fill_cube_aprons(const LevelView<Channel> (&faces)[kCubeFaces], bool seamless);

}  // namespace barrido::raster
