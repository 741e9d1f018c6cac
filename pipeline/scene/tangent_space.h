// Tangents for normal and bump maps, by the algorithm of MikkTSpace (Mikkelsen 2008, "Simulation of wrinkled
// surfaces revisited"), which glTF asks for where a file has none: those who make normal maps use it too, and
// a map looks right only with the tangents it was made for. Enters: triangles; leaves: tangents of their
// corners. The same bits everywhere: no library's arc cosine, no fused multiply-add.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace barrido::scene {

struct TexturedTriangles {
  std::span<const float> positions;          ///< 3 floats a vertex
  std::span<const float> normals;            ///< 3 floats a vertex, unit length
  std::span<const float> coordinates;        ///< 2 floats a vertex, t upwards: of glTF's v, 1 − v
  std::span<const std::uint32_t> triangles;  ///< 3 a triangle
};

/// Of a corner: unit vectors in the plane of its normal along which s and t grow, and how far the place moves
/// for 1 of each.
struct CornerTangent {
  glm::vec3 tangent{1, 0, 0}, bitangent{0, 1, 0};
  float tangent_length = 1.0f, bitangent_length = 1.0f;
  bool keeps_orientation = false;  ///< The coordinates run counter-clockwise where the triangle does.

  /// glTF's w: bitangent = w (normal × tangent).
  float sign() const { return keeps_orientation ? 1.0f : -1.0f; }
};

/// One a corner, in the order of `triangles`. Corners that share position, normal and coordinates, whose
/// triangles meet in edges and whose coordinates are not mirrored, have the same tangent: the mean of the
/// triangles', weighted by their angles there. A vertex on a mirrored seam has two. Corners of triangles with
/// two equal places have what another triangle gives that vertex; the others of no use keep the values above.
/// What MikkTSpace calls an angular threshold is not here: its default of 180° lets all pass.
std::vector<CornerTangent> corner_tangents(const TexturedTriangles& mesh);

}  // namespace barrido::scene
