// The stages of a state whose varyings are placed already, as a draw's plan would make them.
#pragma once

#include <span>

#include "raster/fragments/fragment_state.h"

namespace barrido::raster::testing {

inline void compile_stages(FragmentState& state, std::span<const FragmentStage> before = {}) {
  StageInputs inputs;
  inputs.color = before.empty() && state.varyings.has(Meaning::color);
  inputs.specular = before.empty() && state.varyings.has(Meaning::specular);
  for (std::size_t unit = 0; unit < kMaxTextureUnits; ++unit) {
    const TextureUnit& u = state.texture_units[unit];
    if (u.texture != nullptr || u.procedure != nullptr) {
      inputs.coordinates[unit] = state.varyings.floats(Meaning::texcoord, static_cast<int>(unit));
    }
  }
  state.stages = make_stages(state, before, inputs);
}

}  // namespace barrido::raster::testing
