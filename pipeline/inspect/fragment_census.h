// Every fragment of a frame sent through the tests that decide what is shaded and what is seen, in drawing
// order, on any number of threads. Enters: an observed frame; leaves: calls. Computes no colours (but for
// alpha tests, which need one). Knows no view.
#pragma once

#include <functional>
#include <vector>

#include "pipeline/scene/frame_observer.h"
#include "raster/reference/fragment_walk.h"

namespace barrido::inspect {

/// A chunk of a frame with its draw.
struct FrameChunk {
  const pipeline::AssembledDraw* draw = nullptr;
  const scene::DrawOrigin* origin = nullptr;
  const pipeline::AssembledChunk* chunk = nullptr;
};

/// In drawing order.
std::vector<FrameChunk> chunks_of(const scene::ObservedFrame& frame);

/// A fragment that somebody is told of.
struct CensusFragment {
  const raster::reference::FragmentPlace& place;
  const FrameChunk& chunk;
  std::size_t pixel;  ///< In the frame's order, top row first.
};

/// What is told, on several threads at once, but of each pixel by one only and in drawing order.
struct CensusEvents {
  std::function<void(const CensusFragment&)> covered;  ///< Every fragment, hidden ones included.
  std::function<void(const CensusFragment&)> shaded;   ///< Passed the depth test.
  std::function<void(const CensusFragment&)> drawn;    ///< Passed the alpha test too: changed the frame.
};

/// Absent events cost nothing.
void take_census(const scene::ObservedFrame& frame, const std::vector<FrameChunk>& chunks,
                 const CensusEvents& events);

}  // namespace barrido::inspect
