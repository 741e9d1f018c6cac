#include "pipeline/renderer.h"

#include "pipeline/assembled_frame.h"
#include "pipeline/frame.h"
#include "raster/tiles/binning.h"

namespace barrido::pipeline {

struct Renderer::Implementation {
  Frame frame;

  Implementation(raster::Framebuffer& framebuffer, const raster::RasterizerOptions& options,
                 AssembledFrame* record)
      : frame(framebuffer, options) {
    frame.record = record;
  }

  /// The rasterizer holds nothing any more that points to the draws.
  void release_draws() {
    frame.plans.clear();
    frame.memory.reset();
    if (frame.record != nullptr) frame.record->draws.clear();
  }
};

Renderer::Renderer(raster::Framebuffer& framebuffer, const raster::RasterizerOptions& options,
                   AssembledFrame* record)
    : implementation_(std::make_unique<Implementation>(framebuffer, options, record)) {}
Renderer::~Renderer() = default;

void Renderer::clear(const raster::ClearValues& values) {
  implementation_->frame.rasterizer.clear(values);
  implementation_->release_draws();
  if (implementation_->frame.record != nullptr) implementation_->frame.record->clear = values;
}

void Renderer::draw(const State& state, const Geometry& geometry) {
  pipeline::draw(implementation_->frame, state, geometry);
}

void Renderer::finish() {
  Frame& frame = implementation_->frame;
  frame.rasterizer.flush();
  implementation_->release_draws();
  Statistics& statistics = frame.statistics;
  statistics.raster = frame.rasterizer.statistics();
  statistics.interpolations = statistics.raster.interpolations;
  statistics.illuminations_fragment = frame.fragment_counters.illuminations();
  statistics.powers = frame.powers_before_fragments + frame.fragment_counters.powers();
}

const Statistics& Renderer::statistics() const { return implementation_->frame.statistics; }

}  // namespace barrido::pipeline
