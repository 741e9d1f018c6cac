#include "pipeline/fragment_shading.h"

#include "pipeline/draw_plan.h"
#include "raster/fragments/fragment_batch.h"

namespace barrido::pipeline {
namespace {

using raster::FragmentBatch;
using raster::kAbsent;

template <std::size_t kCount>
std::array<const float*, kCount> arrays(const FragmentBatch& batch, int offset) {
  std::array<const float*, kCount> result{};
  for (std::size_t i = 0; offset != kAbsent && i < kCount; ++i) {
    result[i] = batch.varying[static_cast<std::size_t>(offset) + i];
  }
  return result;
}

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

void shade_phong(const void* parameters, FragmentBatch& batch) {
  const auto& plan = *static_cast<const DrawPlan*>(parameters);
  const raster::VaryingLayout& layout = plan.fragment.varyings;
  SurfacePoints points;
  points.count = batch.count;
  points.normal = arrays<3>(batch, layout.normal);
  points.position = arrays<3>(batch, layout.eye_position);
  points.color = arrays<4>(batch, layout.color);
  points.normalize = true;
  points.back = batch.back_facing;
  illuminate(*plan.illumination, points, colors_of(batch));
  count(plan, batch, plan.illumination->powers_per_point(side_of(plan, batch)));
}

void shade_cheap_phong(const void* parameters, FragmentBatch& batch) {
  const auto& plan = *static_cast<const DrawPlan*>(parameters);
  const raster::VaryingLayout& layout = plan.fragment.varyings;
  std::array<const float*, raster::kMaxVaryings> columns;
  const auto column_count = static_cast<std::size_t>(cheap_phong_varyings(*plan.illumination));
  for (std::size_t i = 0; i < column_count; ++i) {
    columns[i] = batch.varying[static_cast<std::size_t>(layout.dots) + i];
  }
  const InterpolatedDots dots{
      batch.count, batch.back_facing, {columns.data(), column_count}, arrays<4>(batch, layout.color)};
  cheap_phong_colors(*plan.illumination, dots, colors_of(batch));
  count(plan, batch, cheap_phong_fragment_powers(*plan.illumination, side_of(plan, batch)));
}

}  // namespace

raster::FragmentIllumination fragment_illumination(const DrawPlan& plan) {
  if (!plan.origin.at_fragments) return {};
  return {plan.origin.at_vertices ? shade_cheap_phong : shade_phong, &plan};
}

}  // namespace barrido::pipeline
