// Numbers as colours: an ordered scale, a scale with two sides, and colours that only tell apart. Knows no
// view.
#pragma once

#include <array>
#include <cstdint>

namespace barrido::inspect {

using Rgb8 = std::array<std::uint8_t, 3>;

/// t in [0, 1] from dark blue over green to pale yellow; its lightness grows steadily, so that it can be read
/// without seeing colours. Values outside, and NaN, count as the nearest end, and 0.
Rgb8 ordered_color(double t);

/// t in [−1, 1]: blue below zero, dark grey at zero, orange to yellow above. Lightness grows with |t|.
Rgb8 signed_color(double t);

/// Some colour of medium lightness that differs from those of neighbouring numbers.
Rgb8 distinct_color(std::uint32_t number);

/// What stands where there is no number.
inline constexpr Rgb8 kNothingColor{38, 38, 38};

/// As a frame holds it, opaque.
inline std::uint32_t packed(const Rgb8& c) {
  return c[0] | static_cast<std::uint32_t>(c[1]) << 8 | static_cast<std::uint32_t>(c[2]) << 16 | 0xff000000u;
}

}  // namespace barrido::inspect
