// Words of the command line sorted into files and options by the syntax of a command. Enters: the words after
// the command's name. Leaves: what was given, as text. Knows neither what an option means nor its values.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/barrido/usage_error.h"

namespace barrido::cli {

/// How often an option may come, and with what.
enum class OptionKind {
  flag,            ///< No value.
  value,           ///< One value, once.
  repeatable,      ///< One value each time.
  optional_value,  ///< `--name` or `--name=value`.
};

/// Syntax and help of an option, without what it does.
struct OptionSyntax {
  std::string_view section;     ///< Heading of the help under which it stands.
  std::string_view name;        ///< "--resolution"
  std::string_view short_name;  ///< "-o", or empty.
  OptionKind kind = OptionKind::value;
  std::string_view form;  ///< Of the value, for the help: "W,H".
  std::string_view help;  ///< Sentences; broken into lines by the help.
};

struct GivenOption {
  std::size_t index = 0;  ///< In the syntax.
  std::string value;      ///< Empty for a flag, and for an optional value that was left out.
  std::string source{};   ///< The settings file it stands in; empty: the command line.
};

struct Arguments {
  std::vector<std::string> files;
  std::vector<GivenOption> options;  ///< In the order of the syntax; repeated ones in the order given.

  /// Whether the option with this index was given.
  bool has(std::size_t index) const;
};

/// Sorts the words. "--" ends the options; "-" is a file or a value.
/// @throws UsageError for unknown options (naming the one that is near), missing values and repetitions.
Arguments parse_arguments(std::span<const OptionSyntax> syntax, std::span<const std::string> words);

}  // namespace barrido::cli
