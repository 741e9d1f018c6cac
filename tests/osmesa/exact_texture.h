// Texture coordinates and level of detail of a pixel in double precision, to know where a nearest filter, a
// choice of level or of a cube's face is a near tie, and how far two levels lie apart.
#pragma once

#include <optional>

#include "tests/osmesa/exact_triangle.h"

namespace barrido::crosscheck {

/// What the level of detail of an implementation may differ from the ideal (measured: 0.061).
inline constexpr double kLodSlack = 0.07;

struct SampleRule {
  bool tie = false;        ///< Another texel or level is as good.
  double allowance = 0.0;  ///< Of the result, in 1/255, for a level of detail that is a little different.
};

/// One unit of a draw.
class ExactUnit {
 public:
  ExactUnit(const DrawCall& draw, std::size_t unit);
  SampleRule rule_at(const ExactTriangle& triangle, double x, double y) const;
  /// The filtered texel, where all filters are linear.
  std::optional<std::array<double, 4>> texel_at(const ExactTriangle& triangle, double x, double y) const;

 private:
  struct Place {
    double u = 0, v = 0, lod = 0;
    int face = 0;
    bool face_tie = false;
  };
  Place place_at(const ExactTriangle& triangle, double x, double y) const;
  Place cube_place(const glm::dvec4& at, const glm::dvec4& dx, const glm::dvec4& dy) const;
  double lod_of(double ux, double vx, double uy, double vy) const;
  bool near_texel_edge(const Place& place, int level) const;
  std::array<double, 4> bilinear(const Place& place, int level) const;
  double level_difference(const Place& place, int level) const;
  /// What a linear filter changes when the surface moves by what snapping vertices to 1/256 pixel can move
  /// it.
  double snapping_difference(const ExactTriangle& triangle, double x, double y, const Place& place,
                             int level) const;

  const raster::TextureUnit& unit_;
  const raster::Texture& texture_;
  std::vector<glm::dvec4> coordinates_;  ///< Of every vertex, after generation and matrix.
};

}  // namespace barrido::crosscheck
