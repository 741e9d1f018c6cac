#include <algorithm>
#include <vector>

#include "pipeline/inspect/fragment_census.h"
#include "pipeline/inspect/view_observers.h"
#include "pipeline/map_stages.h"
#include "raster/reference/fragment_walk.h"
#include "raster/reference/level_of_detail.h"
#include "raster/reference/sampling.h"
#include "raster/reference/wide_filters.h"

namespace barrido::inspect {
namespace {

using Counts = std::vector<std::uint32_t>;

/// How many depends on where the fragment lies.
std::uint32_t wide_texels_of(const CensusFragment& fragment, int unit) {
  const raster::FragmentState& state = *fragment.place.chunk.state;
  raster::reference::Fragment interpolated;
  raster::reference::interpolate(fragment.place, interpolated);
  float coordinates[3] = {0, 0, 0};
  std::copy_n(interpolated.varying + state.varyings.at(raster::Meaning::texcoord, unit),
              state.varyings.floats(raster::Meaning::texcoord, unit), coordinates);
  return raster::reference::sample_wide(state.texture_units[static_cast<std::size_t>(unit)],
                                        raster::texcoord_kind(state, unit), coordinates,
                                        interpolated.lod[unit], interpolated.slopes[unit])
      .texels;
}

std::uint32_t usual_texels_of(const CensusFragment& fragment, int unit) {
  const raster::FragmentState& state = *fragment.place.chunk.state;
  const float lod = raster::reference::level_of_detail(state, unit, fragment.place.along, fragment.place.x);
  const raster::TextureUnit& texture = state.texture_units[static_cast<std::size_t>(unit)];
  return static_cast<std::uint32_t>(raster::reference::choose_levels(texture, lod).texels());
}

std::uint32_t texels_of(const CensusFragment& fragment) {
  const raster::FragmentState& state = *fragment.place.chunk.state;
  std::uint32_t texels = 0;
  for (int unit = 0; unit < raster::kMaxTextureUnits; ++unit) {
    if (!raster::has_picture(state, unit)) continue;
    const raster::TextureUnit& texture = state.texture_units[static_cast<std::size_t>(unit)];
    // Slopes are differences along each axis.
    const int times = texture.role == raster::TextureRole::bump
                          ? 2 * pipeline::bump_steps(texture, texcoord_kind(state, unit)).axes
                          : 1;
    const std::uint32_t once =
        raster::has_wide_filter(texture) ? wide_texels_of(fragment, unit) : usual_texels_of(fragment, unit);
    texels += once * static_cast<std::uint32_t>(times);
  }
  return texels;
}

std::uint32_t lights_of(const pipeline::DrawPlan& plan) {
  return plan.illumination ? static_cast<std::uint32_t>(plan.illumination->lights.size()) : 0;
}

std::uint32_t illuminations_of(const CensusFragment& fragment) {
  const pipeline::DrawPlan& plan = *fragment.chunk.draw->plan;
  return plan.origin.at_fragments ? lights_of(plan) : 0;
}

/// Puts evaluations that are not a fragment's into the pixel where they lie.
class Scatter {
 public:
  Scatter(const scene::ObservedFrame& frame, Counts& counts, std::uint64_t& outside)
      : width_(frame.options.width), height_(frame.options.height), counts_(counts), outside_(outside) {}

  /// Window coordinates in 1/256 pixel.
  void add(std::int64_t x, std::int64_t y, std::uint32_t evaluations) {
    const std::int64_t column = x >> raster::kSubpixelBits;
    const std::int64_t row = height_ - 1 - (y >> raster::kSubpixelBits);
    if (column < 0 || column >= width_ || row < 0 || row >= height_) return add_outside(evaluations);
    counts_[static_cast<std::size_t>(row * width_ + column)] += evaluations;
  }
  void add_outside(std::uint32_t evaluations) { outside_ += evaluations; }

 private:
  std::int64_t width_, height_;
  Counts& counts_;
  std::uint64_t& outside_;
};

void scatter_vertices(const pipeline::AssembledDraw& draw, Scatter& scatter) {
  const std::uint32_t each = lights_of(*draw.plan) * static_cast<std::uint32_t>(draw.plan->sides());
  for (std::uint32_t v = 0; v < draw.vertices.count; ++v) {
    const pipeline::PackedPosition& p = draw.vertices.positions[v];
    if ((pipeline::outcode(p) & (pipeline::kOffGuardBand | pipeline::kNotANumber)) != 0) {
      scatter.add_outside(each);
    } else {
      scatter.add(pipeline::window_coordinate(p.x), pipeline::window_coordinate(p.y), each);
    }
  }
}

/// One evaluation for each entry of the chunk's table of flat colours, at the middle of the first primitive
/// that takes it.
void scatter_centroids(const pipeline::AssembledDraw& draw, const raster::PrimitiveChunk& chunk,
                       Scatter& scatter) {
  const int corners = chunk.topology == raster::Topology::triangles ? 3
                      : chunk.topology == raster::Topology::lines   ? 2
                                                                    : 1;
  std::vector<bool> done(chunk.flat.size(), false);
  for (const raster::PrimitiveRecord& p : chunk.primitives) {
    const std::uint32_t index = p.flat_and_facing & ~raster::kBackFacing;
    if (done[index]) continue;
    done[index] = true;
    std::int64_t x = 0, y = 0;
    for (int k = 0; k < corners; ++k) {
      x += p.x[k];
      y += p.y[k];
    }
    scatter.add(x / corners, y / corners, lights_of(*draw.plan));
  }
}

void scatter_evaluations(const scene::ObservedFrame& frame, Counts& counts, std::uint64_t& outside) {
  Scatter scatter(frame, counts, outside);
  for (const pipeline::AssembledDraw& draw : frame.assembled.draws) {
    if (draw.plan->illumination && draw.plan->origin.at_vertices) {
      scatter_vertices(draw, scatter);
    }
    if (!draw.plan->origin.at_centroid || !draw.plan->illumination) continue;
    for (const pipeline::AssembledChunk& chunk : draw.chunks) scatter_centroids(draw, *chunk.chunk, scatter);
  }
}

}  // namespace

void count_work(const scene::ObservedFrame& frame, ViewValues& values) {
  Counts counts(values.values.size(), 0);
  const auto add = [&](std::uint32_t (*work)(const CensusFragment&)) {
    return [&counts, work](const CensusFragment& fragment) { counts[fragment.pixel] += work(fragment); };
  };
  const auto one = [](const CensusFragment&) { return std::uint32_t{1}; };
  CensusEvents events;
  switch (values.view) {
    case StructureView::layers:
      events.covered = add(one);
      break;
    case StructureView::illuminations:
      events.shaded = add(illuminations_of);
      break;
    case StructureView::texels:
      events.shaded = add(texels_of);
      break;
    default:
      events.shaded = add(one);
      break;
  }
  take_census(frame, chunks_of(frame), events);
  if (values.view == StructureView::illuminations) scatter_evaluations(frame, counts, values.outside);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    values.values[i] = static_cast<float>(counts[i]);
    values.total += counts[i];
  }
}

}  // namespace barrido::inspect
