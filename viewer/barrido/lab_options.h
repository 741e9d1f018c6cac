// What `barrido lab` was told: an experiment on a frame, as `barrido render` would be told of it. Enters: the
// words after `lab`. Leaves: one plain struct. Loads no file.
#pragma once

#include <span>
#include <string>

#include "viewer/barrido/render_options.h"

namespace barrido::cli {

struct LabOptions {
  RenderOptions frame;  ///< Of one file, one shading mode, one camera.
  std::string plot;     ///< SVG file to write; empty: none.
};

/// The syntax of `barrido lab sampling`: --plot, and the options of `barrido render` that say how a frame
/// looks.
std::span<const OptionSyntax> lab_syntax();

/// `words`: after "lab". `frame.help`: nothing else is set. @throws UsageError.
LabOptions parse_lab_options(std::span<const std::string> words);

}  // namespace barrido::cli
