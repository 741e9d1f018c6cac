// Stages that only the tests know, one for each place in a fragment's journey: before light, light, in place
// of a texture's picture, and after everything.
#pragma once

#include "raster/fragments/fragment_stage.h"

namespace barrido::raster::testing {

extern const StageKind kBendNormal;     ///< Before light.
extern const StageKind kBendByTexture;  ///< Before light, by the texels of a unit of its own.
extern const StageKind kTestLight;      ///< Colours from the normal and the facing.
extern const StageKind kInvert;         ///< After fog: 1 − colour.

/// Rings around the origin of 2 or of 3 coordinates.
extern const TextureProcedure kRings2, kRings3;

}  // namespace barrido::raster::testing
