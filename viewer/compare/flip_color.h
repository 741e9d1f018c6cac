// The colour spaces of FLIP and its distance between colours (Andersson et al. 2020, sections 4.1.1
// to 4.1.3). White is D65, primaries are sRGB's.
#pragma once

namespace barrido::compare {

struct Triple {
  float x, y, z;
};

/// Linear RGB in 0..1 to the opponent space YCxCz: L* and two chromatic coordinates, without a cube root.
Triple ycxcz_from_linear(const Triple& rgb);

/// YCxCz, clamped to linear RGB in 0..1, as CIE Lab with a and b times 0.01·L (the Hunt effect: colours fade
/// with light).
Triple hunt_lab_from_ycxcz(const Triple& ycxcz);

/// The distance of two colours in that space, HyAB to the power 0.7, brought to 0..1 so that its lower 0.4 of
/// the range spread over 0.95.
float color_error(const Triple& hunt_lab_a, const Triple& hunt_lab_b);

/// Relative luminance of linear RGB.
float luminance(const Triple& rgb);

}  // namespace barrido::compare
