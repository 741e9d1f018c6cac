// What a texture unit does with its texel: the texture environment (OpenGL 1.3, tables 3.22 to 3.25). Enters
// and leaves colours; knows nothing of coordinates and texels.
#pragma once

#include "raster/fragments/fragment_state.h"
#include "raster/reference/arithmetic.h"

namespace barrido::raster::reference {

/// The colours a unit may combine.
struct UnitInputs {
  Color texture;
  Color primary;   ///< Of the fragment, before all units.
  Color previous;  ///< Result of the unit before, or the primary colour.
};

/// The unit's result, not clamped.
Color apply_texture_environment(const TextureUnit& unit, const UnitInputs& inputs);

}  // namespace barrido::raster::reference
