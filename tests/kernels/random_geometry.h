// Random primitives of one chunk: slivers, sub-pixel meshes, full-screen quads, guard-band giants, repeated
// triangles of equal depth, lines and points of all sizes.
#pragma once

#include <string>

#include "random_bits.h"
#include "raster/fragments/primitive.h"

namespace barrido::raster::testing {

struct GeometryOptions {
  int frame_width = 0;
  int frame_height = 0;
  bool hostile = false;
};

/// Fills topology, sizes, own records, primitives and flat colours of a chunk whose state is set.
/// @return what was made, for messages.
std::string fill_random_geometry(RandomBits& random, const GeometryOptions& options, PrimitiveChunk& chunk);

}  // namespace barrido::raster::testing
