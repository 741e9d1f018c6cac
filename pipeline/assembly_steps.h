// Internal to assembly: the kinds of primitives.
#pragma once

#include <cstdint>

#include "pipeline/assembly_input.h"
#include "pipeline/chunk_writer.h"

namespace barrido::pipeline {

/// Filled polygons, a triangle at a time.
void assemble_triangles(const AssemblyInput& input, std::uint32_t first, std::uint32_t count,
                        ChunkWriter& writer, AssemblyCounts& counts);

/// Points, lines, and polygons drawn as their corners or edges.
void assemble_points(const AssemblyInput& input, std::uint32_t first, std::uint32_t count,
                     ChunkWriter& writer, AssemblyCounts& counts);
void assemble_lines(const AssemblyInput& input, std::uint32_t first, std::uint32_t count, ChunkWriter& writer,
                    AssemblyCounts& counts);
void assemble_outlines(const AssemblyInput& input, std::uint32_t first, std::uint32_t count,
                       ChunkWriter& writer, AssemblyCounts& counts);

/// A primitive's corner in clip space, for clipping; `corner` is its place in the primitive.
ClipVertex corner_in_clip_space(const AssemblyInput& input, std::uint32_t vertex, int corner);

/// Window position of a clipped vertex: that of the vertex stage where it is an untouched corner that has
/// one. `corners` may be of either side.
WindowVertex window_position(const AssemblyInput& input, const ClipVertex& vertex,
                             const ClipCorners& corners);

/// Its number in the chunk: the shared vertex's where it is an untouched corner, else that of a new one.
std::uint32_t vertex_number(const AssemblyInput& input, const ClipVertex& vertex, const ClipCorners& corners,
                            ChunkWriter& writer);

/// Number of the record that a primitive refers to on the side that is seen.
inline std::uint32_t number_on_side(const AssemblyInput& input, std::uint32_t vertex, bool back) {
  return back && input.plan.has_back_side ? vertex + input.vertices.capacity : vertex;
}

}  // namespace barrido::pipeline
