// Light as a stage of fragments: Phong and cheap Phong.
#pragma once

#include "raster/fragments/fragment_stage.h"

namespace barrido::pipeline {

struct DrawPlan;

/// The model, from interpolated normals.
extern const raster::StageKind kPhongLight;
/// The model, from interpolated dot products.
extern const raster::StageKind kCheapPhongLight;

/// The stage that lights the plan's fragments, with the plan as its parameters. Fragments lit and powers
/// taken are added to the plan's counters. Not for plans whose colours are made before.
raster::FragmentStage light_stage(const DrawPlan& plan);

}  // namespace barrido::pipeline
