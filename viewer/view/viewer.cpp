#include "viewer/view/viewer.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <tuple>

#include "pipeline/names.h"
#include "viewer/barrido/frame_plan.h"
#include "viewer/view/render_words.h"

namespace barrido::view {
namespace {

constexpr std::size_t kLongName = 40;

/// One picture's worth of options: what makes several frames, or writes them, has no place in a window.
cli::RenderOptions of_one_picture(cli::RenderOptions options) {
  options.shadings = {options.shadings.at(0)};
  options.views = {options.views.at(0)};
  options.files.clear();
  options.output.clear();
  options.settings_path.clear();
  if (options.all_cameras) options.cameras = {0};
  if (options.cameras.size() > 1) options.cameras = {options.cameras[0]};
  options.all_cameras = false;
  options.turntable = 0;
  options.frames.reset();
  return options;
}

glm::dvec3 upright_of(const cli::RenderOptions& options) {
  return scene::unit_or(glm::dvec3(options.settings.camera.up), {0, 1, 0});
}

}  // namespace

Viewer::Viewer(cli::RenderOptions options) : initial_(of_one_picture(std::move(options))) {
  sides_.fill(initial_);
  environment_given_ = initial_.environment_path;
}

void Viewer::set_environment(const std::string& path) {
  environment_given_ = active().environment_path = path;
  active().settings.dynamic_environment = false;
  changed = true;
}

void Viewer::open(std::vector<std::string> files) {
  files_ = std::move(files);
  file_ = 0;
  if (!files_.empty()) load(files_[0]);
}

const std::string& Viewer::path() const {
  static const std::string kNothing;
  return files_.empty() ? kNothing : files_[file_];
}

void Viewer::load(const std::string& path) {
  changed = true;
  try {
    auto model = std::make_unique<Model>(path, initial_.limits);
    model_ = std::move(model);
    message = model_->scene().warnings.empty() ? "" : model_->scene().warnings.front();
  } catch (const std::exception& error) {
    message = error.what();
  }
}

void Viewer::step_file(int step) {
  if (files_.size() < 2) return;
  const auto count = static_cast<int>(files_.size());
  file_ = static_cast<std::size_t>((static_cast<int>(file_) + step % count + count) % count);
  model_.reset();
  playing_ = false;
  for (cli::RenderOptions& options : sides_) {
    options.time_s = initial_.time_s;
    options.animation = initial_.animation;
  }
  reset_camera();
  load(path());
}

void Viewer::reload() {
  if (files_.empty()) return;
  load(path());
  const cli::RenderOptions& options = active();
  const bool lost = model_ && !options.cameras.empty() && options.cameras[0] >= model_->camera_count(options);
  if (lost) reset_camera();
}

void Viewer::set_osmesa(bool on) {
  if (on == display.osmesa) return;
  if (!on) return set_split(false);
  if (const std::string why = osmesa::why_missing(); !why.empty()) {
    message = "no picture by OSMesa: " + why;
    return;
  }
  set_split(true);
  sides_[kLeft] = active();
  active_side_ = kLeft;
  display.osmesa = true;
  scene::RenderSettings& settings = sides_[kLeft].settings;
  put_aside_ = std::pair{settings.color_management, settings.flat_at};
  settings.color_management = scene::ColorManagement::none;
  settings.flat_at = pipeline::FlatAt::provoking_vertex;
}

void Viewer::set_split(bool on) {
  if (display.osmesa && put_aside_) {
    std::tie(sides_[kLeft].settings.color_management, sides_[kLeft].settings.flat_at) = *put_aside_;
  }
  put_aside_.reset();
  display.osmesa = false;
  if (on && !display.split) sides_[active_side_ == kLeft ? kRight : kLeft] = active();
  // What was seen last stays.
  if (!on && display.split) sides_[kLeft] = active();
  if (!on) active_side_ = kLeft;
  display.split = on;
  if (!on) display.difference = false;
  changed = true;
}

std::vector<std::string> Viewer::words_of_side(int side) const {
  return words_of(sides_[static_cast<std::size_t>(side)]);
}

std::string Viewer::side_name(int side) const {
  if (display.osmesa) return side == kLeft ? "Barrido" : "OSMesa";
  const std::string letter = side == kLeft ? "A" : "B";
  const auto shading = [this](int of) { return sides_[static_cast<std::size_t>(of)].shadings.at(0); };
  if (shading(kLeft) != shading(kRight)) return letter + "  " + std::string(name_of(shading(side)));
  // Options with their values, in the same order on both sides.
  const std::vector<std::string> own = words_of_side(side), other = words_of_side(1 - side);
  std::string name = letter;
  for (std::size_t i = 0; i < own.size() && name.size() < kLongName; ++i) {
    const bool option = own[i].rfind("--", 0) == 0;
    const bool valued = option && i + 1 < own.size() && own[i + 1].rfind("--", 0) != 0;
    if (!option) continue;
    const auto same = std::search(other.begin(), other.end(), own.begin() + static_cast<std::ptrdiff_t>(i),
                                  own.begin() + static_cast<std::ptrdiff_t>(i + (valued ? 2 : 1)));
    if (same == other.end()) name += "  " + own[i].substr(2) + (valued ? " " + own[i + 1] : "");
  }
  return name;
}

std::string Viewer::command_line(int side) const {
  std::vector<std::string> words{"barrido", "render"};
  const std::vector<std::string> options = words_of_side(side);
  words.insert(words.end(), options.begin(), options.end());
  if (!files_.empty()) {
    words.insert(words.end(), {"-o", cli::model_name(path()) + ".png", "--", path()});
  }
  return shell_line(words);
}

void Viewer::load_settings(const std::string& path) {
  const std::vector<std::string> words{"--settings", path};
  cli::RenderOptions loaded = of_one_picture(cli::parse_view_options(words));
  loaded.settings.width = width();
  loaded.settings.height = height();
  active() = loaded;
  sides_[active_side_ == kLeft ? kRight : kLeft].settings.camera = loaded.settings.camera;
  changed = true;
}

std::optional<Look> Viewer::look() {
  if (!model_) return std::nullopt;
  try {
    return model_->look(active());
  } catch (const std::exception& error) {
    message = error.what();
    return std::nullopt;
  }
}

template <class Move>
void Viewer::move_camera(const Move& move) {
  std::optional<Look> now = look();
  if (!now) return;
  move(now->eye, now->bounds);
  look_through(now->eye);
}

std::vector<int> Viewer::file_camera() {
  const cli::RenderOptions& options = active();
  if (!options.cameras.empty()) return options.cameras;
  const bool first = !options.settings.camera.ignore_file_cameras && model_->camera_count(options) > 0;
  return first ? std::vector{0} : std::vector<int>{};
}

void Viewer::look_through(const scene::Eye& eye) {
  const std::vector<int> camera = file_camera();
  for (cli::RenderOptions& options : sides_) {
    options.cameras = camera;
    set_camera(options.settings.camera, eye, !camera.empty());
  }
  changed = true;
}

void Viewer::orbit(double right_deg, double up_deg) {
  move_camera([&](scene::Eye& eye, const scene::Sphere&) {
    view::orbit(eye, upright_of(active()), right_deg, up_deg);
  });
}

void Viewer::pan(double right, double up) {
  move_camera([&](scene::Eye& eye, const scene::Sphere&) { view::pan(eye, right, up); });
}

void Viewer::zoom(double factor) {
  move_camera([&](scene::Eye& eye, const scene::Sphere&) { view::zoom(eye, factor); });
}

void Viewer::roll(double degrees) {
  move_camera([&](scene::Eye& eye, const scene::Sphere&) { view::roll(eye, degrees); });
}

void Viewer::look_from(StandardView side) {
  move_camera([&](scene::Eye& eye, const scene::Sphere& bounds) {
    view::look_from(eye, side, bounds, upright_of(active()), static_cast<double>(width()) / height());
  });
}

void Viewer::toggle_orthographic() {
  move_camera([&](scene::Eye& eye, const scene::Sphere&) { view::toggle_orthographic(eye); });
}

void Viewer::reset_camera() {
  for (cli::RenderOptions& options : sides_) {
    options.settings.camera = initial_.settings.camera;
    options.cameras = initial_.cameras;
  }
  changed = true;
}

void Viewer::toggle_playing() {
  playing_ = !playing_ && model_ && !model_->scene().animations.empty();
  if (model_ && model_->scene().animations.empty()) message = "the file has no animation";
}

void Viewer::advance(double seconds) {
  if (!model_) return;
  const double duration_s = model_->duration_s(active().animation.value_or(0));
  if (duration_s <= 0.0) return;
  double time_s = active().time_s.value_or(0.0) + seconds;
  time_s -= std::floor(time_s / duration_s) * duration_s;
  for (cli::RenderOptions& options : sides_) options.time_s = std::clamp(time_s, 0.0, duration_s);
  changed = true;
}

}  // namespace barrido::view
