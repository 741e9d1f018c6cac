#include "viewer/view/camera_moves.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "raster/base/portable_math.h"

namespace barrido::view {
namespace {

using scene::Eye;
using scene::turned;
using scene::unit_or;

constexpr double kPoleDeg = 89.5;
constexpr double kStandardFovDeg = 30.0;  ///< Of a frame without --camera-view-angle
constexpr double kLargest = 1e12;         ///< Of distances: a float squared must not overflow.

double length(const glm::dvec3& v) { return std::sqrt(glm::dot(v, v)); }

glm::dvec3 forward_of(const Eye& eye) { return unit_or(eye.focal_point - eye.position, {0, 0, -1}); }

/// The picture's right, from an up that need not be at right angles.
glm::dvec3 right_of(const Eye& eye) {
  const glm::dvec3 across = glm::cross(forward_of(eye), unit_or(eye.up, {0, 1, 0}));
  if (glm::dot(across, across) > 1e-12) return unit_or(across, {1, 0, 0});
  const glm::dvec3 other = glm::cross(forward_of(eye), glm::dvec3(0, 0, -1));
  return glm::dot(other, other) > 1e-12 ? unit_or(other, {1, 0, 0}) : glm::dvec3(1, 0, 0);
}

void turn(Eye& eye, const glm::dvec3& axis, double degrees) {
  eye.position = eye.focal_point + turned(eye.position - eye.focal_point, axis, degrees);
  eye.up = turned(eye.up, axis, degrees);
}

/// Whether `up` shows as upright in the picture as `upright` does.
bool is_level(const Eye& eye, const glm::dvec3& upright) {
  const glm::dvec3 forward = forward_of(eye);
  const auto across = [&](const glm::dvec3& v) { return v - forward * glm::dot(v, forward); };
  const glm::dvec3 wanted = across(upright);
  if (glm::dot(wanted, wanted) < 1e-8) return false;
  return glm::dot(unit_or(across(eye.up), {0, 0, 0}), unit_or(wanted, {0, 0, 0})) > 1.0 - 1e-10;
}

}  // namespace

void orbit(Eye& eye, const glm::dvec3& upright, double right_deg, double up_deg) {
  turn(eye, upright, right_deg);
  const glm::dvec3 offset = unit_or(eye.position - eye.focal_point, {0, 0, 1});
  const double elevation_deg = portable_asin(glm::dot(offset, upright)) * (180.0 / kPi);
  // From beyond the limit (a top view) one may come back, but not go on.
  const double least = std::min(-kPoleDeg, elevation_deg), most = std::max(kPoleDeg, elevation_deg);
  const double wanted = std::clamp(elevation_deg + up_deg, least, most);
  // Level and at right angles to both; where the eye is over the pole, the picture's own right.
  const glm::dvec3 across = glm::cross(upright, offset);
  const glm::dvec3 axis = glm::dot(across, across) > 1e-8 ? unit_or(across, {1, 0, 0}) : right_of(eye);
  turn(eye, axis, elevation_deg - wanted);
}

double height_at_focus(const Eye& eye) {
  if (eye.orthographic) return 2.0 * eye.half_height;
  return 2.0 * length(eye.focal_point - eye.position) * portable_tan(eye.vertical_fov_rad * 0.5);
}

void pan(Eye& eye, double right, double up) {
  const glm::dvec3 x = right_of(eye);
  const glm::dvec3 y = glm::cross(x, forward_of(eye));
  const glm::dvec3 move = (x * -right + y * -up) * height_at_focus(eye);
  if (length(eye.focal_point + move) > kLargest) return;
  eye.position += move;
  eye.focal_point += move;
}

void zoom(Eye& eye, double factor) {
  if (eye.orthographic) {
    eye.half_height = std::clamp(eye.half_height / factor, 1e-12, kLargest);
    return;
  }
  const glm::dvec3 offset = eye.position - eye.focal_point;
  const double distance = length(offset);
  // A float's steps at the focal point bound how near one may come.
  const double nearest = std::max(1e-12, length(eye.focal_point) * 1e-5);
  const double wanted = std::clamp(distance / factor, nearest, kLargest);
  eye.position = eye.focal_point + unit_or(offset, {0, 0, 1}) * wanted;
}

void roll(Eye& eye, double degrees) { eye.up = turned(eye.up, forward_of(eye), degrees); }

void look_from(Eye& eye, StandardView side, const scene::Sphere& bounds, const glm::dvec3& upright,
               double aspect) {
  const glm::dmat3 turn = scene::world_from_upright(upright);
  glm::dvec3 direction = turn[2];
  eye.up = upright;
  if (side == StandardView::right) direction = turn[0];
  if (side == StandardView::isometric) direction = unit_or(turn[0] + turn[1] + turn[2], {0, 0, 1});
  if (side == StandardView::top) {
    direction = turn[1];
    eye.up = -turn[2];
  }
  const double narrower = std::min(1.0, aspect);
  const double half_angle = eye.orthographic
                                ? radians(kStandardFovDeg * 0.5)
                                : portable_atan2(portable_tan(eye.vertical_fov_rad * 0.5) * narrower, 1.0);
  constexpr double kMargin = 1.02;
  eye.focal_point = bounds.center;
  eye.position = bounds.center + direction * (bounds.radius * kMargin / portable_sin(half_angle));
  if (eye.orthographic) eye.half_height = bounds.radius * kMargin / narrower;
}

void toggle_orthographic(Eye& eye) {
  const double height = height_at_focus(eye);
  if (!eye.orthographic) {
    eye.orthographic = true;
    eye.half_height = height * 0.5;
    return;
  }
  eye.orthographic = false;
  eye.vertical_fov_rad = radians(kStandardFovDeg);
  const double distance = height * 0.5 / portable_tan(eye.vertical_fov_rad * 0.5);
  eye.position = eye.focal_point - forward_of(eye) * distance;
}

void set_camera(scene::CameraChoice& choice, const Eye& eye, bool of_file) {
  const glm::vec3 up = choice.up;
  choice = {};
  choice.up = up;
  choice.ignore_file_cameras = true;
  choice.position = scene::kept_place(eye.position);
  choice.focal_point = scene::kept_place(eye.focal_point);
  if (*choice.position == *choice.focal_point) *choice.position += glm::dvec3(0, 0, 1);
  if (!is_level(eye, unit_or(glm::dvec3(up), {0, 1, 0}))) choice.view_up = glm::vec3(eye.up);
  if (eye.orthographic) {
    choice.orthographic_height = static_cast<float>(eye.half_height * 2.0);
    return;
  }
  const auto angle_deg = std::clamp(static_cast<float>(eye.vertical_fov_rad * (180.0 / kPi)), 1.0f, 170.0f);
  const bool standard = std::abs(angle_deg - static_cast<float>(kStandardFovDeg)) <= 1e-4f;
  if (of_file || !standard) choice.view_angle_deg = angle_deg;
}

}  // namespace barrido::view
