// What HDR-FLIP adds to FLIP: the exposures at which a picture of floats is looked at, and the tone mapping
// for each (Andersson et al. 2021, sections 3.1 and 3.2).
#pragma once

#include "viewer/compare/flip.h"
#include "viewer/compare/flip_color.h"

namespace barrido::compare {

/// From the exposure at which the brightest pixel becomes 0.85 to that at which the median does, in steps of
/// about one stop, at least two. Values that are not finite, and those below 0, count as 0.
FlipFigures::Exposures choose_exposures(const scene::StoredPicture& reference);

/// Linear RGB brightened by `gain`, through the ACES curve (Narkowicz 2015), clamped to 0..1.
Triple tone_mapped(const Triple& rgb, float gain);

/// Values that FLIP can work with: NaN and what is below 0 count as 0, infinity as very bright.
float usable_radiance(float value);

}  // namespace barrido::compare
