// Poses: node matrices and deformed vertices of a scene at one moment (animation, morph targets, skins).
#pragma once

#include <vector>

#include <glm/mat4x4.hpp>

#include "pipeline/scene/scene.h"

namespace barrido::scene {

struct Pose {
  std::vector<glm::mat4> world_from_node;         ///< One a node.
  std::vector<std::vector<float>> morph_weights;  ///< One a node with a mesh; empty otherwise.
};

/// The scene at `time_s` of animation `animation` (kNone: as it stands). Times beyond the keys are clamped.
/// @throws std::out_of_range when there is no such animation.
Pose pose_at(const Scene& scene, int animation, double time_s);

struct DeformedVertices {
  std::vector<float> positions;  ///< 3 floats a vertex
  std::vector<float> normals;    ///< 3 floats a vertex, unit length; empty when the primitive has none
  bool in_world_space = false;   ///< Skinned vertices are; the node's matrix must not be applied again.
};

/// True when the primitive, as used by the node, must be deformed before drawing.
bool is_deformed(const Scene& scene, int node, const Primitive& primitive);

/// Morph targets first, then the skin (glTF 2.0, sections 3.7.2.2 and 3.7.3.3).
DeformedVertices deform(const Scene& scene, const Pose& pose, int node, const Primitive& primitive);

}  // namespace barrido::scene
