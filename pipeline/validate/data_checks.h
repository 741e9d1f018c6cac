// Rules on the numbers themselves: bounds, indices, unit vectors, times, joints and weights.
#pragma once

#include "pipeline/validate/link.h"

namespace barrido::scene::validation {

/// Checks all accessors and what `link.data_checks` asks for, as far as `budget` numbers reach.
void check_data(Link& link, Budget& budget);

/// Joints and weights of every skinned mesh.
void check_influences(Link& link, Budget& budget);

}  // namespace barrido::scene::validation
