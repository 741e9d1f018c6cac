// The surroundings that metals reflect when the user gives none: a grey photographer's studio with two soft
// boxes, computed here. It is fixed to the eye, as the three-light set-up is.
#pragma once

#include "raster/textures/texture.h"

namespace barrido::scene {

/// Cube map in eye space. Its bytes look alike on the screen whether the frame is computed in linear light
/// (srgb) or in screen values (linear).
raster::Texture make_studio(raster::Encoding encoding);

}  // namespace barrido::scene
