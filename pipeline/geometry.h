// Vertex arrays of one draw: views of the caller's memory, in object space. As glDrawArrays and
// glDrawElements.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "raster/fragments/fragment_state.h"

namespace barrido::pipeline {

/// OpenGL's primitive modes in the order of their constants.
enum class PrimitiveMode : std::uint8_t {
  points,
  lines,
  line_loop,
  line_strip,
  triangles,
  triangle_strip,
  triangle_fan,
  quads,
  quad_strip,
  polygon,
};

/// An attribute array: `count` elements of `components` floats, `stride` floats apart. Absent when data is
/// null.
struct Attribute {
  const float* data = nullptr;
  int components = 0;  ///< 2, 3 or 4; missing ones are (0, 0, 0, 1).
  int stride = 0;      ///< Floats from one element to the next.
};

struct Geometry {
  PrimitiveMode mode = PrimitiveMode::triangles;
  std::uint32_t vertex_count = 0;
  Attribute position;  ///< 2 to 4 components, object space.
  Attribute normal;    ///< 3 components, object space.
  /// For normal and bump maps, object space: how the place changes with the two coordinates of the map, in
  /// the eye's own orientation of them. The bitangent may be left out; then it is w (normal × tangent), w = 1
  /// where the tangent has 3 components.
  Attribute tangent;                                         ///< 3 or 4 components.
  Attribute bitangent;                                       ///< 3 components.
  Attribute color;                                           ///< 3 or 4 components.
  std::array<Attribute, raster::kMaxTextureUnits> texcoord;  ///< 2 to 4 components, per unit.
  /// Values used for every vertex where the array is absent (glNormal, glColor, glTexCoord).
  glm::vec3 constant_normal{0, 0, 1};
  glm::vec4 constant_color{1, 1, 1, 1};
  std::array<glm::vec4, raster::kMaxTextureUnits> constant_texcoord{
      glm::vec4{0, 0, 0, 1}, glm::vec4{0, 0, 0, 1}, glm::vec4{0, 0, 0, 1}, glm::vec4{0, 0, 0, 1}};
  /// Every index must be below vertex_count (checked). Empty: vertices 0, 1, 2, … in order.
  std::span<const std::uint32_t> indices;
};

}  // namespace barrido::pipeline
