// How many texels a pixel covers: λ of a texture unit, from the slopes of its coordinates along a span; and
// how large a pixel is in the coordinates of a procedure.
// Enters quantities along a span; knows nothing of filters and texels.
#pragma once

#include "raster/fragments/fragment_state.h"
#include "raster/reference/planes.h"

namespace barrido::raster::reference {

/// How the place (u, v) on the texture (or face) changes from pixel to pixel, in its widths and heights:
/// (ux, vx) to the next pixel of the row, (uy, vy) to the next row. The two span the pixel's footprint.
struct CoordinateSlopes {
  float ux = 0.0f, uy = 0.0f, vx = 0.0f, vy = 0.0f;
};

/// At pixel x of the span; the same for each aligned group of four pixels. The unit must have a texture and
/// coordinates.
CoordinateSlopes coordinate_slopes(const FragmentState& state, int unit, const SpanQuantities& along, int x);

/// λ at pixel x of the span, without the unit's bias; the same for each aligned group of four pixels. The
/// unit must have a texture and coordinates.
float level_of_detail(const FragmentState& state, int unit, const SpanQuantities& along, int x);

/// Of a footprint on this texture.
float level_of_detail(const CoordinateSlopes& slopes, const Texture& texture);

/// Width, along each of the unit's coordinates, of the box that the pixel covers; the same for the group too.
void pixel_extent(const FragmentState& state, int unit, const SpanQuantities& along, int x,
                  float (&extent)[3]);

}  // namespace barrido::raster::reference
