// Where per-pixel illumination has a step: the light's edge N·L = 0, and the rim of a spot.
#pragma once

#include "tests/osmesa/exact_triangle.h"

namespace barrido::crosscheck {

class ExactLights {
 public:
  explicit ExactLights(const DrawCall& draw);
  /// Whether the draw is lit per pixel at all.
  bool has_steps() const { return !position_.empty(); }
  bool near_step(const ExactTriangle& triangle, double x, double y) const;

 private:
  const pipeline::State& state_;
  std::vector<glm::dvec3> position_, normal_;  ///< Eye space, of every vertex.
};

}  // namespace barrido::crosscheck
