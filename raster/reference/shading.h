// From an interpolated fragment to its final colour: primary and secondary colours, texture units, colour
// sum, fog. Enters and leaves a fragment; knows nothing of the frame.
#pragma once

#include "raster/reference/arithmetic.h"
#include "raster/reference/fragment.h"
#include "raster/reference/trace.h"

namespace barrido::raster::reference {

/// True when the unit has a texture and coordinates of the right kind for it.
bool is_unit_active(const FragmentState& state, int unit);

/// The fraction f of the fragment's own colour that fog leaves, for a fog distance ≥ 0.
float fog_fraction(const FogState& fog, float distance);

/// The colour of the batch's fragment, whose depth, varyings and levels of detail are set and whose colours
/// are those of the primitive where it is flat. The steps are remembered in `trace` unless that is null.
Color shade_fragment(Fragment& batch, ShadingTrace* trace = nullptr);

}  // namespace barrido::raster::reference
