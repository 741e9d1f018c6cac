// What a renderer holds of the frame that is being drawn.
#pragma once

#include <deque>

#include "pipeline/draw_plan.h"
#include "pipeline/frame_memory.h"
#include "pipeline/renderer.h"

namespace barrido::pipeline {

struct AssembledFrame;

struct Frame {
  Frame(raster::Framebuffer& framebuffer, const raster::RasterizerOptions& options)
      : size{framebuffer.width(), framebuffer.height(),
             options.samples != nullptr ? options.samples->reach() : raster::SampleReach{}},
        rasterizer(framebuffer, options),
        profile(options.profile) {}

  FrameSize size;
  raster::Rasterizer rasterizer;
  raster::StageProfile* profile;  ///< Null: no clock is read.
  FrameMemory memory;             ///< Vertices of the draws so far.
  std::deque<DrawPlan> plans;     ///< Of the draws so far; the rasterizer points to them.
  FragmentCounters fragment_counters;
  std::uint64_t powers_before_fragments = 0;
  Statistics statistics;
  AssembledFrame* kept = nullptr;  ///< Where draws are remembered, or null.

  /// Once the rasterizer holds nothing any more that points to the draws.
  void release_draws();
};

/// One draw, from object space to the rasterizer's queue. See Renderer::draw.
void draw(Frame& frame, const State& state, const Geometry& geometry);

/// All draws, from the queue to the framebuffer. See Renderer::finish.
void finish(Frame& frame);

}  // namespace barrido::pipeline
