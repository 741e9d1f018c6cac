// The illumination model and cheap Phong once more, at one point and in plain floats: what pipeline/kernels
// computes on vectors, bit for bit. Slow, and meant to be read; the stories of pixels take their numbers from
// it.
#pragma once

#include <array>
#include <span>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "pipeline/illumination.h"

namespace barrido::pipeline::reference {

/// A point of a surface, eye space. See SurfacePoints.
struct SurfacePoint {
  glm::vec3 normal{0, 0, 1};
  glm::vec3 position{0, 0, 0};
  glm::vec4 color{1, 1, 1, 1};
  bool normalize = false;
  bool back = false;
  std::span<const float> visibility{};  ///< One a light, or none.
  std::span<const float> occlusion{};   ///< One number, or none.
};

/// Not clamped. `secondary` is 0 unless Illumination::separate_specular.
struct LitColor {
  std::array<float, 4> primary{};
  std::array<float, 3> secondary{};
};

LitColor illuminate(const Illumination& illumination, const SurfacePoint& point);

/// As cheap_phong_dots(): `dots` holds cheap_phong_varyings() numbers; fewer leave out the ambient ones.
void cheap_phong_dots(const Illumination& illumination, const SurfacePoint& point, std::span<float> dots);

/// As cheap_phong_colors(). Of the point only the colour, the side and the visibility count.
LitColor cheap_phong_color(const Illumination& illumination, std::span<const float> dots,
                           const SurfacePoint& point);

}  // namespace barrido::pipeline::reference
