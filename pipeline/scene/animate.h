// Poses: node matrices and deformed vertices of a scene at one moment (animation, morph targets, skins).
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "pipeline/scene/scene.h"

namespace barrido::scene {

/// Where nodes are moved so far that floats would lose the model's own shape (coordinates of maps), the world
/// is the file's about an origin near what is drawn.
struct Pose {
  std::vector<glm::mat4> world_from_node;         ///< One a node; about `origin`.
  glm::dvec3 origin{0, 0, 0};                     ///< In the file's world.
  std::vector<glm::dmat4> exact;                  ///< File's world from node; empty where floats will do.
  std::vector<std::vector<float>> morph_weights;  ///< One a node with a mesh; empty otherwise.
};

/// The channel's numbers at a moment, as its interpolation says, each by itself: no rotations. `out` has as
/// many as a key has values; they stay as they are where the channel has no keys.
void sample_numbers(const AnimationChannel& channel, double time_s, std::span<float> out);

/// Whether a place is so far from the origin that steps between floats become coarse (1/128).
bool is_far(const glm::dvec3& place);

/// The node's matrix in the file's own world.
glm::dmat4 file_world_from_node(const Pose& pose, std::size_t node);

/// The scene at `time_s` of animation `animation` (kNone: as it stands). Times beyond the keys are clamped.
/// @throws std::out_of_range when there is no such animation.
Pose pose_at(const Scene& scene, int animation, double time_s);

struct DeformedVertices {
  std::vector<float> positions;  ///< 3 floats a vertex
  std::vector<float> normals;    ///< 3 floats a vertex, unit length; empty when the primitive has none
  std::vector<float> tangents;   ///< 4 floats a vertex; empty when the primitive has none
  std::array<std::vector<float>, 2> texcoords;  ///< 2 floats a vertex; empty where no target moves them
  std::vector<float> colors;                    ///< 4 floats a vertex; empty where no target changes them
  /// Vertices whose joints turn left into right, so that the triangle they belong to is wound the other way;
  /// empty where there are none.
  std::vector<bool> mirrored;
  bool in_world_space = false;  ///< Skinned vertices are; the node's matrix must not be applied again.
};

/// True when the primitive, as used by the node, must be deformed before drawing.
bool is_deformed(const Scene& scene, int node, const Primitive& primitive);

/// Morph targets first, then the skin (glTF 2.0, sections 3.7.2.2 and 3.7.3.3).
DeformedVertices deform(const Scene& scene, const Pose& pose, int node, const Primitive& primitive);

}  // namespace barrido::scene
