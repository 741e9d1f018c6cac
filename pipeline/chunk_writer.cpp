#include "pipeline/chunk_writer.h"

#include <algorithm>

#include "pipeline/bounded.h"

namespace barrido::pipeline {
namespace {

/// Window z of a clipped vertex.
float window_depth(const VertexTransform& transform, const ClipVertex& v) {
  const double z = v.z / v.w * transform.window_scale.z + transform.window_offset.z;
  return transform.depth_clamp ? bounded(z) : static_cast<float>(std::clamp(z, 0.0, 1.0));
}

}  // namespace

ChunkWriter::ChunkWriter(const AssemblyInput& input, std::uint32_t expected, AssemblyCounts& counts)
    : input_(input),
      expected_(std::min(expected, static_cast<std::uint32_t>(raster::kMaxChunkPrimitives))),
      flat_(input, counts) {
  begin_chunk();
}

void ChunkWriter::begin_chunk() {
  chunk_ = &chunks_.emplace_back();
  const DrawPlan& plan = input_.plan;
  chunk_->state = &plan.fragment;
  chunk_->topology = plan.topology;
  chunk_->point_size = plan.point_size;
  chunk_->line_width = plan.line_width;
  chunk_->shared_records = input_.vertices.records;
  chunk_->shared_count = input_.vertices.capacity * static_cast<std::uint32_t>(plan.sides());
  chunk_->primitives.reserve(expected_);
  flat_.begin_chunk(*chunk_);
  if (input_.with_sources) sources_.emplace_back();
}

void ChunkWriter::finish_chunk() {
  flat_.end_chunk();
  if (!chunk_->primitives.empty()) return;
  chunks_.pop_back();
  if (input_.with_sources) sources_.pop_back();
}

std::vector<raster::PrimitiveChunk> ChunkWriter::take() {
  finish_chunk();
  return std::move(chunks_);
}

std::uint32_t ChunkWriter::add_vertex(const ClipVertex& vertex, const ClipCorners& corners) {
  const int stride = input_.vertices.stride;
  const raster::VaryingList& varyings = input_.plan.fragment.varyings;
  std::vector<float>& records = chunk_->own_records;
  const std::size_t at = records.size();
  records.resize(at + static_cast<std::size_t>(stride), 0.0f);
  float* record = records.data() + at;
  const auto q = static_cast<float>(1.0 / vertex.w);
  record[raster::kRecordDepth] = window_depth(input_.plan.transform, vertex);
  record[raster::kRecordQ] = q;
  for (int i = 0; i < varyings.count; ++i) {
    const bool affine = i < varyings.affine_count;
    double value = 0.0;
    for (int c = 0; c < corners.count; ++c) {
      const auto corner = static_cast<std::size_t>(c);
      const float* from = input_.vertices.records +
                          static_cast<std::size_t>(corners.vertex[corner]) * static_cast<std::size_t>(stride);
      // Records hold f/w where the vertex has a w to divide by; clip space wants f.
      const double w = affine || corners.w[corner] < kMinW ? 1.0 : corners.w[corner];
      value += vertex.weight[corner] * (from[raster::kRecordVaryings + i] * w);
    }
    record[raster::kRecordVaryings + i] = affine ? bounded(value) : bounded(value) * q;
  }
  return chunk_->shared_count + static_cast<std::uint32_t>(at / static_cast<std::size_t>(stride));
}

}  // namespace barrido::pipeline
