// Where a scene is and how to look at all of it. Enters: posed vertices; leaves: a sphere around them and an
// eye that sees the whole sphere. Knows no settings and no matrices.
#pragma once

#include <span>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "pipeline/scene/animate.h"
#include "pipeline/scene/scene.h"

namespace barrido::scene {

/// World space. The radius is never 0: an empty scene counts as the unit sphere at the origin, a single point
/// as a sphere of one unit.
struct Sphere {
  glm::dvec3 center{0.0};
  double radius = 1.0;
};

/// A sphere, and within it the body that the scene fills when it is turned about an upright axis through the
/// centre: rings of radius x at height y, relative to the centre.
struct Bounds {
  Sphere sphere;
  std::vector<glm::dvec2> rings;
};

/// The sphere about the middle of the bounding box of all vertices that `nodes` draw in any of `poses`, and
/// the rings around `up`, in the file's world. Vertices that no triangle, line or point uses, and those that
/// are not finite, are left out.
Bounds find_bounds(const Scene& scene, std::span<const int> nodes, std::span<const Pose> poses,
                   const glm::dvec3& up);

/// The poses that framing looks at: the scene as it stands, or nine moments spread over the animation, so
/// that the eye stays where it is from frame to frame.
std::vector<Pose> framing_poses(const Scene& scene, int animation);

/// The smallest turn that takes +Y to `up`; half a turn about X for −Y. It takes +Z, the front, to −Y for
/// up = +Z.
glm::dmat3 world_from_upright(const glm::dvec3& up);

/// Direction from the scene to an eye that looks at it from the front, a little from the right and from
/// above.
glm::dvec3 default_eye_direction(const glm::dvec3& up);

/// Unit vector along `v`, or `fallback` when v has no direction.
glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& fallback);

/// `p` turned by the right-hand rule about the unit vector `axis` (Rodrigues' formula).
glm::dvec3 turned(const glm::dvec3& p, const glm::dvec3& axis, double angle_deg);

/// Distance from the centre, in the default direction, at which every ring is in a view of this full vertical
/// angle and aspect (width / height), with a small margin. It does not depend on the azimuth, so that nothing
/// leaves the frame and nothing grows or shrinks while a turntable turns.
double framing_distance(const Bounds& bounds, double vertical_fov_rad, double aspect);

}  // namespace barrido::scene
