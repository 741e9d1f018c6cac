// The panel beside the picture: every setting as a switch, a list or a number. Enters: the viewer; leaves:
// the viewer changed. Knows neither the window nor the mouse in the picture.
#pragma once

#include <string>

#include "viewer/view/viewer.h"

namespace barrido::window {

/// Width of the panel in ImGui's units at scale 1.
inline constexpr float kPanelUnits = 320.0f;

/// Call between the beginning and the end of an ImGui frame.
void draw_panel(view::Viewer& viewer, const std::string& status, float scale);

}  // namespace barrido::window
