// Value noise: smooth random numbers over the plane, the same on every machine.
#pragma once

namespace barrido::models {

/// Noise in [0, 1] that repeats after `period` units in x and y; 0 for never.
double value_noise(double x, double y, int period = 0);

/// Σ of `octaves` noises, each with twice the frequency and half the height of the one before, scaled to
/// [0, 1]; repeats after `period` units.
double turbulence(double x, double y, int octaves, int period = 0);

}  // namespace barrido::models
