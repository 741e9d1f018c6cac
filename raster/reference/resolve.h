// Resolve (raster/tiles/resolve.h) for one pixel, a function a step ("Display").
#pragma once

#include <cstdint>

#include "raster/reference/arithmetic.h"
#include "raster/tiles/resolve.h"

namespace barrido::raster::reference {

float exposed(float c, float scale);
/// In [0, 1]; a NaN gives 0.
float tone_mapped(float c, ToneMap map);
/// The transfer function of IEC 61966-2-1, for c in [0, 1].
float srgb_encoded(float c);

/// One channel after all steps, before it is rounded to 8 bits.
float display_channel(const DisplayTransform& display, float c);

/// The 8-bit colour of a float pixel.
std::uint32_t display_color(const DisplayTransform& display, const Color& color);

}  // namespace barrido::raster::reference
