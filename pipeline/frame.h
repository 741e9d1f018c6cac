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
      : size{framebuffer.width(), framebuffer.height()},
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
  AssembledFrame* record = nullptr;  ///< Where draws are remembered, or null.
};

/// One draw, from object space to the rasterizer's queue. See Renderer::draw.
void draw(Frame& frame, const State& state, const Geometry& geometry);

}  // namespace barrido::pipeline
