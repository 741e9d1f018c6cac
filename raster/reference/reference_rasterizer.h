// The reference: draws chunks one fragment at a time, in the order of drawing, exactly as docs/arithmetic.md
// says and as plainly as possible. Slow, and meant to be read; the vector kernels must give the same bits.
// Must not know: tiles as units of work, threads, vectors.
#pragma once

#include <span>

#include "raster/fragments/primitive.h"
#include "raster/tiles/framebuffer.h"

namespace barrido::raster::reference {

/// Clears the frame and draws `chunks` one after the other. Fills color8, and color_float and depth where the
/// framebuffer keeps them. Chunks must be valid (vertices within their records, positions in the guard band).
void rasterize(std::span<const PrimitiveChunk* const> chunks, const ClearValues& clear,
               Framebuffer& framebuffer);

}  // namespace barrido::raster::reference
