// What the mouse means in the picture: orbit, pan, zoom, roll, the divider, light markers, clicks. Enters:
// buttons and motion in pixels; leaves: moves of the viewer. Knows GLFW's buttons by number only.
#pragma once

#include <optional>

#include "viewer/view/viewer.h"

namespace barrido::window {

class Pointer {
 public:
  explicit Pointer(view::Viewer& viewer) : viewer_(viewer) {}

  /// A button went down in the picture at (x, y), pixels from its upper left corner.
  void press(int button, bool shift, bool control);
  /// A button went up anywhere.
  void release(int button);
  void move(double x, double y);
  void wheel(double steps);
  /// Applies motion that was only added up so far.
  void flush();

  /// Whether the picture changes with every motion.
  /// Whether there is a move that was not applied yet.
  bool moved() const { return pending_x_ != 0.0 || pending_y_ != 0.0; }
  bool dragging() const { return action_ != Action::none; }
  double x() const { return x_; }
  double y() const { return y_; }
  /// The pixel clicked last, from the upper left corner, once.
  std::optional<std::pair<int, int>> take_click();

  /// The light of the active side's options whose marker is at the pointer.
  std::optional<std::size_t> light_at_pointer();
  float scale = 1.0f;  ///< Of marks on the screen.

 private:
  enum class Action { none, orbit, pan, zoom, roll, divider, light };
  void apply(double dx, double dy);
  void move_light(double dx, double dy);
  void turn_by(double dx, double dy);

  view::Viewer& viewer_;
  Action action_ = Action::none;
  int button_ = 0;
  std::size_t light_ = 0;
  double x_ = 0.0, y_ = 0.0;
  double pending_x_ = 0.0, pending_y_ = 0.0;
  double travelled_ = 0.0;
  std::optional<std::pair<int, int>> click_;
};

/// Where a point of the world is in the picture, pixels from its upper left corner; nothing behind the eye.
std::optional<std::pair<double, double>> pixel_of(const view::Look& look, const glm::vec3& world, int width,
                                                  int height);

/// A marker that can be dragged: that of a light with a place in the world.
struct LightHandle {
  std::size_t light = 0;    ///< Of view::shown_lights
  double x = 0.0, y = 0.0;  ///< Pixels
};

/// None while markers are not shown.
std::vector<LightHandle> light_handles(view::Viewer& viewer);

}  // namespace barrido::window
