// The command line of barrido-view: options of its own and those of `barrido render`. Opens nothing.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "viewer/barrido/render_options.h"

namespace barrido::view {

struct ViewArguments {
  bool help = false;  ///< Nothing else is looked at.
  bool version = false;
  bool report = false;  ///< A line on standard output for every picture.
  bool panel = true;
  float scale = 0.0f;                               ///< Of letters and panel; 0: the screen's.
  std::string settings_path = "barrido-view.json";  ///< Where Ctrl+S saves to.
  std::vector<std::string> files;
  cli::RenderOptions options;
};

/// @throws UsageError, and scene::InputError for a settings file.
ViewArguments parse_view_arguments(const std::vector<std::string>& words);

/// The text of --help.
std::string view_help();

}  // namespace barrido::view
