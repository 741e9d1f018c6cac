// Triangle lists. Enters: a primitive in any mode; leaves: three vertex indices a triangle, wound and ordered
// as OpenGL does (the last vertex is the provoking one).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/geometry.h"

namespace barrido::scene {

/// Triangles, strips and fans: what glTF can hold of surfaces.
bool is_surface(pipeline::PrimitiveMode mode);

/// Three indices a triangle of a surface; empty for points and lines. With no `indices` the vertices stand in
/// order. Incomplete triangles at the end are left out.
std::vector<std::uint32_t> triangle_list(pipeline::PrimitiveMode mode, std::span<const std::uint32_t> indices,
                                         std::uint32_t vertex_count);

/// Which vertices belong to a point, a line or a triangle; empty when all do.
std::vector<bool> drawn_vertices(pipeline::PrimitiveMode mode, std::span<const std::uint32_t> indices,
                                 std::uint32_t vertex_count);

}  // namespace barrido::scene
