// What commands ask of the window: the clipboard, files, the end.
#include <exception>
#include <filesystem>
#include <utility>

#include "pipeline/pictures/image_io.h"
#include "viewer/barrido-view/app.h"
#include "viewer/barrido/frame_plan.h"
#include "viewer/barrido/settings_file.h"
#include "viewer/barrido/standard_streams.h"

namespace barrido::window {

void App::answer_requests() {
  const std::vector<view::Request> requests = std::exchange(viewer_.requests, {});
  for (const view::Request request : requests) {
    try {
      answer(request);
    } catch (const std::exception& error) {
      viewer_.message = error.what();
    }
    on_anything();
  }
}

void App::answer(view::Request request) {
  switch (request) {
    case view::Request::copy_command_line: {
      const std::string line = viewer_.command_line(viewer_.active_side());
      window_.set_clipboard(line);
      say(line);
      status_ = "copied the command line";
      return;
    }
    case view::Request::write_picture:
      write_picture();
      return;
    case view::Request::save_settings:
      cli::write_settings(arguments_.settings_path, cli::render_syntax(), viewer_.words());
      status_ = "saved " + arguments_.settings_path;
      if (arguments_.report) say(status_);
      return;
    case view::Request::load_settings:
      viewer_.load_settings(arguments_.settings_path);
      status_ = "loaded " + arguments_.settings_path;
      return;
    case view::Request::quit:
      quit_ = true;
      return;
  }
}

/// Under the first free name: teapot-1.png, teapot-2.png …
void App::write_picture() {
  if (viewer_.changed || coarseness_ > 1) draw_picture();
  const std::string name = viewer_.path().empty() ? "barrido" : cli::model_name(viewer_.path());
  std::string path;
  for (int number = 1; path.empty() || std::filesystem::exists(path); ++number) {
    path = name + "-" + std::to_string(number) + ".png";
  }
  const view::Picture& picture = viewer_.picture();
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(picture.rgba.data()), picture.rgba.size() * 4);
  scene::write_image(path, {picture.width, picture.height, bytes, {}});
  status_ = "wrote " + path;
  say(status_);
}

void App::say(const std::string& line) const { cli::write_standard_output(cli::bytes_of(line + "\n")); }

}  // namespace barrido::window
