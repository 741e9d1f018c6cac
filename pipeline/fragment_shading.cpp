#include "pipeline/fragment_shading.h"

#include "pipeline/draw_plan.h"
#include "pipeline/reference/illumination.h"
#include "raster/reference/fragment.h"
#include "raster/tiles/tile.h"

namespace barrido::pipeline {
namespace {

using raster::FragmentBatch;
using raster::FragmentStage;
using raster::Meaning;
using raster::VaryingList;

const DrawPlan& plan_of(const FragmentStage& stage) {
  return *static_cast<const DrawPlan*>(stage.parameters);
}

/// The batch's arrays of a meaning; null where there are none.
template <std::size_t kCount>
std::array<const float*, kCount> arrays(const FragmentBatch& batch, Meaning meaning) {
  std::array<const float*, kCount> result{};
  const int at = batch.state->varyings.at(meaning);
  for (std::size_t i = 0; at != raster::kAbsent && i < kCount; ++i) {
    result[i] = batch.varying[static_cast<std::size_t>(at) + i];
  }
  return result;
}

/// The same where the list says how many.
struct Columns {
  std::array<const float*, raster::kMaxVaryings> column;
  std::size_t count;

  Columns(const FragmentBatch& batch, Meaning meaning)
      : count(static_cast<std::size_t>(batch.state->varyings.floats(meaning))) {
    const int at = batch.state->varyings.at(meaning);
    for (std::size_t i = 0; i < count; ++i) column[i] = batch.varying[static_cast<std::size_t>(at) + i];
  }
  std::span<const float* const> all() const { return {column.data(), count}; }
};

LitColors colors_of(FragmentBatch& batch) {
  return {{batch.color[0], batch.color[1], batch.color[2], batch.color[3]},
          {batch.specular[0], batch.specular[1], batch.specular[2]}};
}

void count(const DrawPlan& plan, const FragmentBatch& batch, int powers) {
  const auto fragments = static_cast<std::uint64_t>(batch.count);
  plan.counters->add(fragments * plan.illumination->lights.size(),
                     fragments * static_cast<std::uint64_t>(powers));
}

int side_of(const DrawPlan& plan, const FragmentBatch& batch) {
  return batch.back_facing && plan.illumination->two_sided ? 1 : 0;
}

void light_phong(const FragmentStage& stage, raster::TileWorkspace& workspace) {
  const DrawPlan& plan = plan_of(stage);
  FragmentBatch& batch = workspace.batch;
  const Columns visibility(batch, Meaning::visibility);
  SurfacePoints points;
  points.count = batch.count;
  points.normal = arrays<3>(batch, Meaning::normal);
  points.position = arrays<3>(batch, Meaning::eye_position);
  points.color = arrays<4>(batch, Meaning::color);
  points.normalize = true;
  points.back = batch.back_facing;
  points.visibility = visibility.all();
  points.occlusion = arrays<1>(batch, Meaning::occlusion)[0];
  illuminate(*plan.illumination, points, colors_of(batch));
  count(plan, batch, plan.illumination->powers_per_point(side_of(plan, batch)));
}

void light_cheap_phong(const FragmentStage& stage, raster::TileWorkspace& workspace) {
  const DrawPlan& plan = plan_of(stage);
  FragmentBatch& batch = workspace.batch;
  const Columns products(batch, Meaning::dots), visibility(batch, Meaning::visibility);
  const InterpolatedDots dots{batch.count,      batch.back_facing,
                              products.all(),   arrays<4>(batch, Meaning::color),
                              visibility.all(), arrays<1>(batch, Meaning::occlusion)[0]};
  cheap_phong_colors(*plan.illumination, dots, colors_of(batch));
  count(plan, batch, cheap_phong_fragment_powers(*plan.illumination, side_of(plan, batch)));
}

std::span<const float> values(const raster::reference::Fragment& fragment, Meaning meaning) {
  const VaryingList& varyings = fragment.state->varyings;
  if (!varyings.has(meaning)) return {};
  return {fragment.varying + varyings.at(meaning), static_cast<std::size_t>(varyings.floats(meaning))};
}

reference::SurfacePoint surface_of(const raster::reference::Fragment& fragment) {
  reference::SurfacePoint point;
  const auto take = [&](Meaning meaning, auto& into) {
    const std::span<const float> from = values(fragment, meaning);
    for (std::size_t i = 0; i < from.size(); ++i) into[static_cast<int>(i)] = from[i];
  };
  take(Meaning::normal, point.normal);
  take(Meaning::eye_position, point.position);
  take(Meaning::color, point.color);
  point.normalize = true;
  point.back = fragment.back_facing;
  point.visibility = values(fragment, Meaning::visibility);
  point.occlusion = values(fragment, Meaning::occlusion);
  return point;
}

void take_light(const reference::LitColor& light, raster::reference::Fragment& fragment) {
  fragment.color = light.primary;
  for (std::size_t c = 0; c < 3; ++c) fragment.specular[c] = light.secondary[c];
}

void light_phong_fragment(const FragmentStage& stage, raster::reference::Fragment& fragment,
                          raster::reference::ShadingTrace*) {
  take_light(reference::illuminate(*plan_of(stage).illumination, surface_of(fragment)), fragment);
}

void light_cheap_phong_fragment(const FragmentStage& stage, raster::reference::Fragment& fragment,
                                raster::reference::ShadingTrace*) {
  take_light(reference::cheap_phong_color(*plan_of(stage).illumination, values(fragment, Meaning::dots),
                                          surface_of(fragment)),
             fragment);
}

}  // namespace

constinit const raster::StageKind kPhongLight{
    .name = "Phong light",
    .reads = raster::set_of(Meaning::normal, Meaning::eye_position, Meaning::color, Meaning::visibility,
                            Meaning::occlusion),
    .writes = raster::set_of(Meaning::color, Meaning::specular),
    .vector = light_phong,
    .scalar = light_phong_fragment,
    .story = "evaluates the illumination model with the interpolated normal",
    .clock = raster::Stage::illumination};

constinit const raster::StageKind kCheapPhongLight{
    .name = "cheap Phong light",
    .reads = raster::set_of(Meaning::dots, Meaning::color, Meaning::visibility, Meaning::occlusion),
    .writes = raster::set_of(Meaning::color, Meaning::specular),
    .vector = light_cheap_phong,
    .scalar = light_cheap_phong_fragment,
    .story = "completes the illumination model from interpolated dot products",
    .clock = raster::Stage::illumination};

FragmentStage light_stage(const DrawPlan& plan) {
  const Illumination& light = *plan.illumination;
  const raster::Varying color{Meaning::color, light.tracks_color ? 4 : 0};
  if (plan.origin.at_vertices) {
    return {.kind = &kCheapPhongLight,
            .parameters = &plan,
            .reads = {{{Meaning::dots, cheap_phong_varyings(light)}, color}}};
  }
  return {.kind = &kPhongLight,
          .parameters = &plan,
          .reads = {{{Meaning::normal, 3}, {Meaning::eye_position, light.needs_position ? 3 : 0}, color}}};
}

}  // namespace barrido::pipeline
