#include "viewer/barrido-view/app.h"

#include <GL/gl.h>
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "pipeline/names.h"
#include "viewer/barrido-view/panel.h"
#include "viewer/barrido-view/picture_marks.h"
#include "viewer/barrido/commands.h"
#include "viewer/barrido/frame_plan.h"
#include "viewer/barrido/text_format.h"
#include "viewer/view/key_table.h"

namespace barrido::window {
namespace {

using view::Key;

/// A drag that would take longer than this a picture gets coarser pictures.
constexpr double kSmoothMs = 45.0;
constexpr int kCoarsest = 4;
constexpr double kRestSeconds = 0.15;
constexpr int kShowsToSettle = 3;
/// Below this the picture has the window for itself.
constexpr float kLeastPictureUnits = 160.0f;

Key key_of_glfw(int key) {
  constexpr std::array<std::pair<int, Key>, 10> kKeys{{{GLFW_KEY_ESCAPE, Key::escape},
                                                       {GLFW_KEY_ENTER, Key::enter},
                                                       {GLFW_KEY_KP_ENTER, Key::enter},
                                                       {GLFW_KEY_TAB, Key::tab},
                                                       {GLFW_KEY_SPACE, Key::space},
                                                       {GLFW_KEY_UP, Key::up},
                                                       {GLFW_KEY_LEFT, Key::left},
                                                       {GLFW_KEY_RIGHT, Key::right},
                                                       {GLFW_KEY_F12, Key::f12},
                                                       {GLFW_KEY_UNKNOWN, Key::none}}};
  for (const auto& [glfw, own] : kKeys) {
    if (glfw == key) return own;
  }
  if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9)
    return view::key_of(static_cast<char>('0' + key - GLFW_KEY_KP_0));
  return key < 128 ? view::key_of(static_cast<char>(key)) : Key::none;
}

unsigned modifiers_of_glfw(int modifiers) {
  return ((modifiers & GLFW_MOD_SHIFT) != 0 ? view::kShift : 0u) |
         ((modifiers & GLFW_MOD_CONTROL) != 0 ? view::kControl : 0u);
}

bool is_model(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& letter : extension)
    letter = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter + 32) : letter;
  return extension == ".gltf" || extension == ".glb";
}

}  // namespace

App::App(const view::ViewArguments& arguments)
    : arguments_(arguments),
      viewer_(arguments.options),
      window_({arguments.options.settings.width, arguments.options.settings.height},
              arguments.panel ? kPanelUnits : 0.0f, arguments.scale, *this),
      pointer_(viewer_) {
  viewer_.display.panel = arguments.panel;
  pointer_.scale = window_.scale() * window_.pixels_per_unit();
  viewer_.open(arguments.files);
}

int App::run() {
  while (!quit_ && !window_.should_close()) step();
  return cli::kExitFine;
}

/// Waits where nothing is to be done.
void App::poll() {
  const bool busy = viewer_.changed || shows_ > 0 || viewer_.playing();
  resting_ = false;
  if (busy || (coarseness_ > 1 && !pointer_.dragging())) {
    window_.poll(false);
  } else if (coarseness_ > 1) {
    window_.poll_for(kRestSeconds);
    resting_ = !pointer_.moved();
  } else {
    window_.poll(true);
  }
  pointer_.flush();
}

void App::step() {
  poll();
  if (file_changed_.exchange(false)) viewer_.reload();
  watch_file();
  const double now = window_.seconds();
  if (viewer_.playing()) viewer_.advance(std::min(now - playing_since_, 0.25));
  playing_since_ = now;
  fit_picture();
  if (viewer_.changed || (coarseness_ > 1 && (!pointer_.dragging() || resting_))) draw_picture();
  inspect();
  if (shows_ > 0) show();
  answer_requests();
}

float App::panel_pixels() const {
  const float panel = kPanelUnits * window_.scale() * window_.pixels_per_unit();
  const float least = kLeastPictureUnits * window_.pixels_per_unit();
  const bool fits = static_cast<float>(window_.size().width) >= panel + least;
  return viewer_.display.panel && fits ? panel : 0.0f;
}

void App::fit_picture() {
  const WindowSize size = window_.size();
  if (size.width <= 0 || size.height <= 0) return;  // Minimised.
  viewer_.set_size(size.width - static_cast<int>(panel_pixels()), size.height);
}

void App::draw_picture() {
  const bool moving = (pointer_.dragging() && !resting_) || viewer_.playing();
  const bool hurry = moving && full_ms_ > kSmoothMs;
  const int wanted = static_cast<int>(std::ceil(std::sqrt(full_ms_ / kSmoothMs)));
  coarseness_ = hurry ? std::clamp(wanted, 2, kCoarsest) : 1;
  const view::Picture& picture = viewer_.draw(coarseness_);
  inspected_.reset();  // The picture is another now.
  // The first picture also builds textures; a coarse one tells that a full one would take less.
  const double drawn_ms = viewer_.costs().draw_ms + viewer_.costs().osmesa_ms;
  full_ms_ = coarseness_ == 1 ? drawn_ms : std::min(full_ms_, drawn_ms * coarseness_ * coarseness_);
  quad_.set_picture(picture);
  ++frames_;
  shows_ = kShowsToSettle;
  report_ = "frame " + std::to_string(frames_) + " drawn " + std::to_string(picture.width) + "x" +
            std::to_string(picture.height) + (coarseness_ > 1 ? " coarse" : "") + " in " +
            cli::fixed(viewer_.costs().draw_ms, 1) + " ms";
  set_title();
}

/// Where the pointer rests, or the pixel held by a click; a click on the story's pixel lets it go.
void App::inspect() {
  const auto click = pointer_.take_click();
  if (!viewer_.display.inspector) {
    held_.reset();
    inspected_.reset();
    return;
  }
  if (click) held_ = held_ ? std::nullopt : click;
  const std::pair place =
      held_.value_or(std::pair{static_cast<int>(pointer_.x()), static_cast<int>(pointer_.y())});
  const bool in_sight = held_ || is_over_picture(pointer_.x(), pointer_.y());
  if (inspected_ == place || !in_sight || pointer_.dragging() || coarseness_ > 1) return;
  inspected_ = place;
  viewer_.inspect(place.first, place.second);
  if (arguments_.report && viewer_.inspected()) {
    const view::Inspected& pixel = *viewer_.inspected();
    say("pixel " + std::to_string(pixel.x) + "," + std::to_string(pixel.y) +
        (pixel.side == view::kLeft ? " left " : " right ") + std::to_string(pixel.rgba[0]) + " " +
        std::to_string(pixel.rgba[1]) + " " + std::to_string(pixel.rgba[2]));
  }
  on_anything();
}

void App::show() {
  --shows_;
  const WindowSize size = window_.size();
  glViewport(0, 0, size.width, size.height);
  glClearColor(0.1f, 0.1f, 0.1f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  const int height = viewer_.height() + viewer_.legend_height();
  quad_.draw(0, size.height - height, viewer_.width(), height);
  window_.begin_panel();
  if (panel_pixels() > 0.0f) draw_panel(viewer_, status_, window_.scale());
  draw_marks(viewer_, pointer_, window_.scale(), window_.pixels_per_unit());
  window_.end_panel();
  window_.show();
  if (!report_.empty()) {
    glFinish();
    if (arguments_.report) say(report_);
    report_.clear();
  }
}

void App::on_anything() { shows_ = std::max(shows_, kShowsToSettle); }

void App::on_key(int glfw_key, int glfw_modifiers) {
  pointer_.flush();
  if (ImGui::GetCurrentContext() != nullptr && ImGui::GetIO().WantTextInput) return;
  if (!viewer_.message.empty()) viewer_.message.clear();
  view::press(viewer_, key_of_glfw(glfw_key), modifiers_of_glfw(glfw_modifiers));
  answer_requests();
}

bool App::is_over_picture(double x, double y) const {
  if (x < 0 || y < 0 || x >= viewer_.width() || y >= viewer_.height()) return false;
  return !is_over_marks(x, y) && !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
}

void App::on_button(int glfw_button, bool pressed, int glfw_modifiers) {
  if (!pressed) {
    pointer_.release(glfw_button);
    return;
  }
  if (!is_over_picture(pointer_.x(), pointer_.y())) return;
  viewer_.message.clear();
  pointer_.press(glfw_button, (glfw_modifiers & GLFW_MOD_SHIFT) != 0,
                 (glfw_modifiers & GLFW_MOD_CONTROL) != 0);
}

void App::on_motion(double x, double y) { pointer_.move(x, y); }

void App::on_wheel(double steps) {
  if (is_over_picture(pointer_.x(), pointer_.y())) pointer_.wheel(steps);
}

void App::on_drop(const std::vector<std::string>& paths) {
  std::vector<std::string> models;
  for (const std::string& path : paths) {
    if (is_model(path)) {
      models.push_back(path);
    } else {
      viewer_.set_environment(path);
    }
  }
  if (models.empty()) return;
  viewer_.open(models);
  viewer_.reset_camera();
}

void App::watch_file() {
  if (viewer_.path() == watched_) return;
  watched_ = viewer_.path();
  watch_.reset();
  if (watched_.empty()) return;
  watch_ = std::make_unique<view::FileWatch>(watched_, [this] {
    file_changed_ = true;
    Window::wake();
  });
}

void App::set_title() {
  const std::string name =
      viewer_.path().empty() ? "" : std::filesystem::path(viewer_.path()).filename().string();
  std::string title = (name.empty() ? "" : name + " - ") + std::string(name_of(viewer_.active().shadings[0]));
  if (viewer_.display.split) {
    title =
        (name.empty() ? "" : name + " - ") + std::string(name_of(viewer_.side(view::kLeft).shadings[0])) +
        " | " +
        (viewer_.display.osmesa ? "OSMesa" : std::string(name_of(viewer_.side(view::kRight).shadings[0])));
  }
  title += " - barrido-view";
  if (title == title_) return;
  title_ = title;
  window_.set_title(title);
}

}  // namespace barrido::window
