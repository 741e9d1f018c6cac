// Draws out of bytes: any state the pipeline may be asked for, any geometry, any numbers. Must not know what
// is done with them.
#pragma once

#include <vector>

#include "input.h"
#include "pipeline/geometry.h"
#include "pipeline/state.h"
#include "raster/rasterizer.h"
#include "raster/tiles/framebuffer.h"

namespace barrido::fuzz {

/// Geometry that owns what it points to.
struct OwnedGeometry {
  std::vector<float> numbers;
  std::vector<std::uint32_t> indices;
  pipeline::Geometry geometry;  ///< Views of the two.
};

raster::FramebufferOptions any_frame(Input& input);
raster::ClearValues any_clear(Input& input);
pipeline::State any_state(Input& input);
/// Indices are out of range now and then.
void any_geometry(Input& input, OwnedGeometry& owned);

}  // namespace barrido::fuzz
