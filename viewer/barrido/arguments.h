// Words of the command line sorted into files and options by the syntax of a command. Enters: the words after
// the command's name. Leaves: what was given, as text. Knows neither what an option means nor its values.
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace barrido::cli {

/// A command line that cannot be obeyed. what() is the whole message on one line, without the program's name:
/// "--resolution: '0,5': expected W,H, two whole numbers in 1..16384".
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// How often an option may come, and with what.
enum class OptionKind {
  flag,            ///< No value.
  value,           ///< One value, once.
  repeatable,      ///< One value each time.
  optional_value,  ///< `--name` or `--name=value`.
};

/// What an option is about.
enum class OptionScope {
  picture,  ///< How a picture looks: a setting, which the window and `inspect` take too.
  drawing,  ///< A setting that `inspect` does not take: what it tells is not of the pictures it makes.
  call,     ///< How the program runs: no setting, but `inspect` takes it.
  output,   ///< What becomes of frames, or asks for several: of `render` only.
};

/// Syntax and help of an option, without what it does.
struct OptionSyntax {
  std::string_view section;     ///< Heading of the help under which it stands.
  std::string_view name;        ///< "--resolution"
  std::string_view short_name;  ///< "-o", or empty.
  OptionKind kind = OptionKind::value;
  std::string_view form;  ///< Of the value, for the help: "W,H".
  std::string_view help;  ///< Sentences; broken into lines by the help.
  OptionScope scope = OptionScope::call;

  /// Whether it describes a picture and has its place in a settings file.
  bool is_setting() const { return scope == OptionScope::picture || scope == OptionScope::drawing; }
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
