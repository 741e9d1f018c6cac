#include "pipeline/flat_colors.h"

namespace barrido::pipeline {

FlatColorTable::FlatColorTable(const AssemblyInput& input, AssemblyCounts& counts)
    : input_(input), counts_(counts) {
  if (input.plan.origin.at_centroid) centroids_ = std::make_unique<std::array<Centroids, 2>>();
}

void FlatColorTable::begin_chunk(raster::PrimitiveChunk& chunk) {
  chunk_ = &chunk;
  last_primitive_ = kNoPrimitive;
  if (input_.plan.has_constant_color()) chunk.flat.push_back(input_.plan.constant_color);
}

void FlatColorTable::end_chunk() {
  if (centroids_ == nullptr) return;
  light(0);
  light(1);
}

std::uint32_t FlatColorTable::add(std::uint32_t primitive, bool back) {
  const auto index = static_cast<std::uint32_t>(chunk_->flat.size());
  if (input_.plan.origin.at_vertices) {
    const std::size_t vertex = input_.provoking_vertex(primitive);
    const std::size_t side = back && input_.plan.has_back_side ? input_.vertices.capacity : 0;
    chunk_->flat.push_back(input_.vertices.flat_colors[vertex + side]);
  } else {
    chunk_->flat.emplace_back();
    add_centroid(primitive, back, index);
  }
  last_primitive_ = primitive;
  last_back_ = back;
  last_index_ = index;
  return index;
}

void FlatColorTable::add_centroid(std::uint32_t primitive, bool back, std::uint32_t index) {
  double sum[10] = {};
  const std::uint32_t corners = input_.corner_count();
  for (std::uint32_t corner = 0; corner < corners; ++corner) {
    const SurfaceVertex& v = input_.vertices.surfaces[input_.corner_vertex(primitive, corner)];
    for (int axis = 0; axis < 3; ++axis) {
      sum[axis] += v.position[axis];
      sum[3 + axis] += v.normal[axis];
    }
    for (int c = 0; c < 4; ++c) sum[6 + c] += v.color[c];
  }
  const int side = back ? 1 : 0;
  Centroids& batch = (*centroids_)[static_cast<std::size_t>(side)];
  const int at = batch.count++;
  batch.index[static_cast<std::size_t>(at)] = index;
  for (int axis = 0; axis < 3; ++axis) {
    batch.position[axis][at] = static_cast<float>(sum[axis] / corners);
    batch.normal[axis][at] = static_cast<float>(sum[3 + axis] / corners);
  }
  for (int c = 0; c < 4; ++c) batch.color[c][at] = static_cast<float>(sum[6 + c] / corners);
  if (batch.count == kVertexBatch) light(side);
}

void FlatColorTable::light(int side) {
  Centroids& batch = (*centroids_)[static_cast<std::size_t>(side)];
  if (batch.count == 0) return;
  const DrawPlan& plan = input_.plan;
  const BatchArray* colors = batch.color;
  const bool secondary = plan.fragment.separate_specular;
  if (plan.illumination) {
    SurfacePoints points;
    points.count = batch.count;
    points.normal = {batch.normal[0], batch.normal[1], batch.normal[2]};
    points.position = {batch.position[0], batch.position[1], batch.position[2]};
    points.color = {batch.color[0], batch.color[1], batch.color[2], batch.color[3]};
    points.normalize = true;
    points.back = side == 1;
    illuminate(*plan.illumination, points,
               {{batch.lit[0], batch.lit[1], batch.lit[2], batch.lit[3]},
                {batch.lit[4], batch.lit[5], batch.lit[6]}});
    colors = batch.lit;
    const auto count = static_cast<std::uint64_t>(batch.count);
    counts_.illuminations += count * plan.illumination->lights.size();
    counts_.powers += count * static_cast<std::uint64_t>(plan.illumination->powers_per_point(side));
  }
  for (int c = 0; c < (secondary ? 7 : 4); ++c) {
    bound_column(batch.count, plan.clamp_colors, plan.illumination ? batch.lit[c] : batch.color[c]);
  }
  for (int i = 0; i < batch.count; ++i) {
    raster::FlatColors& flat = chunk_->flat[batch.index[static_cast<std::size_t>(i)]];
    for (int c = 0; c < 4; ++c) flat.color[c] = colors[c][i];
    for (int c = 0; c < 3; ++c) flat.specular[c] = secondary ? colors[4 + c][i] : 0.0f;
  }
  batch.count = 0;
}

}  // namespace barrido::pipeline
