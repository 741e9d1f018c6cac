// The last step of the vertex stage: from arrays of quantities to one record a vertex.
#include "pipeline/vertex_batch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/kernels/records.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "pipeline/kernels/vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace barrido::pipeline::HWY_NAMESPACE {

/// Quantities of a record: depth, q, the varyings, then zeros.
struct RecordColumns {
  const VertexBatch& batch;
  const float* const* varyings;
  int varying_count;
  int affine_count;

  HWY_INLINE V load(int quantity, int i) const {
    const F d;
    if (quantity == raster::kRecordDepth) return hn::Load(d, batch.depth + i);
    if (quantity == raster::kRecordQ) return hn::Load(d, batch.q + i);
    const int varying = quantity - raster::kRecordVaryings;
    if (varying >= varying_count) return hn::Zero(d);
    const V value = clamp_to_bound(hn::Load(d, varyings[varying] + i));
    return varying < affine_count ? value : hn::Mul(value, hn::Load(d, batch.q + i));
  }
};

/// Quantities are interleaved four at a time; then each lane's four are copied to its record.
void StoreRecords(const VertexBatch& batch, const float* const* varyings, int varying_count, int affine_count,
                  float* records, int stride) {
  const F d;
  const hn::FixedTag<float, 4> d4;
  const RecordColumns columns{batch, varyings, varying_count, affine_count};
  alignas(64) float quads[4 * kLanes];
  for (int i = 0; i < batch.count; i += kLanes) {
    float* block = records + static_cast<std::size_t>(i) * static_cast<std::size_t>(stride);
    for (int quantity = 0; quantity < stride; quantity += 4) {
      hn::StoreInterleaved4(columns.load(quantity, i), columns.load(quantity + 1, i),
                            columns.load(quantity + 2, i), columns.load(quantity + 3, i), d, quads);
      for (int lane = 0; lane < kLanes; ++lane) {
        hn::Store(hn::Load(d4, quads + 4 * lane), d4, block + lane * stride + quantity);
      }
    }
  }
}

}  // namespace barrido::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace barrido::pipeline {

HWY_EXPORT(StoreRecords);

void store_records(const VertexBatch& batch, const float* const* varyings, int varying_count,
                   int affine_count, float* records, int stride) {
  HWY_DYNAMIC_DISPATCH(StoreRecords)(batch, varyings, varying_count, affine_count, records, stride);
}

}  // namespace barrido::pipeline
#endif
