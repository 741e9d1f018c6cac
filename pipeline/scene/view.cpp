#include "pipeline/scene/view.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "pipeline/files/error.h"
#include "pipeline/matrix.h"
#include "pipeline/scene/scene_nodes.h"
#include "raster/base/portable_math.h"

namespace barrido::scene {
namespace {

constexpr double kFramingFovDeg = 30.0;

/// Some unit vector at right angles to `forward`, as near to `up` as can be.
glm::dvec3 upright(const glm::dvec3& up, const glm::dvec3& forward) {
  const auto part_across = [&](const glm::dvec3& v) { return v - forward * glm::dot(v, forward); };
  const glm::dvec3 wanted = part_across(unit_or(up, {0, 1, 0}));
  if (glm::dot(wanted, wanted) > 1e-12) return unit_or(wanted, {0, 1, 0});
  // Looking straight up or down: take the axis that is most across.
  const glm::dvec3 size = glm::abs(forward);
  const glm::dvec3 axis = size.z <= size.x && size.z <= size.y   ? glm::dvec3(0, 0, 1)
                          : size.y <= size.x && size.y <= size.z ? glm::dvec3(0, 1, 0)
                                                                 : glm::dvec3(1, 0, 0);
  return unit_or(part_across(axis), {0, 1, 0});
}

/// vtkCamera::Azimuth and Elevation: positive angles move the eye to the right and up. The azimuth turns
/// about the scene's up direction, also for cameras that are tilted, so that a turntable stays level.
void orbit(Eye& eye, const CameraChoice& choice) {
  if (choice.azimuth_deg != 0.0f) {
    const glm::dvec3 axis = unit_or(glm::dvec3(choice.up), {0, 1, 0});
    eye.position = eye.focal_point + turned(eye.position - eye.focal_point, axis, choice.azimuth_deg);
    eye.up = turned(eye.up, axis, choice.azimuth_deg);
  }
  if (choice.elevation_deg != 0.0f) {
    const glm::dvec3 forward = unit_or(eye.focal_point - eye.position, {0, 0, -1});
    const glm::dvec3 up = upright(eye.up, forward);
    const glm::dvec3 right = glm::cross(forward, up);
    eye.position = eye.focal_point + turned(eye.position - eye.focal_point, right, -choice.elevation_deg);
    eye.up = turned(up, right, -choice.elevation_deg);
  }
}

void apply_overrides(Eye& eye, const CameraChoice& choice) {
  if (choice.position || choice.focal_point) {
    if (choice.position) eye.position = *choice.position;
    if (choice.focal_point) eye.focal_point = *choice.focal_point;
    eye.up = unit_or(glm::dvec3(choice.up), {0, 1, 0});
  }
  if (choice.view_angle_deg) {
    eye.orthographic = false;
    eye.vertical_fov_rad = radians(std::clamp<double>(*choice.view_angle_deg, 0.01, 179.0));
  }
  if (choice.view_up) eye.up = unit_or(glm::dvec3(*choice.view_up), eye.up);
  if (choice.orthographic_height) {
    eye.orthographic = true;
    eye.half_height = *choice.orthographic_height * 0.5;
  }
}

glm::dvec3 forward_of(const Eye& eye, const Sphere& bounds) {
  return unit_or(eye.focal_point - eye.position, unit_or(bounds.center - eye.position, {0, 0, -1}));
}

/// Where the file has none: near and far planes just around the bounds; the near one at least a thousandth of
/// the far one, so that depth keeps enough steps when the eye is inside. An eye that was taken elsewhere
/// keeps its camera's planes, moved apart so far as the bounds ask for: what was seen is never cut off.
void choose_planes(Eye& eye, const Sphere& bounds, const CameraChoice& choice) {
  const bool moved = choice.position || choice.focal_point || choice.orthographic_height;
  const bool given = eye.near_plane > 0.0 || (eye.orthographic && eye.far_plane > 0.0);
  if (given && !moved) return;
  const double depth = glm::dot(bounds.center - eye.position, forward_of(eye, bounds));
  const double reach = bounds.radius * 1.02;
  const double far_plane = depth + reach > 0.0 ? depth + reach : reach;
  const double near_plane = std::max(depth - reach, far_plane * 1e-3);
  const bool infinite = given && eye.far_plane == 0.0 && !eye.orthographic;
  eye.near_plane = given ? std::min(eye.near_plane, near_plane) : near_plane;
  eye.far_plane = infinite ? 0.0 : std::max(given ? eye.far_plane : 0.0, far_plane);
}

/// Of floats from 0 to 1 those near 1 are 6·10⁻⁸ apart: beyond this ratio of far to near all far things would
/// have one depth.
constexpr double kCoarseRatio = 1e6;

/// The ratio of the farthest thing's distance to the near plane's.
double depth_ratio(const Eye& eye, const Sphere& bounds) {
  if (eye.orthographic || !(eye.near_plane > 0.0)) return 1.0;
  return (glm::dot(bounds.center - eye.position, forward_of(eye, bounds)) + bounds.radius) / eye.near_plane;
}

/// A near plane much nearer than anything moves up to what is seen first: nothing is cut off.
void spare_depth(Eye& eye, const Sphere& bounds) {
  if (depth_ratio(eye, bounds) <= kCoarseRatio) return;
  const double depth = glm::dot(bounds.center - eye.position, forward_of(eye, bounds));
  const double nearest = depth - bounds.radius * 1.02 - std::abs(depth) * 1e-3;
  if (eye.far_plane != 0.0 && !(nearest < eye.far_plane)) return;  // nothing of it can be seen anyway
  eye.near_plane = std::max(eye.near_plane, nearest);
}

}  // namespace

glm::dvec3 kept_place(const glm::dvec3& place) {
  return is_far(place) ? place : glm::dvec3(glm::vec3(place));
}

Eye eye_of_camera(const Scene& scene, const Pose& pose, int camera_node, const Sphere& bounds) {
  const auto node = static_cast<std::size_t>(camera_node);
  const Camera& camera = scene.cameras[static_cast<std::size_t>(scene.nodes[node].camera)];
  const glm::dmat4 world_from_node = file_world_from_node(pose, node);
  Eye eye;
  eye.position = glm::dvec3(world_from_node[3]);
  eye.up = unit_or(glm::dvec3(world_from_node[1]), {0, 1, 0});
  const glm::dvec3 forward = unit_or(-glm::dvec3(world_from_node[2]), {0, 0, -1});
  const double depth = glm::dot(bounds.center - eye.position, forward);
  eye.focal_point = eye.position + forward * (depth > 0.0 ? depth : bounds.radius);
  eye.orthographic = camera.kind == Camera::Kind::orthographic;
  eye.vertical_fov_rad = camera.vertical_fov_rad;
  eye.half_height = std::abs(camera.half_height);
  eye.near_plane = camera.near_plane;
  eye.far_plane = camera.far_plane;
  return eye;
}

Eye framing_eye(const Bounds& bounds, const CameraChoice& choice, double aspect) {
  Eye eye;
  eye.up = unit_or(glm::dvec3(choice.up), {0, 1, 0});
  eye.vertical_fov_rad = radians(kFramingFovDeg);
  eye.focal_point = bounds.sphere.center;
  double fov = eye.vertical_fov_rad;
  if (choice.view_angle_deg) fov = radians(std::clamp<double>(*choice.view_angle_deg, 0.01, 179.0));
  eye.position = bounds.sphere.center + default_eye_direction(eye.up) * framing_distance(bounds, fov, aspect);
  return eye;
}

Eye choose_eye(const Scene& scene, const std::vector<int>& nodes, const Pose& pose, const Bounds& bounds,
               const RenderSettings& settings) {
  const CameraChoice& choice = settings.camera;
  const std::vector<int> cameras = camera_nodes(scene, nodes);
  const int count = static_cast<int>(cameras.size());
  if (choice.camera_index != kNone && (choice.camera_index < 0 || choice.camera_index >= count)) {
    throw InputError(scene.source, "camera " + std::to_string(choice.camera_index),
                     "the scene has " + std::to_string(count) + (count == 1 ? " camera" : " cameras"));
  }
  const bool from_file = choice.camera_index != kNone || (count > 0 && !choice.ignore_file_cameras);
  const std::size_t index = static_cast<std::size_t>(std::max(choice.camera_index, 0));
  Eye eye = from_file ? eye_of_camera(scene, pose, cameras[index], bounds.sphere)
                      : framing_eye(bounds, choice, static_cast<double>(settings.width) / settings.height);
  apply_overrides(eye, choice);
  orbit(eye, choice);
  choose_planes(eye, bounds.sphere, choice);
  spare_depth(eye, bounds.sphere);
  return eye;
}

glm::mat4 eye_from_world(const glm::dvec3& position, const glm::dvec3& forward, const glm::dvec3& up) {
  const glm::dvec3 y = upright(up, forward);
  const glm::dvec3 x = glm::cross(forward, y);
  const glm::dvec3 origin(-glm::dot(x, position), -glm::dot(y, position), glm::dot(forward, position));
  return glm::mat4(glm::dmat4(glm::dvec4(x.x, y.x, -forward.x, 0.0), glm::dvec4(x.y, y.y, -forward.y, 0.0),
                              glm::dvec4(x.z, y.z, -forward.z, 0.0), glm::dvec4(origin, 1.0)));
}

View view_of(const Eye& eye, const Sphere& bounds, double aspect, const glm::dvec3& origin) {
  View view;
  view.eye_from_world = scene::eye_from_world(eye.position - origin, forward_of(eye, bounds), eye.up);
  // What rounds to the largest depth is still in front of what is not there.
  if (depth_ratio(eye, bounds) > kCoarseRatio) view.clear_depth = 2.0f;
  if (eye.orthographic) {
    const double half_width = eye.half_height * aspect;
    view.clip_from_eye = pipeline::orthographic(-half_width, half_width, -eye.half_height, eye.half_height,
                                                eye.near_plane, eye.far_plane);
  } else {
    view.clip_from_eye = pipeline::perspective(eye.vertical_fov_rad, aspect, eye.near_plane, eye.far_plane);
  }
  return view;
}

}  // namespace barrido::scene
