#include "viewer/barrido/inspect_options.h"

#include "viewer/barrido/render_option_table.h"
#include "viewer/barrido/values.h"

namespace barrido::cli {
namespace {

constexpr std::size_t kPixel = 0, kJson = 1;

/// Read after all others, as the pixel lies in their frame.
void leave_for_later(const RenderOption&, RenderOptions&, std::string_view) {}

RenderOption own_option(const OptionSyntax& syntax) {
  RenderOption option{syntax, {}, {}};
  option.value.read = leave_for_later;
  return option;
}

const std::vector<RenderOption>& inspect_table() {
  static const std::vector<RenderOption> table = [] {
    std::vector<RenderOption> options{
        own_option({"Pixel", "--pixel", "-p", OptionKind::value, "X,Y",
                    "The pixel, counted from the upper left one, which is 0,0, as in picture files."}),
        own_option({"Pixel", "--json", "", OptionKind::flag, "",
                    "As JSON, for programs; docs/inspect.md describes it."})};
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

void set_pixel(InspectOptions& options, std::string_view text) {
  const std::vector<std::string_view> parts = split(text, ',');
  try {
    if (parts.size() != 2) throw ValueError("");
    options.x = parse_whole(parts[0], 0, 16383);
    options.y = parse_whole(parts[1], 0, 16383);
  } catch (const ValueError&) {
    throw UsageError("--pixel: '" + std::string(text) + "': expected X,Y, two whole numbers from 0");
  }
  const scene::RenderSettings& frame = options.frame.settings;
  if (options.x < frame.width && options.y < frame.height) return;
  throw UsageError("--pixel: '" + std::string(text) + "': the frame has " + std::to_string(frame.width) +
                   " x " + std::to_string(frame.height) + " pixels, 0,0 to " +
                   std::to_string(frame.width - 1) + "," + std::to_string(frame.height - 1) +
                   " (see --resolution)");
}

}  // namespace

std::span<const OptionSyntax> inspect_syntax() {
  static const std::vector<OptionSyntax> syntax = [] {
    std::vector<OptionSyntax> list;
    for (const RenderOption& option : inspect_table()) list.push_back(option.syntax);
    return list;
  }();
  return syntax;
}

InspectOptions parse_inspect_options(std::span<const std::string> words) {
  const Arguments arguments = parse_arguments(inspect_syntax(), words);
  InspectOptions options;
  options.frame = read_frame_options(arguments, inspect_table(), "inspect");
  if (options.frame.help) return options;
  if (options.frame.files.size() > 1) throw UsageError("inspect: one FILE at a time");
  if (options.frame.shadings.size() > 1) throw UsageError("--shading: inspect takes one mode");
  if (options.frame.all_cameras || options.frame.cameras.size() > 1) {
    throw UsageError("--camera-index: inspect takes one camera");
  }
  options.json = arguments.has(kJson);
  for (const GivenOption& given : arguments.options) {
    if (given.index != kPixel) continue;
    set_pixel(options, given.value);
    return options;
  }
  throw UsageError("inspect: no pixel given; say --pixel X,Y");
}

}  // namespace barrido::cli
