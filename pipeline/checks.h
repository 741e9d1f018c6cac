// What is impossible in a draw's state or geometry is refused here, before any of it is used.
#pragma once

#include "pipeline/geometry.h"
#include "pipeline/state.h"

namespace barrido::pipeline {

/// @throws std::invalid_argument saying which value is impossible and why. (Lights and materials are checked
/// where they are compiled.)
void check(const State& state);
void check(const Geometry& geometry);

}  // namespace barrido::pipeline
