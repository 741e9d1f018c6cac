// Fog on the command line: "linear:2,10:0.5,0.6,0.7" becomes a fog state.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "raster/fragments/fragment_state.h"
#include "viewer/barrido/usage_error.h"

namespace barrido::cli {

struct FogChoice {
  raster::FogState state;                           ///< Its colour is not set here.
  std::optional<std::array<float, 3>> color_shown;  ///< As it is to be seen; empty: the background's.
};

/// linear:START,END[:R,G,B], exp:DENSITY[:R,G,B] or exp2:DENSITY[:R,G,B]; distances in the model's units from
/// the eye, colours in [0, 1] as they are to be seen.
/// @throws ValueError.
FogChoice parse_fog(std::string_view spec);

}  // namespace barrido::cli
