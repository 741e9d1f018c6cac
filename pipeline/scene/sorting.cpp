#include "pipeline/scene/sorting.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include <glm/geometric.hpp>

#include "pipeline/scene/triangles.h"

namespace barrido::scene {

float EyeDistance::operator()(const glm::vec3& p) const {
  const glm::vec3 eye(eye_from_object_ * glm::vec4(p, 1.0f));
  const float distance = parallel_ ? -eye.z : glm::dot(eye, eye);
  // Sorting needs an order of everything: what is not a number counts as farthest.
  return distance == distance ? distance : std::numeric_limits<float>::infinity();
}

}  // namespace barrido::scene
