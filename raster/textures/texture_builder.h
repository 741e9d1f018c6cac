// Internal to the texture module: lays out a texture's memory and fills it level by level. Enters checked
// pictures; leaves a finished Texture.
#pragma once

#include <span>

#include "raster/textures/texture.h"
#include "raster/textures/texture_level.h"

namespace barrido::raster {

class TextureBuilder {
 public:
  /// `base_levels` are the given levels of all faces, level-major; missing levels are filtered from the last
  /// given one when the options ask for mip maps and `complete_chain`. The pictures must have been checked.
  static Texture build(std::span<const Pixels8> base_levels, int face_count, bool complete_chain,
                       const TextureOptions& options);

 private:
  static void lay_out(Texture& texture, std::span<const Pixels8> base_levels, bool complete_chain);
  static void clear_between_levels(Texture& texture, std::size_t texel_bytes);
  template <class Channel>
  static void fill(Texture& texture, std::span<const Pixels8> base_levels);
  template <class Channel>
  static LevelView<Channel> view(Texture& texture, int level, int face);
  template <class Channel>
  static void fill_aprons(Texture& texture, int level);
};

}  // namespace barrido::raster
