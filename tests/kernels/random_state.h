// Random fragment states: every field of FragmentState takes every value that changes what is computed.
#pragma once

#include <string>

#include "random_bits.h"
#include "random_textures.h"
#include "raster/fragments/fragment_state.h"

namespace barrido::raster::testing {

/// `opaque` states have no blending, alpha test or colour mask, so that visibility may be resolved first.
FragmentState random_state(RandomBits& random, const TexturePool& textures, bool opaque, int frame_width,
                           int frame_height);

/// Colours alone, flat or interpolated, opaque or blended in one of the usual ways, mostly with the usual
/// depth test: the states whose fragments go straight to the 8-bit surface.
FragmentState random_simple_state(RandomBits& random, int frame_width, int frame_height);

/// One line for messages.
std::string describe(const FragmentState& state);

}  // namespace barrido::raster::testing
