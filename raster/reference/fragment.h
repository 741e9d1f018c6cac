// The one fragment that the reference shades at a time.
#pragma once

#include "raster/fragments/fragment_state.h"
#include "raster/reference/arithmetic.h"
#include "raster/reference/level_of_detail.h"

namespace barrido::raster::reference {

struct Fragment {
  const FragmentState* state = nullptr;
  bool back_facing = false;
  float depth = 0.0f;
  float lod[kMaxTextureUnits] = {};        ///< λ before the unit's bias (OpenGL 1.3, section 3.8.8).
  float extent[kMaxTextureUnits][3] = {};  ///< Of procedures; see ProcedurePoints.
  /// Of units whose filter follows the footprint's shape.
  CoordinateSlopes slopes[kMaxTextureUnits] = {};
  float varying[kMaxVaryings] = {};  ///< Interpolated and perspective-corrected; then what stages compute.
  Color color{};                     ///< The primitive's where it is flat; then what the stages make of it.
  Color specular{};                  ///< Secondary colour; no alpha.
  Color primary{};                   ///< As the texture units get it.
};

}  // namespace barrido::raster::reference
