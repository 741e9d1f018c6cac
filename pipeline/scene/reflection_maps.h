// Environment maps blurred for rough surfaces: the prefiltering of the course (T18), done for a whole lobe
// rather than a pixel. Enters: a cube map and a highlight's exponent; leaves: a cube map to look up the
// reflected direction in.
#pragma once

#include <map>
#include <memory>
#include <utility>

#include "raster/textures/texture.h"

namespace barrido::scene {

/// The map whose texel in direction d is the mean of `map` weighted by max(0, d·x)^n over all directions x;
/// 6 × size² texels, no mip chain. n = 2^log2_exponent. Sizes up to 16 are meant.
raster::Texture blurred_cube(const raster::Texture& map, int log2_exponent, int size);

/// Blurred versions, made on demand. `map` must stay alive as long as the object.
class ReflectionMaps {
 public:
  /// What a surface with this exponent of (R·V)^n reflects; `map` itself for nearly smooth ones.
  const raster::Texture& get(const raster::Texture& map, float phong_exponent);

 private:
  std::map<std::pair<const raster::Texture*, int>, raster::Texture> blurred_;
};

}  // namespace barrido::scene
