// Settings of a picture as a JSON file: one object whose names are the options of `barrido render` without
// their dashes. Enters: a file, or the words of a command line; leaves: given options, or a file. Knows no
// option's meaning. docs/settings.md describes the format.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "pipeline/files/error.h"
#include "viewer/barrido/arguments.h"

namespace barrido::cli {

/// "camera-position" for "--camera-position".
std::string settings_name(const OptionSyntax& option);

/// The options in the file, as if they had been given on the command line.
/// @throws scene::InputError naming the file and the place.
std::vector<GivenOption> read_settings(const std::string& path, std::span<const OptionSyntax> syntax);

/// The text of a settings file with these options (file names and options that are no settings are left out).
std::string settings_json(std::span<const OptionSyntax> syntax, std::span<const std::string> words);

/// Writes settings_json to a temporary name beside `path`, then renames it. @throws scene::InputError.
void write_settings(const std::string& path, std::span<const OptionSyntax> syntax,
                    std::span<const std::string> words);

}  // namespace barrido::cli
