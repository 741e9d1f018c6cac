// The illumination model at one place, taken apart into the shares of its lights. Enters: a compiled
// illumination and a surface point; leaves: an IlluminationStory. The shares are asked from the kernels that
// draw, one light and one term at a time (the model is a sum, and a sum's other terms can be set to zero);
// so there is no second formula that could differ.
#pragma once

#include <span>

#include "pipeline/cheap_phong.h"
#include "pipeline/illumination.h"
#include "pipeline/inspect/pixel_story.h"

namespace barrido::inspect {

/// A surface point in eye space.
struct LitPoint {
  glm::vec3 position{0, 0, 0};
  glm::vec3 normal{0, 0, 1};
  glm::vec4 color{1, 1, 1, 1};  ///< Of the vertices, where the material tracks it.
  bool normalize = false;       ///< As SurfacePoints::normalize.
  bool back = false;
};

/// What the lights are called and what they and the material are made of, before they are multiplied.
struct LightingNames {
  const pipeline::Lighting& lighting;
  std::span<const std::string> names;  ///< One a light.
};

IlluminationStory explain_illumination(const pipeline::Illumination& illumination, const LitPoint& point,
                                       const LightingNames& names);

/// Fills LightStory::products of a corner's story.
void add_products(const pipeline::Illumination& illumination, const LitPoint& point,
                  IlluminationStory& story);

/// The model from interpolated dot products (cheap Phong); `dots` as cheap_phong_dots writes them, one number
/// a column.
IlluminationStory explain_products(const pipeline::Illumination& illumination, std::span<const float> dots,
                                   const glm::vec4& color, bool back, const LightingNames& names);

}  // namespace barrido::inspect
