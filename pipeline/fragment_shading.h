// Illumination per fragment (Phong and cheap Phong), as the rasterizer calls it.
#pragma once

#include "raster/fragments/fragment_state.h"

namespace barrido::pipeline {

struct DrawPlan;

/// The function for the plan's shading, with the plan as its parameters; none unless fragments are lit.
/// The fragments lit and the powers taken are added to the plan's counters.
raster::FragmentIllumination fragment_illumination(const DrawPlan& plan);

}  // namespace barrido::pipeline
