// Frames with a background that lets something through: colours that were blended over it are a sum weighted
// by alpha, and become straight colours again. Enters: a finished frame; leaves: the same. Knows no scene.
#pragma once

#include <array>

#include "raster/tiles/framebuffer.h"

namespace barrido::scene {

/// What the frame was cleared to. Blending needs a colour that is multiplied by alpha.
struct Backing {
  std::array<float, 4> color{0, 0, 0, 1};  ///< Straight; alpha below 1.
  float depth = 1.0f;
};

/// The pixel's straight colour. Where something wrote its depth (an opaque surface, or the rest of a cut-out
/// one) the pixel is opaque, whatever alphas were multiplied; elsewhere the colour is divided by alpha.
std::array<float, 4> straight_color(const std::array<float, 4>& color, float depth, const Backing& backing);

/// All pixels of the frame, which must hold its depth, and its colours as floats where it is drawn in floats.
void make_straight(raster::Framebuffer& frame, const Backing& backing);

}  // namespace barrido::scene
