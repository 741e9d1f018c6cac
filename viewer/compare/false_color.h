// Colours for errors that are told apart in grey and by colour-blind people: lightness rises steadily.
#pragma once

#include <array>
#include <cstdint>

namespace barrido::compare {

/// R, G, B of an error in 0..1 (clamped): black, violet, magenta, orange, pale yellow. Between nine colours,
/// lightness (CIE L*) and the two chromatic coordinates of Lab are interpolated linearly, so that L* grows
/// from 0 to 98 in even steps.
std::array<std::uint8_t, 3> false_color(float error);

}  // namespace barrido::compare
