// What keeps sums over a pixel's footprint finite (docs/arithmetic.md, "Footprints"): the same numbers for
// the vector kernels and the scalar reference.
#pragma once

namespace barrido::raster {

/// The level whose texels are summed has at most 2^this texels a side under the footprint, where there is
/// one.
inline constexpr int kMostSummedLog2 = 4;
/// Sides that no level makes shorter are cut to so many texels.
inline constexpr float kLongestFootprintSide = 32.0f;
/// A footprint without area is so many texels wide.
inline constexpr float kLeastFootprintWidth = 0.0625f;
/// Sides that rise less than this, in texels, do not bound rows.
inline constexpr float kLeastFootprintRise = 0x1p-10f;
/// Texture widths from pixel to pixel; what is not less counts as 0.
inline constexpr float kLargestSlope = 0x1p40f;
/// Farther than this beyond a clamped edge all texels are the same.
inline constexpr float kBeyondEdgeTexels = 64.0f;

}  // namespace barrido::raster
