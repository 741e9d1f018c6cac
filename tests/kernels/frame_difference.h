// Bit-for-bit comparison of two frames, with a message that names the first pixel that differs.
#pragma once

#include <string>

#include "raster/tiles/framebuffer.h"

namespace barrido::raster::testing {

/// Empty when color8, color_float and depth are the same bits. NaNs count as the same number whatever their
/// payload: which one survives an operation is not defined.
std::string describe_difference(const Framebuffer& expected, const Framebuffer& actual);

}  // namespace barrido::raster::testing
