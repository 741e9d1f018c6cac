// Fragments on their way from the spans to the frame: a structure of arrays of at most kBatchCapacity
// fragments of one state and one facing. Rows of several primitives are packed one behind the other, so that
// the expensive stages (illumination, texturing) run on full vectors even when the triangles are tiny.
#pragma once

#include <cstdint>

#include "raster/fragment_state.h"

namespace barrido::raster {

inline constexpr int kBatchCapacity = 128;
/// Every array may be read and written in whole vectors up to this many elements past `count`.
inline constexpr int kBatchPadding = 16;
inline constexpr int kBatchStride = kBatchCapacity + kBatchPadding;

/// Consecutive pixels of one row that come from one primitive.
struct FragmentRun {
  std::int16_t x;      ///< First pixel, relative to the tile.
  std::int16_t y;      ///< Row, relative to the tile.
  std::int16_t begin;  ///< First fragment of the run in the batch.
  std::int16_t end;    ///< One past the last.
};

struct FragmentBatch {
  const FragmentState* state = nullptr;
  bool back_facing = false;  ///< Of every fragment in the batch.
  int count = 0;
  int run_count = 0;
  FragmentRun runs[kBatchCapacity];
  alignas(64) float depth[kBatchStride];
  alignas(64) float color[4][kBatchStride];     ///< Primary colour, then the result of the texture units.
  alignas(64) float specular[3][kBatchStride];  ///< Secondary colour.
  /// Level of detail λ (before bias) per texture unit (OpenGL 1.3, section 3.8.8).
  alignas(64) float lod[kMaxTextureUnits][kBatchStride];
  alignas(64) float varying[kMaxVaryings][kBatchStride];  ///< Interpolated and perspective-corrected.
};

}  // namespace barrido::raster
