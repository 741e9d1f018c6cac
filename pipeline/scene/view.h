// From cameras, overrides and the scene's bounds to the two matrices of a view. Angles and directions mean
// what they do in VTK and F3D. Knows no lights and no materials.
#pragma once

#include <vector>

#include "pipeline/scene/framing.h"
#include "pipeline/scene/render_scene.h"

namespace barrido::scene {

/// An eye and its lens, before they become matrices. World space, double precision.
struct Eye {
  glm::dvec3 position{0, 0, 1};
  glm::dvec3 focal_point{0, 0, 0};
  glm::dvec3 up{0, 1, 0};
  bool orthographic = false;
  double vertical_fov_rad = 0.5;  ///< Perspective: full angle, (0, π)
  double half_height = 1.0;       ///< Orthographic
  double near_plane = 0.0;        ///< 0: chosen from the bounds, with the far plane
  double far_plane = 0.0;         ///< 0: infinite
};

/// What CameraChoice holds of a place: floats, but double precision where they are coarse.
glm::dvec3 kept_place(const glm::dvec3& place);

/// The camera of `camera_node`, looking at the depth of the bounds' centre; its scaling is ignored (glTF 2.0,
/// section 3.10).
Eye eye_of_camera(const Scene& scene, const Pose& pose, int camera_node, const Sphere& bounds);

/// An eye that sees all of `bounds`.
Eye framing_eye(const Bounds& bounds, const CameraChoice& choice, double aspect);

/// The eye for these settings: file camera or framing, then position, focal point and view angle where given,
/// then azimuth about the up direction and elevation towards it. A file's near and far plane stay, and move
/// apart where the eye was moved and the bounds ask for it.
/// @throws InputError when the camera asked for does not exist.
Eye choose_eye(const Scene& scene, const std::vector<int>& nodes, const Pose& pose, const Bounds& bounds,
               const RenderSettings& settings);

/// The rigid motion that puts an eye at the origin, looking along −Z. `forward` is a unit vector; `up` need
/// only not be parallel to it, and even that does no harm.
glm::mat4 eye_from_world(const glm::dvec3& position, const glm::dvec3& forward, const glm::dvec3& up);

/// Matrices of `eye` for a frame of this aspect (width / height), whose world is the file's about `origin`.
View view_of(const Eye& eye, const Sphere& bounds, double aspect, const glm::dvec3& origin = {0, 0, 0});

}  // namespace barrido::scene
