// What `barrido inspect` was told: which pixel, and the frame as `barrido render` would be told. Enters: the
// words of the command line. Leaves: one plain struct. Loads no file.
#pragma once

#include <span>
#include <string>

#include "viewer/barrido/render_options.h"

namespace barrido::cli {

struct InspectOptions {
  RenderOptions frame;  ///< Of one file, one shading mode, one camera.
  int x = 0, y = 0;     ///< From the upper left.
  bool json = false;
};

/// The syntax of `barrido inspect`: --pixel, --json, and the options of `barrido render` that say how a frame
/// looks.
std::span<const OptionSyntax> inspect_syntax();

/// `frame.help`: nothing else is set. @throws UsageError.
InspectOptions parse_inspect_options(std::span<const std::string> words);

}  // namespace barrido::cli
