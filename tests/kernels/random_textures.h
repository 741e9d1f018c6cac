// The textures that generated scenes draw with: both texel formats, all wrap modes, odd sizes, cube maps.
#pragma once

#include <vector>

#include "random_bits.h"
#include "raster/textures/texture.h"

namespace barrido::raster::testing {

/// Built once and kept for the whole test.
class TexturePool {
 public:
  explicit TexturePool(std::uint64_t seed);

  const Texture& flat(RandomBits& random) const;
  const Texture& cube(RandomBits& random) const;

 private:
  std::vector<Texture> flat_;
  std::vector<Texture> cubes_;
};

}  // namespace barrido::raster::testing
