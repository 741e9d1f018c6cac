// Exposure for lights in physical units. Enters: a scene whose lights are in candela and lux; leaves: one
// factor for all of them, as a photographer would set it. Knows no camera, so that it holds still while the
// eye moves.
#pragma once

#include <vector>

#include "pipeline/scene/animate.h"
#include "pipeline/scene/scene.h"

namespace barrido::scene {

/// The factor for the file's physical lights: they are measured on up to about four thousand vertices of the
/// scene as it stands, as what a white diffuse surface would send back (Σ I/π·N·L·attenuation). The value
/// that 85 % of the lit vertices stay below is brought into [0.25, 1]: a scene within keeps its brightness, a
/// lamp of hundreds of candela is turned down, a glimmer is turned up. 1 when nothing is lit.
float physical_light_scale(const Scene& scene, const std::vector<int>& nodes, const Pose& pose);

}  // namespace barrido::scene
