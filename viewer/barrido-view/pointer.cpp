#include "viewer/barrido-view/pointer.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "raster/base/portable_math.h"
#include "viewer/view/commands.h"

namespace barrido::window {
namespace {

constexpr int kLeftButton = 0, kRightButton = 1, kMiddleButton = 2;  // GLFW's numbers
constexpr double kDegreesPerHeight = 180.0;  ///< A drag over the whole height turns this far.
constexpr double kClickTravel = 4.0;         ///< Pixels that a click may move.
constexpr float kWheelFactor = 1.15f;
constexpr double kGrabRadius = 8.0;

}  // namespace

std::optional<std::pair<double, double>> pixel_of(const view::Look& look, const glm::vec3& world, int width,
                                                  int height) {
  const glm::dvec4 clip = glm::dmat4(look.view.clip_from_eye) * glm::dmat4(look.view.eye_from_world) *
                          glm::dvec4(glm::dvec3(world), 1.0);
  if (clip.w <= 0.0) return std::nullopt;
  return std::pair{(clip.x / clip.w * 0.5 + 0.5) * width, (0.5 - clip.y / clip.w * 0.5) * height};
}

std::vector<LightHandle> light_handles(view::Viewer& viewer) {
  std::vector<LightHandle> handles;
  if (!viewer.active().settings.overlays.light_markers) return handles;
  const std::optional<view::Look> look = viewer.look();
  if (!look) return handles;
  const std::vector<scene::UserLight> lights = view::shown_lights(viewer);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (lights[i].light.kind == scene::Light::Kind::directional) continue;
    if (lights[i].space == scene::UserLight::Space::camera) continue;
    const auto place = pixel_of(*look, lights[i].position, viewer.width(), viewer.height());
    if (place) handles.push_back({i, place->first, place->second});
  }
  return handles;
}

std::optional<std::size_t> Pointer::light_at_pointer() {
  for (const LightHandle& handle : light_handles(viewer_)) {
    if (std::hypot(handle.x - x_, handle.y - y_) < kGrabRadius * scale) return handle.light;
  }
  return std::nullopt;
}

void Pointer::press(int button, bool shift, bool control) {
  flush();
  if (action_ != Action::none) return;
  button_ = button;
  travelled_ = 0.0;
  if (button == kMiddleButton) action_ = Action::pan;
  if (button == kRightButton) action_ = Action::zoom;
  if (button != kLeftButton) return;
  const double divider = viewer_.display.divider * viewer_.width();
  action_ = shift ? Action::pan : control ? Action::roll : Action::orbit;
  if (viewer_.display.split && !viewer_.display.difference && std::abs(x_ - divider) < 6.0 * scale) {
    action_ = Action::divider;
  } else if (const auto light = light_at_pointer()) {
    action_ = Action::light;
    view::take_over_lights(viewer_);  // The file's become the user's.
    light_ = *light;
  }
}

void Pointer::release(int button) {
  flush();
  if (action_ == Action::none || button != button_) return;
  const bool was_click = travelled_ <= kClickTravel * scale && action_ == Action::orbit;
  action_ = Action::none;
  if (!was_click) return;
  click_ = std::pair{static_cast<int>(x_), static_cast<int>(y_)};
  if (viewer_.display.split && !viewer_.display.difference) {
    viewer_.set_active_side(x_ < viewer_.display.divider * viewer_.width() ? view::kLeft : view::kRight);
  }
}

void Pointer::move(double x, double y) {
  if (action_ != Action::none) {
    pending_x_ += x - x_;
    pending_y_ += y - y_;
    travelled_ += std::abs(x - x_) + std::abs(y - y_);
  }
  x_ = x;
  y_ = y;
}

void Pointer::wheel(double steps) {
  flush();
  viewer_.zoom(portable_pow(kWheelFactor, static_cast<float>(std::clamp(steps, -20.0, 20.0))));
}

void Pointer::flush() {
  if (pending_x_ == 0.0 && pending_y_ == 0.0) return;
  const double dx = pending_x_, dy = pending_y_;
  pending_x_ = pending_y_ = 0.0;
  apply(dx, dy);
}

void Pointer::apply(double dx, double dy) {
  const double height = viewer_.height();
  switch (action_) {
    case Action::none:
      return;
    case Action::orbit:
      viewer_.orbit(-dx * kDegreesPerHeight / height, dy * kDegreesPerHeight / height);
      return;
    case Action::pan:
      viewer_.pan(dx / height, -dy / height);
      return;
    case Action::zoom:
      viewer_.zoom(portable_exp2(static_cast<float>(std::clamp(-dy / height * 4.0, -8.0, 8.0))));
      return;
    case Action::roll:
      turn_by(dx, dy);
      return;
    case Action::divider:
      viewer_.display.divider = std::clamp(x_ / std::max(1, viewer_.width()), 0.0, 1.0);
      viewer_.changed = true;
      return;
    case Action::light:
      move_light(dx, dy);
      return;
  }
}

/// The angle that the pointer went about the picture's middle.
void Pointer::turn_by(double dx, double dy) {
  const double cx = viewer_.width() * 0.5, cy = viewer_.height() * 0.5;
  const double before = portable_atan2(cy - (y_ - dy), x_ - dx - cx),
               after = portable_atan2(cy - y_, x_ - cx);
  viewer_.roll(std::remainder(before - after, 2.0 * kPi) * (180.0 / kPi));
}

/// In the plane through the light that faces the eye.
void Pointer::move_light(double dx, double dy) {
  std::vector<scene::UserLight>& lights = viewer_.active().settings.lights;
  const std::optional<view::Look> look = viewer_.look();
  if (!look || light_ >= lights.size()) return;
  const glm::dmat4 clip_from_world =
      glm::dmat4(look->view.clip_from_eye) * glm::dmat4(look->view.eye_from_world);
  const glm::dvec4 clip = clip_from_world * glm::dvec4(glm::dvec3(lights[light_].position), 1.0);
  if (clip.w <= 0.0) return;
  const glm::dvec4 moved =
      clip + glm::dvec4(2.0 * dx / viewer_.width() * clip.w, -2.0 * dy / viewer_.height() * clip.w, 0.0, 0.0);
  const glm::dvec4 world = glm::inverse(clip_from_world) * moved;
  if (world.w == 0.0) return;
  lights[light_].position = glm::vec3(glm::dvec3(world) / world.w);
  lights[light_] = view::canonical(lights[light_]);
  viewer_.changed = true;
}

std::optional<std::pair<int, int>> Pointer::take_click() { return std::exchange(click_, std::nullopt); }

}  // namespace barrido::window
