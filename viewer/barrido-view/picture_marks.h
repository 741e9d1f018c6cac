// What stands over the picture and is no part of it: help, counters, messages, the divider, handles of
// lights. Enters: the viewer; leaves: ImGui's windows and lines. Changes nothing.
#pragma once

#include "viewer/barrido-view/pointer.h"
#include "viewer/view/viewer.h"

namespace barrido::window {

/// `pixels_per_unit`: pixels of the picture a unit of ImGui's coordinates.
void draw_marks(view::Viewer& viewer, Pointer& pointer, float scale, float pixels_per_unit);

/// Whether the pixel lay under the help or another window when the marks were drawn last.
bool is_over_marks(double x, double y);

}  // namespace barrido::window
