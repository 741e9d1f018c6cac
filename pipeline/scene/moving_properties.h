// Materials, lights and cameras at a moment of an animation (KHR_animation_pointer). Must not know: nodes.
#pragma once

#include "pipeline/scene/scene.h"

namespace barrido::scene {

/// Whether any animation moves a property of these.
bool has_moving_properties(const Scene& scene);

/// What changes in a scene from moment to moment, and all that refers to it; pictures are left out.
Scene copy_without_pictures(const Scene& scene);

/// Makes the materials, lights and cameras of `moved`, a copy of `scene`, what they are at `time_s` of
/// `animation` (kNone: as they stand). Values outside of what a property may be are brought to its bounds.
void move_properties(const Scene& scene, int animation, double time_s, Scene& moved);

/// KHR_texture_transform: scale, then rotation, then offset. A positive angle turns the coordinates
/// counter-clockwise as one looks at the picture, whose v axis points down.
glm::mat3 texture_matrix(const glm::vec2& offset, double rotation_rad, const glm::vec2& scale);

}  // namespace barrido::scene
