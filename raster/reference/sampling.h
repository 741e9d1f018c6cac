// A texture's colour at one place: wrap modes, choice of mip levels, filters. Enters coordinates and λ; knows
// nothing of what the colour is used for.
#pragma once

#include "raster/fragment_state.h"
#include "raster/reference/arithmetic.h"
#include "raster/reference/trace.h"

namespace barrido::raster::reference {

/// `coordinates` holds two or three numbers, as `kind` says; `lod` is λ without the unit's bias. What was
/// read is remembered in `trace` unless that is null.
Color sample_texture(const TextureUnit& unit, TexcoordKind kind, const float (&coordinates)[3], float lod,
                     SampleTrace* trace = nullptr);

}  // namespace barrido::raster::reference
