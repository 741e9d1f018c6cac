// Primitive assembly: elements become points, lines and triangles in the window; what cannot be seen is left
// out, and what crosses a clip plane is clipped. Enters: transformed vertices; leaves: chunks for the
// rasterizer. Runs of units are independent of each other, so that any number of threads may share them.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/assembly_input.h"
#include "raster/fragments/primitive.h"

namespace barrido::pipeline {

/// Units of work in a draw: triangles where polygons are filled; else the mode's points, lines or polygons.
std::uint32_t unit_count(const AssemblyInput& input);

/// Units that one call of assemble() should take; even, so that it never cuts a quad.
inline constexpr std::uint32_t kAssemblyUnits = 2048;

struct Assembled {
  std::vector<raster::PrimitiveChunk> chunks;  ///< In the order of the units.
  /// For each chunk, where AssemblyInput::with_sources: see AssembledChunk.
  std::vector<std::vector<std::uint32_t>> sources;
  AssemblyCounts counts;
};

/// Assembles `count` units from the `first`.
Assembled assemble(const AssemblyInput& input, std::uint32_t first, std::uint32_t count);

}  // namespace barrido::pipeline
