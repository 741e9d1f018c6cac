// How many texels a pixel covers: λ of a texture unit, from the slopes of its coordinates along a span; and
// how large a pixel is in the coordinates of a procedure.
// Enters quantities along a span; knows nothing of filters and texels.
#pragma once

#include "raster/fragments/fragment_state.h"
#include "raster/reference/planes.h"

namespace barrido::raster::reference {

/// λ at pixel x of the span, without the unit's bias; the same for each aligned group of four pixels. The
/// unit must have a texture and coordinates.
float level_of_detail(const FragmentState& state, int unit, const SpanQuantities& along, int x);

/// Width, along each of the unit's coordinates, of the box that the pixel covers; the same for the group too.
void pixel_extent(const FragmentState& state, int unit, const SpanQuantities& along, int x,
                  float (&extent)[3]);

}  // namespace barrido::raster::reference
