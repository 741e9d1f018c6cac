// The illumination model at one place, taken apart into the shares of its lights. Enters: a compiled
// illumination and a surface point; leaves: an IlluminationStory. The shares are asked from the reference,
// one light and one term at a time (the model is a sum, and a sum's other terms can be set to zero); so there
// is no second formula that could differ.
#pragma once

#include <span>

#include "pipeline/cheap_phong.h"
#include "pipeline/inspect/pixel_story.h"
#include "pipeline/reference/illumination.h"

namespace barrido::inspect {

/// What the lights are called and what they and the material are made of, before they are multiplied.
struct LightingNames {
  const pipeline::Lighting& lighting;
  std::span<const std::string> names;  ///< One a light.
};

IlluminationStory explain_illumination(const pipeline::Illumination& illumination,
                                       const pipeline::reference::SurfacePoint& point,
                                       const LightingNames& names);

/// Fills LightStory::products of a corner's story.
void add_products(const pipeline::Illumination& illumination, const pipeline::reference::SurfacePoint& point,
                  IlluminationStory& story);

/// The model from interpolated dot products (cheap Phong); of the point only colour and side count.
IlluminationStory explain_products(const pipeline::Illumination& illumination, std::span<const float> dots,
                                   const pipeline::reference::SurfacePoint& point,
                                   const LightingNames& names);

}  // namespace barrido::inspect
