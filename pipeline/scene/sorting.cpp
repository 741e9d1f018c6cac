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

std::vector<std::uint32_t> farthest_first(std::span<const float> distance) {
  std::vector<std::uint32_t> order(distance.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return distance[a] > distance[b]; });
  return order;
}

std::vector<std::uint32_t> triangles_back_to_front(const pipeline::Geometry& geometry,
                                                   const EyeDistance& distance) {
  const std::vector<std::uint32_t> triangles =
      triangle_list(geometry.mode, geometry.indices, geometry.vertex_count);
  const auto position = [&](std::uint32_t vertex) {
    const float* p =
        geometry.position.data + std::size_t{vertex} * static_cast<std::size_t>(geometry.position.stride);
    return glm::vec3(p[0], p[1], p[2]);
  };
  std::vector<float> distances(triangles.size() / 3);
  for (std::size_t t = 0; t < distances.size(); ++t) {
    const glm::vec3 sum =
        position(triangles[3 * t]) + position(triangles[3 * t + 1]) + position(triangles[3 * t + 2]);
    distances[t] = distance(sum / 3.0f);
  }
  std::vector<std::uint32_t> sorted;
  sorted.reserve(triangles.size());
  for (const std::uint32_t t : farthest_first(distances)) {
    sorted.insert(sorted.end(), {triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2]});
  }
  return sorted;
}

}  // namespace barrido::scene
