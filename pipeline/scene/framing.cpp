#include "pipeline/scene/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "raster/portable_math.h"

namespace barrido::scene {
namespace {

constexpr double kEyeAzimuthDeg = 25.0;
constexpr double kEyeElevationDeg = 18.0;
constexpr double kMargin = 1.04;
constexpr int kFramingMoments = 9;

template <class Function>
void for_each_point(std::span<const float> positions, const glm::dmat4& world_from_object,
                    Function&& function) {
  for (std::size_t i = 0; i + 2 < positions.size(); i += 3) {
    const glm::dvec3 p(world_from_object * glm::dvec4(positions[i], positions[i + 1], positions[i + 2], 1.0));
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) function(p);
  }
}

/// Calls `function` with every posed vertex in world space.
template <class Function>
void for_each_point(const Scene& scene, std::span<const int> nodes, const Pose& pose, Function&& function) {
  for (const int node : nodes) {
    const int mesh = scene.nodes[static_cast<std::size_t>(node)].mesh;
    if (mesh == kNone) continue;
    const glm::dmat4 world_from_node(pose.world_from_node[static_cast<std::size_t>(node)]);
    for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(mesh)].primitives) {
      if (is_deformed(scene, node, primitive)) {
        const DeformedVertices deformed = deform(scene, pose, node, primitive);
        for_each_point(deformed.positions, deformed.in_world_space ? glm::dmat4(1.0) : world_from_node,
                       function);
      } else {
        for_each_point(primitive.positions.values(), world_from_node, function);
      }
    }
  }
}

}  // namespace

Sphere bounding_sphere(const Scene& scene, std::span<const int> nodes, std::span<const Pose> poses) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  glm::dvec3 low(kInfinity), high(-kInfinity);
  for (const Pose& pose : poses) {
    for_each_point(scene, nodes, pose, [&](const glm::dvec3& p) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    });
  }
  if (low.x > high.x) return {};
  Sphere sphere{low * 0.5 + high * 0.5, 0.0};
  double radius_squared = 0.0;
  for (const Pose& pose : poses) {
    for_each_point(scene, nodes, pose, [&](const glm::dvec3& p) {
      radius_squared = std::max(radius_squared, glm::dot(p - sphere.center, p - sphere.center));
    });
  }
  sphere.radius = std::sqrt(radius_squared);
  // Below this the model is a point as far as single precision can tell.
  const double smallest = std::sqrt(glm::dot(sphere.center, sphere.center)) * 1e-6;
  if (sphere.radius <= smallest) sphere.radius = smallest > 0.0 ? smallest : 1.0;
  return sphere;
}

std::vector<Pose> framing_poses(const Scene& scene, int animation) {
  std::vector<Pose> poses;
  if (animation == kNone) {
    poses.push_back(pose_at(scene, kNone, 0.0));
    return poses;
  }
  const double duration_s = scene.animations[static_cast<std::size_t>(animation)].duration_s;
  for (int i = 0; i < kFramingMoments; ++i) {
    poses.push_back(pose_at(scene, animation, duration_s * i / (kFramingMoments - 1)));
  }
  return poses;
}

glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& fallback) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0.0) || !std::isfinite(largest)) return fallback;
  const glm::dvec3 scaled = v / largest;
  return scaled / std::sqrt(glm::dot(scaled, scaled));
}

glm::dvec3 turned(const glm::dvec3& p, const glm::dvec3& axis, double angle_deg) {
  const double angle = radians(angle_deg);
  const double c = portable_cos(angle), s = portable_sin(angle);
  return p * c + glm::cross(axis, p) * s + axis * (glm::dot(axis, p) * (1.0 - c));
}

glm::dmat3 world_from_upright(const glm::dvec3& up) {
  const glm::dvec3 y(0, 1, 0);
  const glm::dvec3 unit_up = unit_or(up, y);
  const glm::dvec3 axis = unit_or(glm::cross(y, unit_up), {1, 0, 0});
  const double angle_deg = portable_acos(glm::dot(y, unit_up)) * (180.0 / kPi);
  return {turned({1, 0, 0}, axis, angle_deg), unit_up, turned({0, 0, 1}, axis, angle_deg)};
}

glm::dvec3 default_eye_direction(const glm::dvec3& up) {
  const glm::dmat3 turn = world_from_upright(up);
  return turned(turned(turn[2], turn[0], -kEyeElevationDeg), turn[1], kEyeAzimuthDeg);
}

double framing_distance(double radius, double vertical_fov_rad, double aspect) {
  const double half = vertical_fov_rad * 0.5;
  const double tangent = portable_tan(half) * std::min(aspect, 1.0);
  const double sine = tangent / std::sqrt(1.0 + tangent * tangent);
  return radius * kMargin / std::max(sine, 1e-6);
}

}  // namespace barrido::scene
