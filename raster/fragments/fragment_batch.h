// Fragments on their way from the spans to the frame: a structure of arrays of at most kBatchCapacity
// fragments of one state and one facing. Rows of several primitives are packed one behind the other, so that
// the expensive stages (illumination, texturing) run on full vectors even when the triangles are tiny.
#pragma once

#include <cstdint>

#include "raster/fragments/fragment_state.h"

namespace barrido::raster {

/// Consecutive pixels of one row that come from one primitive.
struct FragmentRun {
  std::int16_t x;      ///< First pixel, relative to the tile.
  std::int16_t y;      ///< Row, relative to the tile.
  std::int16_t begin;  ///< First fragment of the run in the batch.
  std::int16_t end;    ///< One past the last.
};

/// Which mip levels each fragment's sample comes from, a number a fragment:
///   bits 0–7    weight of the upper level in 1/256
///   bits 8–15   the lower level
///   bits 16–22  the upper level; the lower one again where the weight is 0
///   bit 23      four texels of each level, not one
///   bits 24–31  texels that are read: 1, 2, 4 or 8
struct SampleLevels {
  alignas(64) std::int32_t packed[kBatchStride];
};
inline constexpr int kLowerLevelShift = 8;
inline constexpr int kUpperLevelShift = 16;
inline constexpr std::int32_t kFourTexels = 1 << 23;
inline constexpr int kTexelCountShift = 24;
inline constexpr std::int32_t kUpperWeightMask = 0xff;
/// What texel addresses depend on: both levels and the number of texels of each.
inline constexpr std::int32_t kLevelsMask = 0x00ffff00;

struct FragmentBatch {
  const FragmentState* state = nullptr;
  bool back_facing = false;  ///< Of every fragment in the batch.
  int count = 0;
  int run_count = 0;
  FragmentRun runs[kBatchCapacity];
  alignas(64) float depth[kBatchStride];
  alignas(64) float color[4][kBatchStride];     ///< Primary colour, then the result of the texture units.
  alignas(64) float specular[3][kBatchStride];  ///< Secondary colour.
  alignas(64) float varying[kMaxVaryings][kBatchStride];  ///< Interpolated and perspective-corrected; then
                                                          ///< those that stages compute.
};

}  // namespace barrido::raster
