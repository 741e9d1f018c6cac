// The vertex stage and the sorting of triangles once more, one vertex and one triangle at a time and in plain
// numbers: what pipeline/kernels computes on vectors, bit for bit.
#pragma once

#include <array>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "pipeline/draw_plan.h"
#include "pipeline/packed_position.h"

namespace barrido::pipeline::reference {

/// A vertex in the window. See project_positions().
struct ProjectedVertex {
  glm::vec4 object{0};  ///< (0, 0, 0, 0) where the position was not a sensible number.
  float depth = 0.0f;
  float q = 1.0f;  ///< 1/w
  PackedPosition position;
};
ProjectedVertex project(const VertexTransform& transform, const glm::vec4& object);

/// A vertex in eye space. See transform_to_eye().
struct EyeVertex {
  glm::vec4 eye{0};
  glm::vec3 point{0};  ///< Divided by w.
};
EyeVertex to_eye(const VertexTransform& transform, const glm::vec4& object);

/// See transform_normals().
glm::vec3 eye_normal(const VertexTransform& transform, const glm::vec3& normal);

/// A vertex's tangents in object space; the tangent's w counts where there is no bitangent.
struct TangentVertex {
  glm::vec4 tangent{1, 0, 0, 1};
  glm::vec3 bitangent{0}, normal{0};
};
struct EyeTangents {
  glm::vec3 tangent{0}, bitangent{0};
};
/// See transform_tangents().
EyeTangents eye_tangents(const VertexTransform& transform, const TangentVertex& vertex, bool has_bitangent,
                         bool to_unit);

/// What texture generation reads of a vertex.
struct TexgenVertex {
  glm::vec4 object{0}, eye{0};
  glm::vec3 point{0}, normal{0};
};
/// See generate_coordinates().
glm::vec4 generate_coordinates(const TextureCoordinates& rules, const TexgenVertex& vertex,
                               glm::vec4 coordinate);

/// See TriangleClasses.
struct TriangleClass {
  bool visible = false;
  bool clipped = false;
  bool back = false;
};
TriangleClass classify(const std::array<PackedPosition, 3>& corners, const CullRule& rule);

}  // namespace barrido::pipeline::reference
