// From an interpolated fragment to its final colour, along the stages of its state: primary and secondary
// colours, texture units, colour sum, fog. Enters and leaves a fragment; knows nothing of the frame.
#pragma once

#include <array>

#include "raster/reference/fragment.h"
#include "raster/reference/trace.h"

namespace barrido::raster::reference {

/// The fraction f of the fragment's own colour that fog leaves, for a fog distance ≥ 0.
float fog_fraction(const FogState& fog, float distance);

// The scalar functions of the stages (raster/fragments/fragment_stage.h).
void take_colors(const FragmentStage& stage, Fragment& fragment, ShadingTrace* trace);
void apply_texture(const FragmentStage& stage, Fragment& fragment, ShadingTrace* trace);
void apply_shine(const FragmentStage& stage, Fragment& fragment, ShadingTrace* trace);
void add_secondary(const FragmentStage& stage, Fragment& fragment, ShadingTrace* trace);
void apply_fog(const FragmentStage& stage, Fragment& fragment, ShadingTrace* trace);

/// The texel of `unit` at the fragment's coordinates, moved by `shift`: of its picture, or of the procedure
/// in its place.
Color unit_texel(const Fragment& fragment, int unit, UnitTrace* trace,
                 const std::array<float, 3>& shift = {0, 0, 0});

/// The colour of the fragment, whose depth, varyings and levels of detail are set and whose colours are those
/// of the primitive where it is flat. The steps are remembered in `trace` unless that is null.
Color shade_fragment(Fragment& fragment, ShadingTrace* trace = nullptr);

}  // namespace barrido::raster::reference
