// The one fragment that the reference shades at a time.
#pragma once

#include "raster/fragments/fragment_batch.h"

namespace barrido::raster::reference {

/// A batch of one, as illumination functions want it, and what the texture units need beside.
struct Fragment : FragmentBatch {
  float lod[kMaxTextureUnits] = {};  ///< λ before the unit's bias (OpenGL 1.3, section 3.8.8).
};

}  // namespace barrido::raster::reference
