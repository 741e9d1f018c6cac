// What keys and panel do to the options of one picture, beyond a step of a single option (cli::step_option).
// Enters and leaves: options. Knows no window.
#pragma once

#include "viewer/view/viewer.h"

namespace barrido::view {

/// None, linear, exp, exp2; distances chosen so that the scene's far side fades.
void step_fog(Viewer& viewer);

/// One sample a pixel, 4, 9, 16, 64 uniform ones, 16 jittered ones, adaptive: `step` further, round and
/// round.
void step_antialiasing(Viewer& viewer, int step);

/// None, rendered from the objects' centres, and the picture that was given, where there was one.
void step_environment(Viewer& viewer);
void toggle_environment_background(Viewer& viewer);

/// Switches light `number` (from 0) on or off.
void toggle_light(cli::RenderOptions& options, int number);

/// The frame's lights as the user could have given them: the user's own, else the file's, else the presets.
std::vector<scene::UserLight> shown_lights(Viewer& viewer);

/// Puts the frame's lights into the options, where they can be changed one by one.
void take_over_lights(Viewer& viewer);

/// Takes one of the user's lights away; the others stay on or off.
void remove_light(cli::RenderOptions& options, int number);

/// The light as its text on the command line reads: angles are whole floats of degrees, and so on.
scene::UserLight canonical(const scene::UserLight& light);

}  // namespace barrido::view
