// A texture's colour for filters that follow the shape of the pixel's footprint: several samples along it
// (anisotropic filtering) or at its corners (Crow), or the mean of all texels under it (Catmull). The
// arithmetic is docs/arithmetic.md's, "Footprints".
#pragma once

#include <cstdint>

#include "raster/reference/level_of_detail.h"
#include "raster/reference/sampling.h"

namespace barrido::raster::reference {

struct WideSample {
  Color color{};
  std::uint32_t texels = 0;  ///< That were read.
};

/// The unit's filter must be a wide one. `coordinates`, `lod` and `trace` as for sample_texture.
WideSample sample_wide(const TextureUnit& unit, TexcoordKind kind, const float (&coordinates)[3], float lod,
                       const CoordinateSlopes& slopes, SampleTrace* trace = nullptr);

/// The levels that an anisotropic filter reads: those of the footprint's shorter side.
LevelChoice choose_wide_levels(const TextureUnit& unit, float lod, const CoordinateSlopes& slopes);

}  // namespace barrido::raster::reference
