// A GLFW window with an OpenGL context and Dear ImGui in it. Enters: a size; leaves: the window's events, as
// calls of an object. Knows nothing of pictures and models.
#pragma once

#include <functional>
#include <string>
#include <vector>

struct GLFWwindow;

namespace barrido::window {

/// What happens to the window; places are pixels from its upper left corner.
class Events {
 public:
  virtual ~Events() = default;
  virtual void on_key(int glfw_key, int glfw_modifiers) = 0;
  virtual void on_button(int glfw_button, bool pressed, int glfw_modifiers) = 0;
  virtual void on_motion(double x, double y) = 0;
  virtual void on_wheel(double steps) = 0;
  virtual void on_drop(const std::vector<std::string>& paths) = 0;
  virtual void on_anything() = 0;  ///< Also after each of the others.
};

struct WindowSize {
  int width = 0;  ///< Pixels
  int height = 0;
};

class Window {
 public:
  /// Has room for a picture of this size and a panel beside it, where the screen has.
  /// @param panel_units the panel's width for letters of scale 1.
  /// @param scale of letters; 0: the screen's.
  /// @throws std::runtime_error when there is no display or no OpenGL.
  Window(WindowSize picture, float panel_units, float scale, Events& events);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  WindowSize size() const;
  float scale() const { return scale_; }
  /// Pixels a unit of ImGui's coordinates.
  float pixels_per_unit() const;
  bool should_close() const;
  void set_title(const std::string& title);
  void set_clipboard(const std::string& text);
  double seconds() const;

  /// Handles what has happened; when `wait`, something must happen first.
  void poll(bool wait);
  /// Handles what happens within this time, and returns as soon as something did.
  void poll_for(double seconds);
  /// Ends a poll that waits; from any thread.
  static void wake();

  void begin_panel();  ///< A new ImGui frame.
  void end_panel();    ///< Draws what ImGui has to draw.
  void show();

 private:
  GLFWwindow* window_ = nullptr;
  float scale_ = 1.0f;
};

}  // namespace barrido::window
