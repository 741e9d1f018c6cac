// The order in which transparent things are drawn: back to front. Enters: geometry and where the eye is;
// leaves: orders. Knows no materials.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "pipeline/geometry.h"

namespace barrido::scene {

/// Measures how far away points are, for ordering: distance from the eye, or depth along the view where all
/// rays are parallel.
class EyeDistance {
 public:
  EyeDistance(const glm::mat4& eye_from_object, bool parallel)
      : eye_from_object_(eye_from_object), parallel_(parallel) {}
  float operator()(const glm::vec3& p) const;

 private:
  glm::mat4 eye_from_object_;
  bool parallel_;
};

}  // namespace barrido::scene
