// A vertex in the window as assembly reads it: position and outcode in eight bytes, so that the three corners
// of a triangle cost three loads. Knows nothing of varyings.
#pragma once

#include <cstdint>

#include "raster/fragments/primitive.h"

namespace barrido::pipeline {

/// On which sides of the view volume a vertex lies (Cohen and Sutherland). A primitive whose corners share a
/// bit of the volume or of a user plane cannot be seen.
enum Outcode : std::uint32_t {
  kOutsideLeft = 1,    ///< x < −w
  kOutsideRight = 2,   ///< x > w
  kOutsideBottom = 4,  ///< y < −w
  kOutsideTop = 8,     ///< y > w
  kOutsideNear = 16,   ///< z < −w; never with depth clamping
  kOutsideFar = 32,    ///< z > w; never with depth clamping
  kOffGuardBand = 64,  ///< Has no window position: too far outside the frame, or w is not positive.
  kNotANumber = 128,   ///< The position is not a finite, sensible number; its primitives are not drawn.
};
inline constexpr std::uint32_t kOutsideVolume = 63;
inline constexpr int kOutcodeBits = 8;
inline constexpr std::uint32_t kOutcodeMask = 0xff;
/// Eight bits for as many user clip planes.
inline constexpr int kMaxClipPlanes = 8;

/// `x` is the window x in 1/256 pixel times 256 plus the Outcode; `y` the same with the user planes' bits.
struct PackedPosition {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
};

/// Window coordinate in 1/256 pixel (the shift of a negative number is arithmetic in C++20).
constexpr std::int32_t window_coordinate(std::uint32_t packed) {
  return static_cast<std::int32_t>(packed) >> kOutcodeBits;
}

constexpr std::uint32_t outcode(const PackedPosition& p) { return p.x & kOutcodeMask; }
constexpr std::uint32_t plane_code(const PackedPosition& p) { return p.y & kOutcodeMask; }

/// What makes a primitive need clipping when any of its corners has it.
inline constexpr std::uint32_t kNeedsClipping = kOutsideNear | kOutsideFar | kOffGuardBand;

/// Vertices stay this far inside the rasterizer's guard band, so that no rounding can leave it.
inline constexpr float kGuardLimitPixels = static_cast<float>(raster::kGuardBandPixels - 64);

}  // namespace barrido::pipeline
