// Why a picture came out empty, in words for the user. Enters: a frame and the work that drawing it was;
// leaves: a sentence. Draws nothing.
#pragma once

#include <string>

#include "pipeline/renderer.h"
#include "pipeline/scene/frame.h"

namespace barrido::scene {

/// Empty when something was drawn, or when the surroundings are the picture's background and hide the answer.
std::string why_empty(const SceneFrame& frame, const RenderSettings& settings,
                      const pipeline::Statistics& drawn);

}  // namespace barrido::scene
