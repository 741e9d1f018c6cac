// The viewer without its window: what is open, how it is shown, and what keys and the mouse do to that.
// Enters: commands; leaves: pictures and command lines. Knows neither GLFW nor GL nor Dear ImGui.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/view/camera_moves.h"
#include "viewer/view/model.h"
#include "viewer/view/picture.h"

namespace barrido::view {

/// What a command asks of the window.
enum class Request { copy_command_line, write_picture, save_settings, load_settings, quit };

inline constexpr int kLeft = 0;
inline constexpr int kRight = 1;

/// What is shown around the picture, and how pictures are put together.
struct Display {
  bool panel = true;
  bool help = false;
  bool counters = false;
  bool inspector = false;
  bool split = false;  ///< The left side left of the divider, the right side right of it.
  /// The right side is OSMesa's picture of the left side's draws, which keys and panel change; only when
  /// split.
  bool osmesa = false;
  bool difference = false;  ///< A heat map of the sides' difference; only when split.
  double divider = 0.5;     ///< Part of the width, 0..1
};

/// A pixel of the picture and why it looks as it does.
struct Inspected {
  int x = 0, y = 0;  ///< From the upper left corner.
  int side = kLeft;
  std::array<std::uint8_t, 4> rgba{};
  std::string text;
};

class Viewer {
 public:
  /// The options describe both sides at the beginning; their files are opened by `open`.
  explicit Viewer(cli::RenderOptions options);

  // Files.
  /// Opens the first of these models; what stands in `message` tells how that went.
  void open(std::vector<std::string> files);
  /// Opens the file `step` places further on, round the list.
  void step_file(int step);
  /// Reads the file again; when that fails the old model stays.
  void reload();
  const std::vector<std::string>& files() const { return files_; }
  Model* model() { return model_.get(); }
  const std::string& path() const;

  // Settings.
  /// The options of the side that keys and panel change.
  cli::RenderOptions& active() { return sides_[static_cast<std::size_t>(active_side_)]; }
  cli::RenderOptions& side(int side) { return sides_[static_cast<std::size_t>(side)]; }
  int active_side() const { return active_side_; }
  /// Without effect beside OSMesa, whose side has no options of its own.
  void set_active_side(int side) { active_side_ = display.osmesa ? kLeft : side; }
  /// Splits the picture; the right side begins as a copy of the active one.
  void set_split(bool on);
  /// Barrido | OSMesa of the active side, with what OpenGL 1.x has not put aside until it is switched off:
  /// managed colours, polygons lit at their centroid. Where OSMesa is missing, `message` tells why.
  void set_osmesa(bool on);
  /// The words of `barrido render` that draw the active side.
  std::vector<std::string> words() const { return words_of_side(active_side_); }
  std::vector<std::string> words_of_side(int side) const;
  /// What the side is called beside the divider: "A  phong", or in what else it is not as the other.
  std::string side_name(int side) const;
  /// "barrido render teapot.glb --resolution 640,480 -o teapot.png"
  std::string command_line(int side) const;
  /// The environment's picture that was given last; empty: none.
  const std::string& environment_given() const { return environment_given_; }
  /// Reflects the picture on the active side.
  void set_environment(const std::string& path);
  /// Replaces the active side's options, but not the size. @throws UsageError, scene::InputError.
  void load_settings(const std::string& path);

  // Camera; both sides look from the same place.
  void orbit(double right_deg, double up_deg);
  void pan(double right, double up);  ///< Parts of the picture's height.
  void zoom(double factor);
  void roll(double degrees);
  void look_from(StandardView side);
  void toggle_orthographic();
  /// Looks through this eye. A file camera that was looked through still gives its near and far plane.
  void look_through(const scene::Eye& eye);
  void reset_camera();
  std::optional<Look> look();

  // Animation.
  bool playing() const { return playing_; }
  void toggle_playing();
  /// Moves the moment on, round the animation's end.
  void advance(double seconds);

  // Pictures.
  /// Size of the finest picture, legend included; 1..16384 each way.
  void set_size(int width, int height);
  /// Of the legend below a view; 0 where no side shows one.
  int legend_height() const;
  /// Without the legend.
  int width() const { return sides_[0].settings.width; }
  int height() const { return sides_[0].settings.height; }
  /// Draws what is to be shown, in 1/`coarseness` of the size. Failures are told in `message` and give a
  /// picture of the background's colour.
  const Picture& draw(int coarseness = 1);
  const Picture& picture() const { return picture_; }
  /// Tells the story of a pixel of the side that is seen there; outside the picture there is none.
  void inspect(int x, int y);
  const std::optional<Inspected>& inspected() const { return inspected_; }

  /// What the last picture cost, both sides together.
  const Costs& costs() const { return costs_; }
  const std::optional<Difference>& difference() const { return difference_; }
  /// What the picture asks of OSMesa in vain.
  const std::vector<std::string>& osmesa_cannot() const { return osmesa_cannot_; }

  /// Whether something changed since the last picture.
  bool changed = true;
  Display display;
  std::vector<Request> requests;
  std::string message;  ///< The last thing that must be told; empty: nothing.

 private:
  template <class Move>
  void move_camera(const Move& move);
  /// The file's camera that is looked through, moved or not; none where there is none.
  std::vector<int> file_camera();
  void load(const std::string& path);
  Picture draw_side(int side, int coarseness);
  Picture draw_osmesa(int coarseness);
  /// A line for the inspector; empty where there is no picture by OSMesa.
  std::string osmesa_story(int x, int y) const;
  cli::RenderOptions coarse(int side, int coarseness) const;
  /// Beside a view with its legend, a picture without one stands on nothing.
  void stand_on_nothing(Picture& picture) const;
  Picture blank(int coarseness) const;

  bool has_view(int side) const { return sides_[static_cast<std::size_t>(side)].views.at(0).has_value(); }

  std::array<cli::RenderOptions, 2> sides_;
  cli::RenderOptions initial_;
  std::string environment_given_;
  int active_side_ = kLeft;
  std::vector<std::string> files_;
  std::size_t file_ = 0;
  std::unique_ptr<Model> model_;
  bool playing_ = false;
  Picture picture_;
  Costs costs_;
  std::optional<Difference> difference_;
  osmesa::FrameDrawer osmesa_;
  std::vector<std::string> osmesa_cannot_;
  Picture osmesa_picture_;  ///< Of full size, or none.
  /// What set_osmesa put aside.
  std::optional<std::pair<scene::ColorManagement, pipeline::FlatAt>> put_aside_;
  std::optional<Inspected> inspected_;
};

}  // namespace barrido::view
