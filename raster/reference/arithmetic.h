// The few operations that docs/arithmetic.md defines more strictly than the language does.
#pragma once

#include <array>

namespace barrido::raster::reference {

using Color = std::array<float, 4>;

/// a < b ? a : b, so a NaN in a gives b.
inline float minimum(float a, float b) { return a < b ? a : b; }
/// a > b ? a : b, so a NaN in a gives b, and max(−0, 0) is 0.
inline float maximum(float a, float b) { return a > b ? a : b; }
inline float clamp_to_unit(float value) { return minimum(maximum(value, 0.0f), 1.0f); }

}  // namespace barrido::raster::reference
