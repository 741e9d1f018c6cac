#include "pipeline/scene/metering.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "pipeline/matrix.h"
#include "pipeline/scene/framing.h"
#include "pipeline/scene/light_conversion.h"
#include "pipeline/scene/triangles.h"

namespace barrido::scene {
namespace {

constexpr std::size_t kSamples = 4096;
constexpr std::size_t kPercentile = 85;
constexpr float kDimmest = 0.25f;
constexpr float kBrightest = 1.0f;

std::vector<pipeline::Light> physical_lights(const Scene& scene, const std::vector<int>& nodes,
                                             const Pose& pose) {
  std::vector<pipeline::Light> lights;
  for (const int node : light_nodes(scene, nodes)) {
    const auto index = static_cast<std::size_t>(node);
    const Light& light = scene.lights[static_cast<std::size_t>(scene.nodes[index].light)];
    if (is_physical(light))
      lights.push_back(convert_light(light, place_of_node(pose.world_from_node[index])));
  }
  return lights;
}

float spot_factor(const pipeline::Light& light, const glm::vec3& to_light) {
  if (light.spot_outer_cos >= light.spot_inner_cos) return 1.0f;  // no soft cone: hard ones are not physical
  const float cosine = -glm::dot(to_light, light.spot_direction);
  const float width = std::max(0.001f, light.spot_inner_cos - light.spot_outer_cos);
  const float s = std::clamp((cosine - light.spot_outer_cos) / width, 0.0f, 1.0f);
  return s * s;
}

/// Largest channel of what a white surface at `p` receives over π; without a normal it faces every light.
float received(const pipeline::Light& light, const glm::vec3& p, const glm::vec3* normal) {
  const glm::vec3 offset = glm::vec3(light.position) - p * light.position.w;
  const float distance = std::sqrt(glm::dot(offset, offset));
  if (!(distance > 0.0f)) return 0.0f;
  const glm::vec3 to_light = offset / distance;
  float factor = normal != nullptr ? std::max(glm::dot(*normal, to_light), 0.0f) : 1.0f;
  if (light.position.w != 0.0f) {
    factor /= light.constant_attenuation +
              distance * (light.linear_attenuation + distance * light.quadratic_attenuation);
    factor *= spot_factor(light, to_light);
    if (light.range > 0.0f) {
      const float q = distance / light.range;
      factor *= std::clamp(1.0f - q * q * q * q, 0.0f, 1.0f);
    }
  }
  return factor * std::max({light.diffuse.r, light.diffuse.g, light.diffuse.b});
}

std::size_t vertex_count(const Scene& scene, const std::vector<int>& nodes) {
  std::size_t count = 0;
  for (const int node : nodes) {
    const int mesh = scene.nodes[static_cast<std::size_t>(node)].mesh;
    if (mesh == kNone) continue;
    for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(mesh)].primitives) {
      count += primitive.vertex_count;
    }
  }
  return count;
}

/// Every `step`-th vertex of the scene, starting with the first.
template <class Function>
void for_each_sample(const Scene& scene, const std::vector<int>& nodes, const Pose& pose, std::size_t step,
                     Function&& function) {
  std::size_t next = 0;  // vertices to go until the next sample
  for (const int node : nodes) {
    const auto index = static_cast<std::size_t>(node);
    if (scene.nodes[index].mesh == kNone) continue;
    const glm::mat4& world = pose.world_from_node[index];
    const glm::dmat3 normal_matrix = pipeline::normal_matrix(world);
    for (const Primitive& primitive :
         scene.meshes[static_cast<std::size_t>(scene.nodes[index].mesh)].primitives) {
      const std::vector<bool> drawn =
          drawn_vertices(primitive.mode, primitive.indices.values(), primitive.vertex_count);
      for (; next < primitive.vertex_count; next += step) {
        if (!drawn.empty() && !drawn[next]) continue;
        const float* p = primitive.positions.data() + 3 * next;
        const glm::vec3 position(world * glm::vec4(p[0], p[1], p[2], 1.0f));
        if (primitive.normals.empty()) {
          function(position, static_cast<const glm::vec3*>(nullptr));
          continue;
        }
        const float* n = primitive.normals.data() + 3 * next;
        const glm::vec3 normal(unit_or(normal_matrix * glm::dvec3(n[0], n[1], n[2]), {0, 0, 1}));
        function(position, &normal);
      }
      next -= primitive.vertex_count;
    }
  }
}

}  // namespace

float physical_light_scale(const Scene& scene, const std::vector<int>& nodes, const Pose& pose) {
  const std::vector<pipeline::Light> lights = physical_lights(scene, nodes, pose);
  if (lights.empty()) return 1.0f;
  const std::size_t step = vertex_count(scene, nodes) / kSamples + 1;
  std::vector<float> measured;
  for_each_sample(scene, nodes, pose, step, [&](const glm::vec3& p, const glm::vec3* normal) {
    float sum = 0.0f;
    for (const pipeline::Light& light : lights) sum += received(light, p, normal);
    if (sum > 0.0f && std::isfinite(sum)) measured.push_back(sum);
  });
  if (measured.empty()) return 1.0f;
  const auto middle =
      measured.begin() + static_cast<std::ptrdiff_t>((measured.size() - 1) * kPercentile / 100);
  std::nth_element(measured.begin(), middle, measured.end());
  return std::clamp(*middle, kDimmest, kBrightest) / *middle;
}

}  // namespace barrido::scene
