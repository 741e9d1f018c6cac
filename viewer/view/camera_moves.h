// What the mouse and the view keys do to a camera: orbit, pan, zoom, roll, standard views. Enters: an eye as
// the renderer sees it; leaves: the choice of a camera as the command line spells it. Knows no window.
#pragma once

#include "pipeline/scene/view.h"

namespace barrido::view {

/// Turns the eye about its focal point: `right_deg` about `upright` (a unit vector, the scene's up), so that
/// the eye moves to the right, and `up_deg` towards it; it stops short of the poles. A roll is kept.
void orbit(scene::Eye& eye, const glm::dvec3& upright, double right_deg, double up_deg);

/// Moves eye and focal point so that the scene moves by these parts of the picture's height.
void pan(scene::Eye& eye, double right, double up);

/// Divides the distance (perspective) or the height seen (parallel rays) by `factor` > 0.
void zoom(scene::Eye& eye, double factor);

/// Turns the camera about its line of sight so that the picture turns counter-clockwise.
void roll(scene::Eye& eye, double degrees);

enum class StandardView { front, right, top, isometric };

/// Puts the eye where it sees the whole sphere from this side.
void look_from(scene::Eye& eye, StandardView side, const scene::Sphere& bounds, const glm::dvec3& upright,
               double aspect);

/// Between perspective and parallel rays; what lies at the focal point keeps its size.
void toggle_orthographic(scene::Eye& eye);

/// The height of what is seen at the focal point's distance.
double height_at_focus(const scene::Eye& eye);

/// Writes the eye into the choice, in the fewest options; `choice.up` is kept. `of_file`: the choice goes
/// with a camera of the file, whose lens need not be the standard one.
void set_camera(scene::CameraChoice& choice, const scene::Eye& eye, bool of_file);

}  // namespace barrido::view
