// The options of `barrido render` in the order of the help: syntax, help text, and what each does.
#pragma once

#include <span>

#include "viewer/barrido/render_options.h"

namespace barrido::cli {

struct RenderOption {
  OptionSyntax syntax;
  /// Reads the value (empty for a flag). @throws ValueError.
  void (*apply)(RenderOptions& options, std::string_view value);
};

std::span<const RenderOption> render_option_table();

}  // namespace barrido::cli
