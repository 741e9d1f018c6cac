// Internal to the reference: maps of normals, heights and occlusion as GLSL 1.20, for programs that light
// fragments. glTF 2.0, section 3.9.3, and Blinn 1978. Tangents come in the coordinates of units 6 and 7,
// which a draw with such a map must leave free.
#pragma once

#include <string>

#include "pipeline/geometry.h"
#include "pipeline/state.h"

namespace barrido::osmesa {

/// Defines `void make_tangents()`; empty functions where the state has no map.
std::string vertex_map_stages(const pipeline::State& state);

/// Defines `vec3 mapped(vec3 n)`, of the interpolated normal, and `float unoccluded()`.
/// @throws std::runtime_error for heights in space.
std::string fragment_map_stages(const pipeline::State& state);

/// Hands over the geometry's tangents. @throws std::runtime_error where units 6 and 7 are in use.
void set_tangents(const pipeline::State& state, const pipeline::Geometry& geometry);

}  // namespace barrido::osmesa
