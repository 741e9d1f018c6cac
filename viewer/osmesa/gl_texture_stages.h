// Internal to the reference: texture coordinates and texture environments as GLSL 1.20, for programs that
// stand in for fixed function. OpenGL 1.3, sections 2.10.4 and 3.8.12.
#pragma once

#include <string>

#include "pipeline/state.h"

namespace barrido::osmesa {

/// Defines `void make_texture_coordinates(vec3 n, vec3 p)`, from eye normal and position. Of the generated
/// coordinates it knows reflection_map, in s, t and r at once.
/// @throws std::runtime_error for others.
std::string vertex_texture_stages(const pipeline::State& state);

/// Defines `vec4 finish(vec4 primary, vec3 secondary)`: the units' environments, then the separate specular
/// colour. @throws std::runtime_error for the modes decal and blend.
std::string fragment_texture_stages(const pipeline::State& state);

/// Sets the samplers of a linked program that is current: unit i is read by tex<i>.
void set_samplers(unsigned program, const pipeline::State& state);

}  // namespace barrido::osmesa
