// Poses: key frames at a moment become local transforms, these become world matrices. The same bits on every
// machine: elementary functions come from portable_math.h.
#include "pipeline/scene/animate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>

#include <glm/common.hpp>

#include "raster/base/portable_math.h"

namespace barrido::scene {
namespace {

using Interpolation = AnimationChannel::Interpolation;
using Path = AnimationChannel::Path;

glm::quat normalized(glm::quat q) {
  const float length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  if (!(length > 0.0f)) return {1, 0, 0, 0};
  return {q.w / length, q.x / length, q.y / length, q.z / length};
}

/// Spherical interpolation the shorter way round (glTF 2.0, appendix C.4).
glm::quat slerp(const glm::quat& from, const glm::quat& to, float t) {
  double cosine =
      double{from.w} * to.w + double{from.x} * to.x + double{from.y} * to.y + double{from.z} * to.z;
  const double sign = cosine < 0.0 ? -1.0 : 1.0;
  cosine *= sign;
  double from_weight = 1.0 - t;
  double to_weight = t;
  // Where the two are nearly the same, sines are nearly their angles, and 0/0 is near.
  if (cosine < 0.9999) {
    const double angle = portable_acos(cosine);
    const double sine = portable_sin(angle);
    from_weight = portable_sin(from_weight * angle) / sine;
    to_weight = portable_sin(to_weight * angle) / sine;
  }
  to_weight *= sign;
  const auto mix = [&](float a, float b) { return static_cast<float>(a * from_weight + b * to_weight); };
  return normalized({mix(from.w, to.w), mix(from.x, to.x), mix(from.y, to.y), mix(from.z, to.z)});
}

/// The two keys around a moment and where it lies between them.
struct Moment {
  std::size_t key = 0;
  std::size_t next = 0;
  float fraction = 0.0f;    ///< [0, 1]
  float duration_s = 0.0f;  ///< From key to next.
};

Moment find_moment(const std::vector<float>& times_s, double time_s) {
  const auto after = std::upper_bound(times_s.begin(), times_s.end(), time_s,
                                      [](double time, float key) { return time < key; });
  Moment moment;
  if (after == times_s.begin() || std::isnan(time_s)) return moment;
  moment.key = static_cast<std::size_t>(after - times_s.begin()) - 1;
  moment.next = std::min(moment.key + 1, times_s.size() - 1);
  moment.duration_s = times_s[moment.next] - times_s[moment.key];
  if (moment.duration_s > 0.0f) {
    const double fraction = (time_s - times_s[moment.key]) / moment.duration_s;
    moment.fraction = static_cast<float>(std::clamp(fraction, 0.0, 1.0));
  }
  return moment;
}

/// Hermite spline (glTF 2.0, appendix C.5). A key's values are in-tangents, points, out-tangents.
void cubic_spline(std::span<const float> values, const Moment& moment, std::span<float> out) {
  const std::size_t n = out.size();
  const float t = moment.fraction;
  const float t2 = t * t;
  const float t3 = t2 * t;
  const float* from = values.data() + moment.key * 3 * n;
  const float* to = values.data() + moment.next * 3 * n;
  for (std::size_t i = 0; i < n; ++i) {
    const float out_tangent = moment.duration_s * from[2 * n + i];
    const float in_tangent = moment.duration_s * to[i];
    out[i] = (2.0f * t3 - 3.0f * t2 + 1.0f) * from[n + i] + (t3 - 2.0f * t2 + t) * out_tangent +
             (-2.0f * t3 + 3.0f * t2) * to[n + i] + (t3 - t2) * in_tangent;
  }
}

/// The channel's numbers at a moment: 3, 4 or as many as there are morph targets.
void sample(const AnimationChannel& channel, const Moment& moment, std::span<float> out) {
  const std::size_t n = out.size();
  if (channel.interpolation == Interpolation::cubic_spline) {
    cubic_spline(channel.values, moment, out);
    return;
  }
  const float* from = channel.values.data() + moment.key * n;
  const float* to = channel.values.data() + moment.next * n;
  const float t = channel.interpolation == Interpolation::step ? 0.0f : moment.fraction;
  for (std::size_t i = 0; i < n; ++i) out[i] = from[i] * (1.0f - t) + to[i] * t;
}

glm::quat quat_at(const AnimationChannel& channel, std::size_t key) {
  const float* v = channel.values.data() + key * 4;
  return normalized({v[3], v[0], v[1], v[2]});
}

glm::quat sample_rotation(const AnimationChannel& channel, const Moment& moment) {
  if (channel.interpolation == Interpolation::linear) {
    return slerp(quat_at(channel, moment.key), quat_at(channel, moment.next), moment.fraction);
  }
  float v[4];
  sample(channel, moment, v);
  return normalized({v[3], v[0], v[1], v[2]});
}

void apply(const AnimationChannel& channel, double time_s, Transform& transform,
           std::vector<float>& weights) {
  if (channel.times_s.empty()) return;
  const Moment moment = find_moment(channel.times_s, time_s);
  switch (channel.path) {
    case Path::translation: {
      glm::vec3 translation;
      sample(channel, moment, std::span(&translation.x, 3));
      transform.translation = translation;
      break;
    }
    case Path::scale:
      sample(channel, moment, std::span(&transform.scale.x, 3));
      break;
    case Path::rotation:
      transform.rotation = sample_rotation(channel, moment);
      break;
    case Path::weights:
      sample(channel, moment, weights);
      break;
  }
}

/// Translation · rotation · scale (glTF 2.0, section 3.5.3).
glm::mat4 local_matrix(const Transform& transform) {
  if (transform.matrix) return glm::mat4(*transform.matrix);
  const glm::quat& q = transform.rotation;
  const float xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  const float xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
  const float wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  const glm::vec3& s = transform.scale;
  const glm::vec3 x_axis(1.0f - 2.0f * (yy + zz), 2.0f * (xy + wz), 2.0f * (xz - wy));
  const glm::vec3 y_axis(2.0f * (xy - wz), 1.0f - 2.0f * (xx + zz), 2.0f * (yz + wx));
  const glm::vec3 z_axis(2.0f * (xz + wy), 2.0f * (yz - wx), 1.0f - 2.0f * (xx + yy));
  return {glm::vec4(x_axis * s.x, 0), glm::vec4(y_axis * s.y, 0), glm::vec4(z_axis * s.z, 0),
          glm::vec4(glm::vec3(transform.translation), 1)};
}

/// The same with the translation, and all of a matrix, in double precision.
glm::dmat4 exact_local_matrix(const Transform& transform) {
  if (transform.matrix) return *transform.matrix;
  glm::dmat4 matrix(local_matrix(transform));
  matrix[3] = glm::dvec4(transform.translation, 1.0);
  return matrix;
}

/// Floats tell apart steps of 1/128 here. Beyond, translations that cancel would leave their rounding behind.
constexpr double kFar = 65536.0;

bool reaches_far(const std::vector<Transform>& transforms) {
  return std::any_of(transforms.begin(), transforms.end(), [](const Transform& transform) {
    return is_far(transform.matrix ? glm::dvec3((*transform.matrix)[3]) : transform.translation);
  });
}

/// The middle of what the nodes with meshes are at, where that is far away; in whole units, so that it can be
/// taken away without a rounding.
glm::dvec3 choose_origin(const Scene& scene, const std::vector<glm::dmat4>& world) {
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
  for (std::size_t i = 0; i < world.size(); ++i) {
    if (scene.nodes[i].mesh == kNone) continue;
    low = glm::min(low, glm::dvec3(world[i][3]));
    high = glm::max(high, glm::dvec3(world[i][3]));
  }
  const glm::dvec3 middle = glm::round(low * 0.5 + high * 0.5);
  return low.x <= high.x && is_far(middle) ? middle : glm::dvec3(0.0);
}

std::vector<float> standing_weights(const Scene& scene, const Node& node) {
  if (node.mesh == kNone) return {};
  return node.morph_weights.empty() ? scene.meshes[static_cast<std::size_t>(node.mesh)].morph_weights
                                    : node.morph_weights;
}

/// Parents before children; the stack is a list, so that no hierarchy is too deep.
template <class Matrix>
std::vector<Matrix> world_matrices(const Scene& scene, const std::vector<Transform>& transforms,
                                   Matrix (*local_matrix_of)(const Transform&)) {
  std::vector<Matrix> world(scene.nodes.size(), Matrix(1.0f));
  std::vector<int> waiting;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].parent == kNone) waiting.push_back(static_cast<int>(i));
  }
  while (!waiting.empty()) {
    const auto index = static_cast<std::size_t>(waiting.back());
    waiting.pop_back();
    const Node& node = scene.nodes[index];
    const Matrix local = local_matrix_of(transforms[index]);
    world[index] = node.parent == kNone ? local : world[static_cast<std::size_t>(node.parent)] * local;
    waiting.insert(waiting.end(), node.children.begin(), node.children.end());
  }
  return world;
}

void place_nodes(const Scene& scene, const std::vector<Transform>& transforms, Pose& pose) {
  if (!reaches_far(transforms)) {
    pose.world_from_node = world_matrices(scene, transforms, local_matrix);
    return;
  }
  pose.exact = world_matrices(scene, transforms, exact_local_matrix);
  pose.origin = choose_origin(scene, pose.exact);
  for (glm::dmat4 matrix : pose.exact) {
    matrix[3] -= glm::dvec4(pose.origin, 0.0);
    pose.world_from_node.emplace_back(matrix);
  }
}

}  // namespace

void sample_numbers(const AnimationChannel& channel, double time_s, std::span<float> out) {
  if (!channel.times_s.empty()) sample(channel, find_moment(channel.times_s, time_s), out);
}

bool is_far(const glm::dvec3& place) {
  return std::max({std::abs(place.x), std::abs(place.y), std::abs(place.z)}) >= kFar;
}

Pose pose_at(const Scene& scene, int animation, double time_s) {
  if (animation != kNone &&
      (animation < 0 || static_cast<std::size_t>(animation) >= scene.animations.size())) {
    throw std::out_of_range("there is no animation " + std::to_string(animation));
  }
  Pose pose;
  std::vector<Transform> transforms;
  transforms.reserve(scene.nodes.size());
  pose.morph_weights.reserve(scene.nodes.size());
  for (const Node& node : scene.nodes) {
    transforms.push_back(node.transform);
    pose.morph_weights.push_back(standing_weights(scene, node));
  }
  if (animation != kNone) {
    for (const AnimationChannel& channel : scene.animations[static_cast<std::size_t>(animation)].channels) {
      const auto node = static_cast<std::size_t>(channel.node);
      apply(channel, time_s, transforms[node], pose.morph_weights[node]);
    }
  }
  place_nodes(scene, transforms, pose);
  return pose;
}

glm::dmat4 file_world_from_node(const Pose& pose, std::size_t node) {
  return pose.exact.empty() ? glm::dmat4(pose.world_from_node[node]) : pose.exact[node];
}

}  // namespace barrido::scene
