#include "pipeline/inspect/fragment_census.h"

#include <algorithm>
#include <limits>

#include <tbb/parallel_for.h>

#include "raster/reference/fragment_operations.h"
#include "raster/reference/shading.h"

namespace barrido::inspect {
namespace {

using raster::reference::FragmentPlace;

/// Rows that one thread takes at a time.
constexpr int kBandRows = 16;

class Band {
 public:
  Band(const scene::ObservedFrame& frame, const std::vector<FrameChunk>& chunks, const CensusEvents& events,
       raster::reference::RowRange rows)
      : frame_(frame),
        chunks_(chunks),
        events_(events),
        rows_(rows),
        depth_(
            static_cast<std::size_t>(rows.end - rows.begin) * static_cast<std::size_t>(frame.options.width),
            frame.assembled.clear.depth) {}

  void visit(const FragmentPlace& place) {
    const int row_from_top = frame_.options.height - 1 - place.y;
    const auto width = static_cast<std::size_t>(frame_.options.width);
    const CensusFragment fragment{
        place, chunks_[place.chunk_number],
        static_cast<std::size_t>(row_from_top) * width + static_cast<std::size_t>(place.x)};
    if (events_.covered) events_.covered(fragment);
    const raster::FragmentState& state = *place.chunk.state;
    if (!raster::reference::is_inside_scissor(state.scissor, place.x, place.y)) return;
    float& stored =
        depth_[static_cast<std::size_t>(place.y - rows_.begin) * width + static_cast<std::size_t>(place.x)];
    const float z = raster::reference::interpolated_depth(place);
    if (state.depth.test && !raster::reference::compare(state.depth.compare, z, stored)) return;
    if (events_.shaded) events_.shaded(fragment);
    if (state.alpha_test.enabled && !passes_alpha_test(place)) return;
    if (state.depth.test && state.depth.write) stored = z;
    if (events_.drawn && is_last_yet(state, &stored - depth_.data(), z)) events_.drawn(fragment);
  }

 private:
  static bool passes_alpha_test(const FragmentPlace& place) {
    raster::reference::Fragment fragment;
    raster::reference::interpolate(place, fragment);
    const raster::AlphaTest& test = place.chunk.state->alpha_test;
    return raster::reference::compare(test.compare, raster::reference::shade_fragment(fragment)[3],
                                      test.reference);
  }

  /// Of sorted fragments the nearest is drawn last, and of equally near ones the last.
  bool is_last_yet(const raster::FragmentState& state, std::ptrdiff_t pixel, float z) {
    if (!state.sorted && nearest_layer_.empty()) return true;
    if (nearest_layer_.empty()) nearest_layer_.assign(depth_.size(), kNoLayer);
    float& nearest = nearest_layer_[static_cast<std::size_t>(pixel)];
    if (state.sorted && z > nearest) return false;
    nearest = state.sorted ? z : kNoLayer;
    return true;
  }

  static constexpr float kNoLayer = std::numeric_limits<float>::infinity();

  const scene::ObservedFrame& frame_;
  const std::vector<FrameChunk>& chunks_;
  const CensusEvents& events_;
  raster::reference::RowRange rows_;
  std::vector<float> depth_;
  std::vector<float> nearest_layer_;  ///< Empty before the first sorted fragment.
};

}  // namespace

std::vector<FrameChunk> chunks_of(const scene::ObservedFrame& frame) {
  std::vector<FrameChunk> chunks;
  for (std::size_t i = 0; i < frame.assembled.draws.size(); ++i) {
    const pipeline::AssembledDraw& draw = frame.assembled.draws[i];
    for (const pipeline::AssembledChunk& chunk : draw.chunks) {
      chunks.push_back({&draw, &frame.origins[i], &chunk});
    }
  }
  return chunks;
}

void take_census(const scene::ObservedFrame& frame, const std::vector<FrameChunk>& chunks,
                 const CensusEvents& events) {
  std::vector<const raster::PrimitiveChunk*> raster_chunks;
  for (const FrameChunk& chunk : chunks) raster_chunks.push_back(chunk.chunk->chunk);
  const raster::reference::FrameSize size{frame.options.width, frame.options.height};
  tbb::parallel_for(0, (size.height + kBandRows - 1) / kBandRows, [&](int number) {
    const raster::reference::RowRange rows{number * kBandRows,
                                           std::min((number + 1) * kBandRows, size.height)};
    Band band(frame, chunks, events, rows);
    raster::reference::for_each_fragment(raster_chunks, size, {{}, rows},
                                         [&](const FragmentPlace& place) { band.visit(place); });
  });
}

}  // namespace barrido::inspect
