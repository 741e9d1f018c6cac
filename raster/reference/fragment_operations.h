// The tests and the blending that decide what a fragment does to its pixel (OpenGL 1.3, chapter 4.1). Enters
// a coloured fragment and a pixel; leaves the pixel's new colour and depth.
#pragma once

#include <cstdint>

#include "raster/fragments/fragment_state.h"
#include "raster/reference/arithmetic.h"

namespace barrido::raster::reference {

/// `incoming` compared with `stored`.
bool compare(Compare how, float incoming, float stored);

bool is_inside_scissor(const Scissor& scissor, int x, int y);

/// What a blend factor stands for, per channel.
Color blend_factor(BlendFactor rgb, BlendFactor alpha, const Color& source, const Color& destination,
                   const Color& constant);

/// The blended colour of all four channels; the source itself when blending is off.
Color blend(const BlendState& state, const Color& source, const Color& destination);

/// Packed R, G, B, A in memory order, rounded to nearest, ties to even.
std::uint32_t pack_rgba8(const Color& color);
Color unpack_rgba8(std::uint32_t packed);

}  // namespace barrido::raster::reference
