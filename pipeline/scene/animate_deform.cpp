// Deformed vertices: morph targets are added, then the skin's joints carry each vertex into world space.
// Vertices are independent of each other, so that any number of threads gives the same bits.
#include <algorithm>
#include <cmath>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "pipeline/scene/animate.h"

namespace barrido::scene {
namespace {

constexpr std::size_t kVerticesAChunk = 2048;

template <typename Work>
void for_chunks(std::size_t vertex_count, Work work) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, vertex_count, kVerticesAChunk),
                    [&](const tbb::blocked_range<std::size_t>& range) { work(range.begin(), range.end()); });
}

void add_target(const FloatArray& target, float weight, std::vector<float>& values) {
  if (weight == 0.0f || target.size() != values.size()) return;
  const float* differences = target.data();
  for_chunks(values.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) values[i] += weight * differences[i];
  });
}

/// As above, for what few targets have: copied from `base` when the first one does.
void add_target(const FloatArray& target, float weight, const FloatArray& base, std::vector<float>& values) {
  if (weight == 0.0f || target.empty() || target.size() != base.size()) return;
  if (values.empty()) values.assign(base.values().begin(), base.values().end());
  add_target(target, weight, values);
}

/// Tangents have a fourth number, which stays.
void add_tangents(const FloatArray& target, float weight, std::vector<float>& tangents) {
  if (weight == 0.0f || target.size() / 3 != tangents.size() / 4) return;
  for (std::size_t i = 0; i < target.size(); ++i) tangents[i / 3 * 4 + i % 3] += weight * target.data()[i];
}

void morph(const Primitive& primitive, const std::vector<float>& weights, DeformedVertices& vertices) {
  const std::size_t count = std::min(weights.size(), primitive.morph_targets.size());
  for (std::size_t i = 0; i < count; ++i) {
    const MorphTarget& target = primitive.morph_targets[i];
    add_target(target.positions, weights[i], vertices.positions);
    add_target(target.normals, weights[i], vertices.normals);
    if (!target.tangents.empty()) add_tangents(target.tangents, weights[i], vertices.tangents);
    add_target(target.colors, weights[i], primitive.colors, vertices.colors);
    for (std::size_t set = 0; set < target.texcoords.size(); ++set) {
      add_target(target.texcoords[set], weights[i], primitive.texcoords[set], vertices.texcoords[set]);
    }
  }
  // Colours are clamped after all targets (glTF 2.0, section 3.7.2.2).
  for (float& value : vertices.colors) value = std::clamp(value, 0.0f, 1.0f);
}

/// World from skinned vertex, for each joint (glTF 2.0, section 3.7.3.3).
std::vector<glm::mat4> joint_matrices(const Skin& skin, const Pose& pose) {
  std::vector<glm::mat4> matrices(skin.joints.size());
  for (std::size_t i = 0; i < matrices.size(); ++i) {
    const auto joint = static_cast<std::size_t>(skin.joints[i]);
    if (pose.exact.empty()) {
      matrices[i] = pose.world_from_node[joint] * skin.inverse_bind_matrices[i];
      continue;
    }
    glm::dmat4 matrix = pose.exact[joint] * glm::dmat4(skin.inverse_bind_matrices[i]);
    matrix[3] -= glm::dvec4(pose.origin * matrix[3].w, 0.0);
    matrices[i] = glm::mat4(matrix);
  }
  return matrices;
}

/// Carries a normal: the transposed inverse times the determinant's size, which the later normalisation takes
/// away. Unlike the inverse it exists for every matrix.
glm::vec3 carry_normal(const glm::mat4& matrix, const glm::vec3& normal) {
  const glm::vec3 x(matrix[0]), y(matrix[1]), z(matrix[2]);
  const glm::vec3 yz = glm::cross(y, z);
  const float sign = glm::dot(x, yz) < 0.0f ? -1.0f : 1.0f;
  return (yz * normal.x + glm::cross(z, x) * normal.y + glm::cross(x, y) * normal.z) * sign;
}

/// Directions in the surface go with its places. Where the matrix mirrors, so do normal × tangent, and w says
/// so.
void carry_tangent(const glm::mat4& matrix, float* tangent) {
  const glm::vec3 carried = glm::mat3(matrix) * glm::vec3(tangent[0], tangent[1], tangent[2]);
  for (int axis = 0; axis < 3; ++axis) tangent[axis] = carried[axis];
  if (glm::determinant(glm::mat3(matrix)) < 0.0f) tangent[3] = -tangent[3];
}

bool mirrors(const glm::mat4& matrix) { return glm::determinant(glm::mat3(matrix)) < 0.0f; }

glm::vec3 load(const std::vector<float>& values, std::size_t vertex) {
  return {values[3 * vertex], values[3 * vertex + 1], values[3 * vertex + 2]};
}

void store(const glm::vec3& value, std::vector<float>& values, std::size_t vertex) {
  for (int c = 0; c < 3; ++c) values[3 * vertex + static_cast<std::size_t>(c)] = value[c];
}

void apply_skin(const Primitive& primitive, const std::vector<glm::mat4>& joints,
                DeformedVertices& vertices) {
  std::vector<std::uint8_t> mirrored;  // Bytes, since threads cannot share a word of bits.
  if (std::any_of(joints.begin(), joints.end(), mirrors)) mirrored.resize(primitive.vertex_count);
  for_chunks(primitive.vertex_count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const float* weights = primitive.weights.data() + 4 * i;
      glm::mat4 matrix(0.0f);
      for (std::size_t j = 0; j < 4; ++j) {
        if (weights[j] != 0.0f) matrix += joints[primitive.joints[i][j]] * weights[j];
      }
      if (!mirrored.empty()) mirrored[i] = mirrors(matrix) ? 1 : 0;
      store(glm::vec3(matrix * glm::vec4(load(vertices.positions, i), 1.0f)), vertices.positions, i);
      if (!vertices.normals.empty()) {
        store(carry_normal(matrix, load(vertices.normals, i)), vertices.normals, i);
      }
      if (!vertices.tangents.empty()) carry_tangent(matrix, vertices.tangents.data() + 4 * i);
    }
  });
  if (std::find(mirrored.begin(), mirrored.end(), 1) == mirrored.end()) return;
  vertices.mirrored.assign(mirrored.begin(), mirrored.end());
}

/// Unit length; in double precision, since a normal carried through a small matrix is smaller still. A normal
/// of no length stays.
void normalize(std::vector<float>& normals) {
  for_chunks(normals.size() / 3, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = 3 * begin; i < 3 * end; i += 3) {
      const double x = normals[i], y = normals[i + 1], z = normals[i + 2];
      const double length = std::sqrt(x * x + y * y + z * z);
      if (!(length > 0.0)) continue;
      normals[i] = static_cast<float>(x / length);
      normals[i + 1] = static_cast<float>(y / length);
      normals[i + 2] = static_cast<float>(z / length);
    }
  });
}

bool has_skin(const Scene& scene, int node, const Primitive& primitive) {
  return scene.nodes[static_cast<std::size_t>(node)].skin != kNone && !primitive.joints.empty();
}

}  // namespace

bool is_deformed(const Scene& scene, int node, const Primitive& primitive) {
  return !primitive.morph_targets.empty() || has_skin(scene, node, primitive);
}

DeformedVertices deform(const Scene& scene, const Pose& pose, int node, const Primitive& primitive) {
  DeformedVertices vertices;
  vertices.positions.assign(primitive.positions.values().begin(), primitive.positions.values().end());
  vertices.normals.assign(primitive.normals.values().begin(), primitive.normals.values().end());
  vertices.tangents.assign(primitive.tangents.values().begin(), primitive.tangents.values().end());
  morph(primitive, pose.morph_weights[static_cast<std::size_t>(node)], vertices);
  if (has_skin(scene, node, primitive)) {
    const int skin = scene.nodes[static_cast<std::size_t>(node)].skin;
    apply_skin(primitive, joint_matrices(scene.skins[static_cast<std::size_t>(skin)], pose), vertices);
    vertices.in_world_space = true;
  }
  normalize(vertices.normals);
  return vertices;
}

}  // namespace barrido::scene
