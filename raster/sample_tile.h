// The samples of one tile, drawn one after the other into sums. Enters: what is to be drawn of the tile;
// leaves: TileWorkspace::sums.
#pragma once

#include "raster/kernels/kernels.h"
#include "raster/tiles/samples.h"

namespace barrido::raster {

struct SampledTile {
  TileJob& job;
  TileWorkspace& workspace;
  const SampleSettings& settings;
  const ClearValues& clear;
  const FramebufferOptions& frame;
};

/// Adds each of the settings' samples to the sums, which hold those before them.
void add_samples(const SampledTile& tile);

}  // namespace barrido::raster
