// Which varyings a draw's vertex records carry, and where: what its stages read. Enters: the stages; leaves:
// the list. Only what the fragments need is recorded, because every varying costs time per vertex, primitive
// and pixel.
#pragma once

#include <span>

#include "pipeline/geometry.h"
#include "pipeline/state.h"
#include "raster/fragments/fragment_state.h"

namespace barrido::pipeline {

/// Where the colours of a draw are made. `lit`: lighting is on. `has_colors`: the vertices have their own.
ColorOrigin color_origin(const State& state, bool lit, bool has_colors);

/// What the coordinates of an active texture unit are made of.
raster::TexcoordKind texcoord_kind(const State& state, const Geometry& geometry, std::size_t unit);

/// The varyings that the stages read, those linear on the screen first; then what the stages compute.
raster::VaryingList lay_out(const State& state, const Geometry& geometry,
                            std::span<const raster::FragmentStage> stages);

/// Whether every vertex has w = 1 after projection, exactly.
bool has_unit_w(const State& state, const Geometry& geometry);

}  // namespace barrido::pipeline
