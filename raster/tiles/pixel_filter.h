// Reconstruction filters (A4): how much of what lies around a pixel's centre belongs to the pixel.
#pragma once

#include <cstdint>

namespace barrido::raster {

enum class PixelFilterKind : std::uint8_t {
  box,
  triangle,
  cone,
  gaussian,  ///< σ = ½ pixel, less its value at the radius, as pbrt's.
  mitchell,  ///< B = C = ⅓ (Mitchell and Netravali 1988); negative between half the radius and all of it.
};

/// Half widths in pixels that users know the filters with.
float default_radius(PixelFilterKind kind);

struct PixelFilter {
  PixelFilterKind kind = PixelFilterKind::box;
  float radius = 0.5f;  ///< Half width in pixels, above 0; of the cone its radius.

  friend bool operator==(const PixelFilter&, const PixelFilter&) = default;
};

/// Value of the filter (x, y) pixels from the pixel's centre; 0 outside the radius. Not normalised: its
/// integral is filter_integral().
double filter_value(const PixelFilter& filter, double x, double y);

/// Over the plane, in closed form: box 4r², triangle r⁴, cone πr²/3, Mitchell r²/4, gaussian
/// (erf(r√2) − 2r·g(r))² with g the normal density of σ = ½.
double filter_integral(const PixelFilter& filter);

/// What is left of a sinusoid of `f` cycles a pixel along x: the filter's Fourier transform over its
/// integral, by quadrature of its marginal (Simpson's rule).
double filter_response(const PixelFilter& filter, double f);

}  // namespace barrido::raster
