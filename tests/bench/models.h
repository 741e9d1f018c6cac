// Real models, whole frames: the draws that the scene module makes of a glTF file, given to both renderers.
#pragma once

#include "tests/bench/measure.h"

namespace barrido::bench {

/// Each model in the four shading modes at 1280 × 720: those of the project's models/ and, where
/// `options.models` is there, two of that folder. Prints as it goes. @throws scene::InputError.
Table run_models(const Options& options);

}  // namespace barrido::bench
