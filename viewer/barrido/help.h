// What --help and --version print. Lines end before column 100; options come from their tables.
#pragma once

#include <span>
#include <string>

#include "viewer/barrido/arguments.h"

namespace barrido::cli {

std::string version_text();  ///< "barrido 0.1.0\n"
std::string general_help();
std::string render_help();
std::string inspect_help();
std::string lab_help();
std::string info_help();
std::string diff_help();

/// The syntax of `barrido info`: --json, --help.
std::span<const OptionSyntax> info_syntax();

/// Options under the headings of their sections, help texts broken into lines.
std::string options_help(std::span<const OptionSyntax> syntax);

}  // namespace barrido::cli
