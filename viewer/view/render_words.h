// The command line that gives a picture again: options in, words of `barrido render` out. Parsing the words
// gives the same options, bit for bit. Knows no window.
#pragma once

#include <string>
#include <vector>

#include "viewer/barrido/render_options.h"

namespace barrido::view {

/// Options that describe the picture, where they differ from the defaults, in the order of the help; the size
/// always. No file names, nothing about output and execution.
std::vector<std::string> words_of(const cli::RenderOptions& options);

/// One line for a POSIX shell: words with other than harmless letters are quoted.
std::string shell_line(const std::vector<std::string>& words);

}  // namespace barrido::view
