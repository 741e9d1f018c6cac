#include "pipeline/draw_ledger.h"

#include "pipeline/assembled_frame.h"

namespace barrido::pipeline {

DrawLedger::DrawLedger(Frame& frame, const DrawPlan& plan, const State& state, const Geometry& geometry)
    : frame_(frame), plan_(plan) {
  if (frame.kept == nullptr) return;
  kept_ = &frame.kept->draws.emplace_back();
  *kept_ = {&plan, state, geometry, {}, {}};
}

void DrawLedger::add(const TransformedVertices& vertices) {
  Statistics& statistics = frame_.statistics;
  ++statistics.draws;
  statistics.vertices += vertices.count;
  if (kept_ != nullptr) kept_->vertices = vertices;
  if (!plan_.illumination || !plan_.origin.at_vertices) return;
  const Illumination& light = *plan_.illumination;
  for (int side = 0; side < plan_.sides(); ++side) {
    const int powers = plan_.origin.makes_vertex_products() ? cheap_phong_vertex_powers(light, side)
                                                            : light.powers_per_point(side);
    statistics.illuminations_vertex += std::uint64_t{vertices.count} * light.lights.size();
    frame_.powers_before_fragments += std::uint64_t{vertices.count} * static_cast<std::uint64_t>(powers);
  }
}

void DrawLedger::add(const Run& run) {
  Statistics& statistics = frame_.statistics;
  statistics.primitives_in += run.counts.primitives;
  statistics.primitives_culled += run.counts.culled;
  statistics.primitives_clipped += run.counts.clipped;
  statistics.illuminations_vertex += run.counts.illuminations;
  frame_.powers_before_fragments += run.counts.powers;
  for (std::size_t i = 0; kept_ != nullptr && i < run.chunks.size(); ++i) {
    kept_->chunks.push_back({&run.chunks[i]->chunk(), run.sources[i]});
  }
}

}  // namespace barrido::pipeline
