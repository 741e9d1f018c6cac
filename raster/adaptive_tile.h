// Adaptive sampling of a tile (A3): the corners of each pixel; where they differ, quarters of it, and so on;
// and what lies between all samples. docs/samples.md tells the rule. Enters: what is to be drawn of the tile;
// leaves: its sums, each pixel's weight being 1.
#pragma once

#include "raster/sample_tile.h"

namespace barrido::raster {

void add_adaptive_samples(const SampledTile& tile);

}  // namespace barrido::raster
