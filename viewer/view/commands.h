// What keys and panel do to the options of one picture. Enters and leaves: options. Knows no window.
#pragma once

#include "viewer/view/viewer.h"

namespace barrido::view {

/// The next (step 1) or previous (step −1) shading mode, round.
void step_shading(cli::RenderOptions& options, int step);

/// The picture, then each view of what it costs and is made of, round.
void step_view(cli::RenderOptions& options, int step);

/// The file's, then each filter in OpenGL's order, round.
void step_min_filter(cli::RenderOptions& options, int step);
void step_mag_filter(cli::RenderOptions& options, int step);

/// As the materials say, none, back, front.
void step_culling(cli::RenderOptions& options);

/// None, linear, exp, exp2; distances chosen so that the scene's far side fades.
void step_fog(Viewer& viewer);

/// None, rendered from the objects' centres, and the picture that was given, where there was one.
void step_environment(Viewer& viewer);
void toggle_environment_background(Viewer& viewer);

/// Switches light `number` (from 0) on or off.
void toggle_light(cli::RenderOptions& options, int number);

/// Brightens by so many stops, within the option's bounds.
void change_exposure(cli::RenderOptions& options, float stops);

/// The frame's lights as the user could have given them: the user's own, else the file's, else the presets.
std::vector<scene::UserLight> shown_lights(Viewer& viewer);

/// Puts the frame's lights into the options, where they can be changed one by one.
void take_over_lights(Viewer& viewer);

/// Takes one of the user's lights away; the others stay on or off.
void remove_light(cli::RenderOptions& options, int number);

/// The light as its text on the command line reads: angles are whole floats of degrees, and so on.
scene::UserLight canonical(const scene::UserLight& light);

}  // namespace barrido::view
