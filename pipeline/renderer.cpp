#include "pipeline/renderer.h"

#include "pipeline/assembled_frame.h"
#include "pipeline/frame.h"
#include "raster/tiles/binning.h"

namespace barrido::pipeline {

struct Renderer::Implementation {
  Frame frame;

  Implementation(raster::Framebuffer& framebuffer, const raster::RasterizerOptions& options,
                 AssembledFrame* kept)
      : frame(framebuffer, options) {
    frame.kept = kept;
  }
};

void Frame::release_draws() {
  plans.clear();
  memory.reset();
  if (kept != nullptr) kept->draws.clear();
}

Renderer::Renderer(raster::Framebuffer& framebuffer, const raster::RasterizerOptions& options,
                   AssembledFrame* kept)
    : implementation_(std::make_unique<Implementation>(framebuffer, options, kept)) {}
Renderer::~Renderer() = default;

void Renderer::clear(const raster::ClearValues& values) {
  Frame& frame = implementation_->frame;
  frame.rasterizer.clear(values);
  frame.release_draws();
  if (frame.kept != nullptr) frame.kept->clear = values;
}

void Renderer::draw(const State& state, const Geometry& geometry) {
  pipeline::draw(implementation_->frame, state, geometry);
}

void Renderer::finish() {
  Frame& frame = implementation_->frame;
  pipeline::finish(frame);
  Statistics& statistics = frame.statistics;
  statistics.raster = frame.rasterizer.statistics();
  statistics.interpolations = statistics.raster.interpolations;
  statistics.illuminations_fragment = frame.fragment_counters.illuminations();
  statistics.powers = frame.powers_before_fragments + frame.fragment_counters.powers();
}

const Statistics& Renderer::statistics() const { return implementation_->frame.statistics; }

}  // namespace barrido::pipeline
