// Vertex arrays ready for drawing. Enters: primitives; leaves: views of their own memory where possible, of
// arrays made here where normals are missing, vertices are deformed or colours are scaled. Knows no state.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "pipeline/geometry.h"
#include "pipeline/scene/animate.h"
#include "pipeline/scene/scene.h"
#include "pipeline/scene/texture_placement.h"

namespace barrido::scene {

/// What a draw's tangents are made for.
struct TangentUse {
  int texcoord_set = 0;
  glm::mat3 transform{1.0f};  ///< Of the coordinates, (u, v, 1)
  /// P_u and P_v for bump maps; else unit vectors, those of the file where it has them.
  bool with_lengths = false;
};

/// What displacement has made of a primitive; see displacement.h.
struct Displaced {
  int pieces = 0;  ///< That each edge was cut into; 0: none, it is not displaced.
  std::size_t triangles = 0;
  std::vector<float> amount;  ///< How far each vertex was moved along its normal.
};

/// One primitive's arrays. `geometry` and `texcoord_sets` point into the primitive or into the arrays below.
struct PreparedGeometry {
  PreparedGeometry() = default;
  PreparedGeometry(const PreparedGeometry&) = delete;
  PreparedGeometry& operator=(const PreparedGeometry&) = delete;

  pipeline::Geometry geometry;  ///< Texture coordinates and colours are left for the material to choose.
  std::array<pipeline::Attribute, 2> texcoord_sets;
  pipeline::Attribute colors;  ///< 4 floats a vertex, or absent
  glm::vec3 center{0, 0, 0};   ///< Middle of the bounding box, in the positions' space
  pipeline::Attribute rest;    ///< Positions in the pose of the file

  Displaced displaced;
  DeformedVertices deformed;
  std::vector<float> positions, normals, tangents, bitangents, rest_positions;
  std::array<std::vector<float>, 2> texcoords;
  std::vector<float> own_colors;
  std::vector<std::uint32_t> indices;
  std::vector<std::uint32_t> rewound;  ///< Triangles of a skin that mirrors some of them
  std::map<std::array<float, 4>, std::vector<float>> scaled_colors;
};

/// The primitive as it is in the file. Surfaces without normals get flat ones, or averaged ones where a
/// crease angle is given.
std::unique_ptr<PreparedGeometry> prepare(const Primitive& primitive, std::optional<float> crease_angle_deg);

/// The primitive with these vertices in place of its own.
std::unique_ptr<PreparedGeometry> prepare_deformed(const Primitive& primitive, DeformedVertices deformed,
                                                   std::optional<float> crease_angle_deg);

/// The prepared primitive with tangents of its own; null where it has no surface, no normals or no such
/// coordinates. Where a vertex needs two tangents it becomes two.
std::unique_ptr<PreparedGeometry> prepare_tangents(const PreparedGeometry& prepared, const TangentUse& use);

/// Whether what the file gives is what the use asks for.
bool has_tangents(const PreparedGeometry& prepared, const TangentUse& use);

/// The colours times `scale`, made once; the array itself when the scale is 1. Absent when there are none.
pipeline::Attribute colors_times(PreparedGeometry& prepared, const glm::vec4& scale);

/// Primitives that are not deformed, each prepared once.
class GeometryCache {
 public:
  explicit GeometryCache(const Scene& scene) : scene_(scene) {}
  PreparedGeometry& get(int mesh, int primitive, std::optional<float> crease_angle_deg);
  /// The same with tangents; null as prepare_tangents.
  PreparedGeometry* get(int mesh, int primitive, std::optional<float> crease_angle_deg,
                        const TangentUse& use);
  /// Of all primitives of the mesh, in the pose of the file.
  const Box& box_of(int mesh);

 private:
  const Scene& scene_;
  using Key = std::tuple<int, int, float>;
  std::map<Key, std::unique_ptr<PreparedGeometry>> prepared_;
  std::map<std::tuple<Key, int, bool, std::array<float, 9>>, std::unique_ptr<PreparedGeometry>>
      with_tangents_;
  std::map<int, Box> boxes_;
};

}  // namespace barrido::scene
