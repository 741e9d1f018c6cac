// The strip below a view that says what its colours mean. Enters: the view's values; leaves: rows of pixels.
// Knows no scene.
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/inspect/structure_view.h"

namespace barrido::sheet {

/// Height in pixels of the legend of a picture of this width.
int legend_height(int width);

/// legend_height(values.width) rows of packed colours.
std::vector<std::uint32_t> draw_legend(const inspect::ViewValues& values);

}  // namespace barrido::sheet
