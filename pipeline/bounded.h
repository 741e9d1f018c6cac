// The bound on every number that enters the pipeline. With all inputs below it, no sum or product that the
// vertex stage and the illumination form can overflow, so neither NaN nor infinity ever reaches the
// rasterizer, and vector minima and maxima never see a NaN (on which instruction sets disagree).
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace barrido::pipeline {

/// Positions, normals, colours, coordinates, matrix elements and products of light and material stay at or
/// below this in magnitude. Three factors of it, 192 times, are below the largest float (3.4e38).
inline constexpr float kBound = 1e12f;

/// Smallest w of a vertex that has a window position; what is nearer to the eye plane is clipped. Then 1/w
/// and varyings divided by w stay below 1e22.
inline constexpr float kMinW = 1e-10f;

/// NaN becomes 0; everything else is clamped to [−kBound, kBound].
inline float bounded(double value) {
  if (!(value == value)) return 0.0f;
  const double limit = kBound;
  return static_cast<float>(value < -limit ? -limit : value > limit ? limit : value);
}

inline glm::vec3 bounded(const glm::dvec3& v) { return {bounded(v.x), bounded(v.y), bounded(v.z)}; }
inline glm::vec4 bounded(const glm::dvec4& v) {
  return {bounded(v.x), bounded(v.y), bounded(v.z), bounded(v.w)};
}
inline glm::mat4 bounded(const glm::dmat4& m) {
  return {bounded(m[0]), bounded(m[1]), bounded(m[2]), bounded(m[3])};
}

}  // namespace barrido::pipeline
