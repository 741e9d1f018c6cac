// Normals for surfaces that have none. Enters: positions and a triangle list; leaves: a new set of vertices,
// each a copy of an old one with a normal, because a vertex on an edge needs one normal a side.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace barrido::scene {

struct NormalSplit {
  std::vector<std::uint32_t> source;   ///< Of each new vertex, the vertex whose other attributes it has.
  std::vector<float> normals;          ///< 3 floats a new vertex, unit length
  std::vector<std::uint32_t> indices;  ///< The same triangles in the same order, of new vertices
};

/// glTF's rule (2.0, section 3.7.2.1): every triangle has its own three vertices with the face's normal.
/// `positions` has 3 floats a vertex. A triangle without area gets (0, 0, 1).
NormalSplit flat_normals(std::span<const float> positions, std::span<const std::uint32_t> triangles);

/// The course's rule (S2, S3): at each corner the sum, weighted by area, of the normals of those triangles
/// around the same point whose normal is within `crease_angle_deg` [0, 180] of the corner's own triangle's.
/// Vertices with equal positions count as one point, so that seams in the texture coordinates do not show.
NormalSplit averaged_normals(std::span<const float> positions, std::span<const std::uint32_t> triangles,
                             double crease_angle_deg);

}  // namespace barrido::scene
