// Textures by procedure and mappings of a state's units as GLSL 1.20, written from Perlin's description of
// improved noise and Bier and Sloan's of two-part mapping.
#pragma once

#include <string>

#include "raster/fragments/fragment_state.h"

namespace barrido::osmesa {

/// Functions that the two below call, for units that have a procedure or a mapping; empty for others.
std::string procedure_functions(const raster::TextureUnit& unit, const std::string& index);

/// The texel of a procedure at the coordinates `at`, a vec3: an expression.
std::string procedure_texel(const raster::TextureUnit& unit, const std::string& index, const std::string& at);

/// (s, t) that a mapping makes of the point `at`: an expression. Phong shading has the varyings it may read.
std::string mapped_place(const std::string& index, const std::string& at);

}  // namespace barrido::osmesa
