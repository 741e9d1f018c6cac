#include "viewer/barrido/lab_options.h"

#include "viewer/barrido/render_option_table.h"
#include "viewer/barrido/spelling.h"

namespace barrido::cli {
namespace {

constexpr std::size_t kPlot = 0;
constexpr std::string_view kResolution = "--resolution";

/// Read here, as it is no option of a frame.
void leave_for_later(const RenderOption&, RenderOptions&, std::string_view) {}

const std::vector<RenderOption>& lab_table() {
  static const std::vector<RenderOption> table = [] {
    RenderOption plot{{"Lab", "--plot", "-o", OptionKind::value, "OUT.svg",
                       "Draw the errors over the number of samples, both as logarithms, into this file."},
                      {},
                      {}};
    plot.value.read = leave_for_later;
    std::vector<RenderOption> options{plot};
    for (const RenderOption& option : render_option_table()) {
      const OptionScope scope = option.syntax.scope;
      if (scope != OptionScope::picture && scope != OptionScope::call) continue;
      options.push_back(option);
      if (option.syntax.section == "Output") options.back().syntax.section = "Frame";
    }
    return options;
  }();
  return table;
}

bool was_given(const Arguments& arguments, std::string_view name) {
  for (const GivenOption& given : arguments.options) {
    if (lab_table()[given.index].syntax.name == name) return true;
  }
  return false;
}

}  // namespace

std::span<const OptionSyntax> lab_syntax() {
  static const std::vector<OptionSyntax> syntax = [] {
    std::vector<OptionSyntax> list;
    for (const RenderOption& option : lab_table()) list.push_back(option.syntax);
    return list;
  }();
  return syntax;
}

LabOptions parse_lab_options(std::span<const std::string> words) {
  LabOptions options;
  constexpr std::string_view kExperiments[] = {"sampling", "--help"};
  if (words.empty()) throw UsageError("lab: no experiment given; see barrido lab --help");
  options.frame.help = words[0] == "--help" || words[0] == "-h";
  if (options.frame.help) return options;
  if (words[0] != "sampling") {
    throw UsageError("lab: unknown experiment '" + words[0] + "'" + did_you_mean(words[0], kExperiments) +
                     " (see barrido lab --help)");
  }
  const Arguments arguments = parse_arguments(lab_syntax(), words.subspan(1));
  options.frame = read_frame_options(arguments, lab_table(), "lab");
  if (options.frame.help) return options;
  if (options.frame.files.size() > 1) throw UsageError("lab: one FILE at a time");
  if (options.frame.shadings.size() > 1) throw UsageError("--shading: lab takes one mode");
  if (options.frame.all_cameras || options.frame.cameras.size() > 1) {
    throw UsageError("--camera-index: lab takes one camera");
  }
  if (!was_given(arguments, kResolution)) {
    // A thousand samples of every pixel take a while.
    options.frame.settings.width = 320;
    options.frame.settings.height = 180;
  }
  for (const GivenOption& given : arguments.options) {
    if (given.index == kPlot) options.plot = given.value;
  }
  if (!options.plot.empty() && !options.plot.ends_with(".svg")) {
    throw UsageError("--plot: '" + options.plot + "': expected a name that ends in .svg");
  }
  return options;
}

}  // namespace barrido::cli
