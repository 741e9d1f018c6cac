// The program: events to the viewer, the viewer's pictures to the window, only when something changed.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/barrido-view/frame_quad.h"
#include "viewer/barrido-view/pointer.h"
#include "viewer/barrido-view/window.h"
#include "viewer/view/arguments.h"
#include "viewer/view/file_watch.h"
#include "viewer/view/viewer.h"

namespace barrido::window {

class App : private Events {
 public:
  /// @throws std::runtime_error when no window can be opened.
  explicit App(const view::ViewArguments& arguments);
  /// Until the window is closed. @return the exit status.
  int run();

 private:
  void on_key(int glfw_key, int glfw_modifiers) override;
  void on_button(int glfw_button, bool pressed, int glfw_modifiers) override;
  void on_motion(double x, double y) override;
  void on_wheel(double steps) override;
  void on_drop(const std::vector<std::string>& paths) override;
  void on_anything() override;

  void step();
  void poll();
  void fit_picture();
  void draw_picture();
  void show();
  void answer_requests();
  void answer(view::Request request);
  void watch_file();
  void write_picture();
  void say(const std::string& line) const;
  void inspect();
  bool is_over_picture(double x, double y) const;
  float panel_pixels() const;
  void set_title();

  view::ViewArguments arguments_;
  view::Viewer viewer_;
  Window window_;
  FrameQuad quad_;
  Pointer pointer_;
  std::unique_ptr<view::FileWatch> watch_;
  std::string watched_;
  std::atomic<bool> file_changed_ = false;
  std::string status_;  ///< What was done last, for the panel.
  std::string title_;
  double playing_since_ = 0.0;
  double full_ms_ = 0.0;  ///< What a picture of full size takes, at most.
  int coarseness_ = 1;    ///< Of the picture on the screen.
  bool resting_ = false;  ///< A drag has come to rest: there is time for a picture of full size.
  int frames_ = 0;        ///< Pictures drawn.
  int shows_ = 3;         ///< How often the window must still be shown: ImGui needs some to settle.
  std::string report_;    ///< Told when the picture is on the screen.
  std::optional<std::pair<int, int>> held_;       ///< The pixel that was clicked.
  std::optional<std::pair<int, int>> inspected_;  ///< The one whose story is told.
  bool quit_ = false;
};

}  // namespace barrido::window
