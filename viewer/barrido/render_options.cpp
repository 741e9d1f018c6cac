#include "viewer/barrido/render_options.h"

#include <algorithm>

#include "pipeline/gltf/report.h"
#include "viewer/barrido/output_template.h"
#include "viewer/barrido/render_option_table.h"
#include "viewer/barrido/settings_file.h"

namespace barrido::cli {
namespace {

/// Which options were given, for rules that a default value cannot tell.
class Given {
 public:
  Given(const Arguments& arguments, std::span<const RenderOption> table)
      : arguments_(arguments), table_(table) {}

  bool operator()(std::string_view name) const {
    for (const GivenOption& given : arguments_.options) {
      if (table_[given.index].syntax.name == name) return true;
    }
    return false;
  }

 private:
  const Arguments& arguments_;
  std::span<const RenderOption> table_;
};

void apply(RenderOptions& options, const RenderOption& option, const GivenOption& given) {
  try {
    option.read(options, given.value);
  } catch (const ValueError& error) {
    const std::string name = given.source.empty() ? std::string(option.syntax.name)
                                                  : given.source + ": " + settings_name(option.syntax);
    constexpr std::size_t kMost = 200;  // Values of settings files may be of any length.
    const bool is_long = given.value.size() > kMost;
    const std::string value = is_long ? scene::gltf::one_line(given.value, kMost) : given.value;
    throw UsageError(name + ": '" + value +
                     "': " + (is_long ? scene::gltf::one_line(error.what(), 2 * kMost) : error.what()));
  }
}

struct Exclusion {
  std::string_view one, other;
};

/// Options that contradict each other.
constexpr Exclusion kExclusions[] = {
    {"--no-lights", "--light"},
    {"--turntable", "--frames"},
    {"--time", "--frames"},
    {"--view", "--stats"},
    {"--lens-radius", "--f-stop"},
    {"--focus-distance", "--focus-pixel"},
    {"--camera-view-angle", "--orthographic-height"},
    {"--sheet", "--raw"},
};

struct Need {
  std::string_view option, needs;
};

constexpr Need kNeeds[] = {{"--sheet", "--output"}, {"--raw", "--output"}};

void check_combinations(const Given& given) {
  for (const Exclusion& pair : kExclusions) {
    if (given(pair.one) && given(pair.other)) {
      throw UsageError(std::string(pair.one) + ": cannot be used together with " + std::string(pair.other));
    }
  }
  for (const char* focus : {"--focus-distance", "--focus-pixel"}) {
    if (!given(focus) || given("--lens-radius") || given("--f-stop")) continue;
    throw UsageError(std::string(focus) + ": only with --lens-radius or --f-stop");
  }
  for (const Need& need : kNeeds) {
    if (given(need.option) && !given(need.needs)) {
      throw UsageError(std::string(need.option) + ": only with " + std::string(need.needs));
    }
  }
  if (given("--fps") && !given("--frames") && !given("--turntable") && !given("--shutter")) {
    throw UsageError("--fps: only with --frames, --turntable or --shutter");
  }
}

void check_frame(const RenderOptions& options, const Given& given, const std::string& command,
                 bool needs_file) {
  if (needs_file && options.files.empty()) {
    throw UsageError(command + ": no FILE given; see barrido " + command + " --help");
  }
  for (const std::string& file : options.files) {
    if (file.empty()) throw UsageError(command + ": a FILE with an empty name");
  }
  if (std::count(options.files.begin(), options.files.end(), "-") > 1) {
    throw UsageError(command + ": standard input, -, can be read only once");
  }
  check_combinations(given);
  const scene::SampleChoice& samples = options.settings.samples;
  if (samples.sampling == scene::Sampling::adaptive) {
    if (samples.moves())
      throw UsageError("--shutter: not with --sampling adaptive: its samples have no time");
    if (samples.has_lens()) {
      throw UsageError((samples.lens_radius ? std::string("--lens-radius") : std::string("--f-stop")) +
                       ": not with --sampling adaptive: its samples have no place on a lens");
    }
    if (samples.filter != raster::PixelFilter{}) {
      throw UsageError("--pixel-filter: not with --sampling adaptive, which averages over the pixel's area");
    }
  }
  if (const auto& pixel = options.settings.samples.focus_pixel;
      pixel && (pixel->x >= options.settings.width || pixel->y >= options.settings.height)) {
    throw UsageError("--focus-pixel: lies outside of the frame of " + std::to_string(options.settings.width) +
                     " x " + std::to_string(options.settings.height) + " pixels");
  }
  if (options.settings.background == scene::Background::environment && options.environment_path.empty()) {
    throw UsageError("--background: 'environment': needs a picture, --environment PATH");
  }
  const scene::CameraChoice& camera = options.settings.camera;
  const bool several = options.all_cameras || options.cameras.size() > 1;
  if (several && (camera.position || camera.focal_point)) {
    const char* const other = camera.position ? "--camera-position" : "--camera-focal-point";
    throw UsageError(std::string("--camera-index: several cannot be used together with ") + other);
  }
  if (camera.position && camera.focal_point && *camera.position == *camera.focal_point) {
    throw UsageError("--camera-focal-point: is the same point as --camera-position");
  }
}

void check_output(const RenderOptions& options) {
  try {
    const OutputTemplate parsed(options.output);
  } catch (const ValueError& error) {
    throw UsageError("--output: '" + options.output + "': " + error.what());
  }
}

/// The options of the settings file, as if they had been given too; those that were given win.
void add_settings(Arguments& arguments, std::span<const RenderOption> table) {
  for (const GivenOption& given : arguments.options) {
    if (table[given.index].syntax.name != "--settings") continue;
    std::vector<OptionSyntax> syntax;
    for (const RenderOption& option : table) syntax.push_back(option.syntax);
    std::vector<GivenOption> all = read_settings(given.value, syntax);
    std::erase_if(all, [&](const GivenOption& option) { return arguments.has(option.index); });
    all.insert(all.end(), arguments.options.begin(), arguments.options.end());
    std::stable_sort(all.begin(), all.end(),
                     [](const GivenOption& a, const GivenOption& b) { return a.index < b.index; });
    arguments.options = std::move(all);
    return;
  }
}

}  // namespace

RenderOptions read_frame_options(Arguments arguments, std::span<const RenderOption> table,
                                 const std::string& command, bool needs_file) {
  RenderOptions options;
  options.help = Given(arguments, table)("--help");
  if (options.help) return options;
  add_settings(arguments, table);
  const Given given(arguments, table);
  for (const GivenOption& option : arguments.options) apply(options, table[option.index], option);
  options.files = arguments.files;
  check_frame(options, given, command, needs_file);
  scene::CameraChoice& camera = options.settings.camera;
  if (camera.position || camera.focal_point) camera.ignore_file_cameras = true;
  return options;
}

RenderOptions parse_view_options(std::span<const std::string> words) {
  return read_frame_options(parse_arguments(render_syntax(), words), render_option_table(), "view", false);
}

RenderOptions parse_render_options(std::span<const std::string> words) {
  const Arguments arguments = parse_arguments(render_syntax(), words);
  const RenderOptions options = read_frame_options(arguments, render_option_table(), "render");
  if (options.help) return options;
  const Given given(arguments, render_option_table());
  if (!given("--output") && !options.hash && options.stats == StatsFormat::none) {
    throw UsageError("render: no output given; say -o OUT (or only --hash or --stats)");
  }
  if (given("--output")) check_output(options);
  if (options.raw && options.output != "-") throw UsageError("--raw: goes to standard output, -o -, alone");
  return options;
}

}  // namespace barrido::cli
