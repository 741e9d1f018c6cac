// How many texels a pixel covers: λ of a texture unit, from the slopes of its coordinates along a span.
// Enters quantities along a span; knows nothing of filters and texels.
#pragma once

#include "raster/fragments/fragment_state.h"
#include "raster/reference/planes.h"

namespace barrido::raster::reference {

/// λ at pixel x of the span, without the unit's bias; the same for each aligned group of four pixels. The
/// unit must have a texture and coordinates.
float level_of_detail(const FragmentState& state, int unit, const SpanQuantities& along, int x);

}  // namespace barrido::raster::reference
