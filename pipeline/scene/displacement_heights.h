// Internal to displacement: the heights that a picture or a procedure has at a place of a surface. Enters: a
// prepared primitive; knows no subdivision.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "pipeline/scene/displacement.h"
#include "raster/fragments/fragment_state.h"

namespace barrido::scene {

/// The first three components of an element.
glm::dvec3 vector3(const pipeline::Attribute& attribute, std::uint32_t vertex);

/// Where a vertex lies on the height map's picture.
glm::vec2 place_on_heights(const PreparedGeometry& geometry, const HeightMap& heights, std::uint32_t vertex);

/// Mean length of the triangles' edges on the picture, in texels.
double mean_edge_texels(const PreparedGeometry& geometry, const HeightMap& heights,
                        const std::vector<std::uint32_t>& triangles);

/// Mean length of the triangles' edges in the pose of the file.
double mean_edge_length(const PreparedGeometry& geometry, const std::vector<std::uint32_t>& triangles);

/// Heights of a procedure about the object at rest, averaged over the distance of the points. A cell is an
/// eighth of the object where the choice does not say.
class SolidHeights {
 public:
  SolidHeights(const PreparedGeometry& geometry, SolidTexture solid);

  /// Points are so many of the object's units apart.
  void set_distance(double length) {
    for (float& extent : extent_) extent = static_cast<float>(length * cells_a_unit_);
  }
  double cells_a_unit() const { return cells_a_unit_; }

  double at(const glm::dvec3& place) const;

 private:
  raster::Pattern pattern_;
  glm::dmat4 pattern_from_object_{1.0};
  double cells_a_unit_ = 1.0;
  float extent_[3] = {0, 0, 0};
};

/// Heights of a picture, filtered as coarsely as the fine triangles are.
class PictureHeights {
 public:
  PictureHeights(const HeightMap& heights, double texels_apart);

  double at(const glm::dvec2& uv) const;

 private:
  raster::TextureUnit unit_;
  float lod_ = 0.0f;
};

}  // namespace barrido::scene
