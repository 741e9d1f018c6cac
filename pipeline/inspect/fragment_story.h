// One fragment's story: names from the file, corners of its triangle, illumination. Enters: a traced fragment
// and the draw it belongs to; leaves: a FragmentStory. Knows nothing of the rest of the pixel.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "pipeline/assembled_frame.h"
#include "pipeline/inspect/fragment_census.h"
#include "pipeline/inspect/pixel_story.h"
#include "pipeline/scene/frame_observer.h"

namespace barrido::inspect {

struct FragmentContext {
  const scene::Scene& scene;
  const scene::ObservedFrame& frame;
  std::span<const std::string> light_names;
  int x = 0;  ///< Window coordinates.
  int y = 0;
};

/// Everything but the fate.
FragmentStory tell_fragment(const FragmentContext& context, const FrameChunk& place,
                            raster::reference::FragmentTrace trace);

/// The corners of the triangle or line in the file, and their weights at the pixel's centre.
std::vector<CornerStory> tell_corners(const FragmentContext& context, const FrameChunk& place,
                                      const raster::PrimitiveRecord& primitive, std::uint32_t source);

}  // namespace barrido::inspect
