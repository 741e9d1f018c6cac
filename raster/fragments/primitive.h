// What enters the rasterizer: points, lines and triangles in window space, in chunks that share one fragment
// state. Window coordinates have their origin at the lower left corner, x to the right, y up; pixel (x, y)
// covers [x, x+1) × [y, y+1) and its centre is at (x + ½, y + ½). Positions are snapped to 1/256 pixel.
#pragma once

#include <cstdint>
#include <vector>

#include "raster/fragments/fragment_state.h"

namespace barrido::raster {

inline constexpr int kSubpixelBits = 8;
inline constexpr int kSubpixelUnits = 1 << kSubpixelBits;
/// Guard band: |x|, |y| of every vertex must stay below this many pixels. Then coordinate differences have 25
/// bits and products of two have 50, so that every edge test is exact in a double (53 bits) and in 64-bit
/// integers.
inline constexpr int kGuardBandPixels = 1 << 15;
inline constexpr int kMaxFrameSide = 16384;

/// The rule of the pixel centre, of window coordinates in 1/256 pixel: a pixel's centre, and the first pixel
/// whose centre is at or after a coordinate. For integers of any size; lanes-inl.h has it for vectors.
template <class T>
constexpr T centre_of(T pixel) {
  return pixel * kSubpixelUnits + kSubpixelUnits / 2;
}
inline constexpr int kToFirstCentre = kSubpixelUnits / 2 - 1;
template <class T>
constexpr T first_centre_at(T coordinate) {
  return (coordinate + kToFirstCentre) >> kSubpixelBits;
}

enum class Topology : std::uint8_t { points, lines, triangles };

/// Floats of a vertex record before its varyings: window depth in [0, 1], then q = 1/w.
inline constexpr int kRecordDepth = 0;
inline constexpr int kRecordQ = 1;
inline constexpr int kRecordVaryings = 2;

/// Every number in a record must be finite and at most this in magnitude. What comes from one is then the
/// same bits on every machine: no conversion between double and float overflows.
inline constexpr float kMaxRecordValue = 1e22f;

/// Floats from one record to the next: padded to whole groups of eight so that setup reads full vectors.
constexpr int record_stride(int varying_count) { return (kRecordVaryings + varying_count + 7) / 8 * 8; }

/// One primitive; a line uses two entries and a point one.
struct PrimitiveRecord {
  std::int32_t x[3];              ///< Window x in 1/256 pixel.
  std::int32_t y[3];              ///< Window y in 1/256 pixel.
  std::uint32_t vertex[3];        ///< Vertex records, see PrimitiveChunk.
  std::uint32_t flat_and_facing;  ///< Index into PrimitiveChunk::flat, and kBackFacing.
};
inline constexpr std::uint32_t kBackFacing = 0x80000000u;

/// Colours that are constant over a primitive (flat shading, S1).
struct FlatColors {
  float color[4];
  float specular[3];
};

/// Primitives of one draw, at most kMaxChunkPrimitives, in submission order. Several chunks of a draw share
/// their vertex records; vertices that clipping made belong to the chunk.
struct PrimitiveChunk {
  const FragmentState* state = nullptr;  ///< Must outlive the frame.
  Topology topology = Topology::triangles;
  float point_size = 1.0f;  ///< Pixels.
  float line_width = 1.0f;  ///< Pixels.
  /// Vertex v is shared_records + v × stride when v < shared_count, else own_records + (v − shared_count) ×
  /// stride.
  const float* shared_records = nullptr;  ///< Must outlive the frame.
  std::uint32_t shared_count = 0;
  std::vector<float> own_records;
  std::vector<PrimitiveRecord> primitives;
  std::vector<FlatColors> flat;

  const float* record(std::uint32_t vertex, int stride) const {
    return vertex < shared_count
               ? shared_records + static_cast<std::size_t>(vertex) * static_cast<std::size_t>(stride)
               : own_records.data() +
                     static_cast<std::size_t>(vertex - shared_count) * static_cast<std::size_t>(stride);
  }
};
inline constexpr int kMaxChunkPrimitives = 4096;

}  // namespace barrido::raster
