// The loop over samples, above everything: one drawing for all of them where they differ only in where they
// lie in their pixels, else a drawing for each, at its moment and from its place on the lens (Haeberli and
// Akeley 1990). Draws nothing itself.
#pragma once

#include <functional>
#include <optional>

#include "pipeline/scene/lens.h"
#include "pipeline/scene/straight_alpha.h"

namespace barrido::scene {

/// One drawing of a frame.
struct SampleGo {
  const RenderSettings& settings;
  raster::SampleSettings* samples = nullptr;  ///< Null: one sample a pixel, at its centre.
  std::function<void(View&)> look = {};       ///< Changes the view before all else, unless empty.
  bool warns = true;                          ///< Says what is to be said of the frame.
};

/// Calls `draw` for each drawing in order. `lens` is only looked at where the settings have one.
void for_each_go(const RenderSettings& settings, const Lens& lens,
                 const std::function<void(const SampleGo&)>& draw);

/// What samples show where nothing was drawn, and what their alpha is.
void set_background(raster::SampleSettings& samples, const SceneFrame& frame,
                    const std::optional<Backing>& backing);

}  // namespace barrido::scene
