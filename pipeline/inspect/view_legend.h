// The strip below a view that says what its colours mean. Enters: the view's values; leaves: rows of pixels.
// Knows no scene.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/inspect/structure_view.h"
#include "pipeline/inspect/view_colors.h"

namespace barrido::inspect {

/// The colour of a value of the view, as in the picture.
Rgb8 color_of(const ViewValues& values, float value);

/// legend_height(values.width) rows of packed colours.
std::vector<std::uint32_t> draw_legend(const ViewValues& values);

}  // namespace barrido::inspect
