#include "viewer/view/arguments.h"

#include <algorithm>

#include "viewer/barrido/render_option_table.h"
#include "viewer/barrido/values.h"
#include "viewer/view/key_table.h"

namespace barrido::view {
namespace {

constexpr const char* kUsage = R"(Usage: barrido-view [FILE...] [OPTIONS]

Shows glTF models (.gltf, .glb), drawn by Barrido, in a window in which every technique is a key or a
switch of the panel.

Options:
      --no-panel      Begin without the panel.
      --scale S       Size of letters and panel, 0.5..4. Default: as the screen says.
      --report        Tell of every picture on standard output, for scripts.
      --settings FILE Begin with these settings; Ctrl+S saves to this file (default barrido-view.json).
  -h, --help          This text.
  -V, --version
All options of barrido render that describe one picture can be given too: see barrido render --help.
--resolution is the size of the picture without the panel.
)";

constexpr const char* kNotes = R"(
Exit status: 0 fine, 2 error, as when there is no display.
)";

bool take_flag(std::vector<std::string>& words, std::string_view name) {
  const auto end = std::find(words.begin(), words.end(), "--");
  const auto found = std::find(words.begin(), end, name);
  if (found == end) return false;
  words.erase(found);
  return true;
}

float take_scale(std::vector<std::string>& words) {
  const auto end = std::find(words.begin(), words.end(), "--");
  const auto found = std::find(words.begin(), end, "--scale");
  if (found == end) return 0.0f;
  if (found + 1 == end) throw cli::UsageError("--scale: needs a value");
  const std::string value = *(found + 1);
  words.erase(found, found + 2);
  try {
    return static_cast<float>(cli::parse_number(value, 0.5, 4.0));
  } catch (const cli::ValueError& error) {
    throw cli::UsageError("--scale: '" + value + "': " + error.what());
  }
}

/// Options that a window has no use for.
void refuse_useless(const cli::RenderOptions& options) {
  for (const cli::RenderOption& row : cli::render_option_table()) {
    if (row.syntax.scope != cli::OptionScope::output || !row.is_given(options)) continue;
    throw cli::UsageError(std::string(row.syntax.name) + ": only for barrido render");
  }
}

}  // namespace

ViewArguments parse_view_arguments(const std::vector<std::string>& given) {
  std::vector<std::string> words = given;
  ViewArguments arguments;
  arguments.help = take_flag(words, "--help") || take_flag(words, "-h");
  arguments.version = take_flag(words, "--version") || take_flag(words, "-V");
  if (arguments.help || arguments.version) return arguments;
  arguments.report = take_flag(words, "--report");
  arguments.panel = !take_flag(words, "--no-panel");
  arguments.scale = take_scale(words);
  arguments.options = cli::parse_view_options(words);
  refuse_useless(arguments.options);
  arguments.files = arguments.options.files;
  if (!arguments.options.settings_path.empty()) arguments.settings_path = arguments.options.settings_path;
  return arguments;
}

std::string view_help() { return kUsage + keys_help() + kNotes; }

}  // namespace barrido::view
