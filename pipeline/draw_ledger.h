// What a draw is counted and remembered by: the statistics of the frame, and the frame's draws for those who
// explain pixels. Drawing needs none of it.
#pragma once

#include <memory>
#include <vector>

#include "pipeline/assembly.h"
#include "pipeline/frame.h"
#include "raster/tiles/binning.h"

namespace barrido::pipeline {

struct AssembledDraw;

/// Primitives on their way to the rasterizer.
struct Run {
  std::vector<std::unique_ptr<raster::BinnedChunk>> chunks;
  std::vector<std::vector<std::uint32_t>> sources;  ///< See Assembled.
  AssemblyCounts counts;
};

class DrawLedger {
 public:
  DrawLedger(Frame& frame, const DrawPlan& plan, const State& state, const Geometry& geometry);

  bool wants_sources() const { return kept_ != nullptr; }
  void add(const TransformedVertices& vertices);
  /// Before the run is submitted.
  void add(const Run& run);

 private:
  Frame& frame_;
  const DrawPlan& plan_;
  AssembledDraw* kept_ = nullptr;  // null where nobody asked for the frame's draws
};

}  // namespace barrido::pipeline
