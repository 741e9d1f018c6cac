#include "viewer/barrido/render_values.h"

#include <algorithm>

#include "raster/fragments/primitive.h"
#include "viewer/barrido/text_format.h"
#include "viewer/barrido/texture_spec.h"
#include "viewer/barrido/values.h"

namespace barrido::cli {
namespace {

constexpr int kLargestFrameNumber = 999'999;
constexpr int kMaxCameras = 1000;

constexpr auto kStatsFormats =
    std::to_array<Named<StatsFormat>>({{StatsFormat::text, "text"}, {StatsFormat::json, "json"}});

/// `separator` between two whole numbers in [least, most]. @throws ValueError with the message `otherwise`.
std::array<int, 2> parse_pair(std::string_view text, char separator, int least, int most,
                              const std::string& otherwise) {
  const auto parts = split(text, separator);
  try {
    if (parts.size() == 2) return {parse_whole(parts[0], least, most), parse_whole(parts[1], least, most)};
  } catch (const ValueError&) {
  }
  throw ValueError(otherwise);
}

std::string list_text(const std::vector<int>& numbers, int offset) {
  std::string text;
  for (const int number : numbers) text += (text.empty() ? "" : ",") + std::to_string(number + offset);
  return text;
}

}  // namespace

void read_resolution(RenderOptions& options, std::string_view text) {
  const std::string most = std::to_string(raster::kMaxFrameSide);
  const auto [width, height] =
      parse_pair(text, ',', 1, raster::kMaxFrameSide, "expected W,H, two whole numbers in 1.." + most);
  options.settings.width = width;
  options.settings.height = height;
}

Texts resolution_text(const RenderOptions& options) {
  return {std::to_string(options.settings.width) + "," + std::to_string(options.settings.height)};
}

void read_stats(RenderOptions& options, std::string_view text) {
  options.stats = text.empty() ? StatsFormat::text
                               : parse_choice(text, std::span<const Named<StatsFormat>>(kStatsFormats));
}

Texts stats_text(const RenderOptions& options) {
  for (const Named<StatsFormat>& format : kStatsFormats) {
    if (format.value == options.stats) return {std::string(format.name)};
  }
  return {};
}

void read_environment(RenderOptions& options, std::string_view text) {
  if (text.empty()) throw ValueError("expected a picture, a folder or dynamic");
  options.settings.dynamic_environment = text == "dynamic";
  options.environment_path = text == "dynamic" ? std::string() : std::string(text);
}

Texts environment_texts(const RenderOptions& options) {
  if (options.settings.dynamic_environment) return {"dynamic"};
  return options.environment_path.empty() ? Texts{} : Texts{options.environment_path};
}

void read_texture(RenderOptions& options, std::string_view text) {
  options.settings.texture.solid = parse_solid(text);
  options.texture_path = options.settings.texture.solid ? std::string() : std::string(text);
}

Texts texture_texts(const RenderOptions& options) {
  if (options.settings.texture.solid) return {solid_text(*options.settings.texture.solid)};
  return options.texture_path.empty() ? Texts{} : Texts{options.texture_path};
}

void read_mapping(RenderOptions& options, std::string_view text) {
  options.settings.texture.mapping = parse_mapping(text);
}

Texts mapping_texts(const RenderOptions& options) {
  const auto& mapping = options.settings.texture.mapping;
  return mapping ? Texts{mapping_text(*mapping)} : Texts{};
}

void read_displacement(RenderOptions& options, std::string_view text) {
  if (text.empty()) throw ValueError("expected a picture, a procedure or constant");
  options.settings.displacement.solid = text == "constant" ? std::nullopt : parse_solid(text);
  options.settings.displacement.source = text;
}

Texts displacement_texts(const RenderOptions& options) {
  const std::string& source = options.settings.displacement.source;
  return source.empty() ? Texts{} : Texts{source};
}

void read_light(RenderOptions& options, std::string_view text) {
  options.settings.lights.push_back(parse_light(text));
}

Texts light_texts(const RenderOptions& options) {
  Texts texts;
  for (const scene::UserLight& light : options.settings.lights) texts.push_back(light_text(light));
  return texts;
}

void read_lights_off(RenderOptions& options, std::string_view text) {
  for (const std::string_view number : split(text, ',')) {
    try {
      options.settings.lights_off.push_back(parse_whole(number, 1, raster::kMaxLights) - 1);
    } catch (const ValueError& error) {
      throw ValueError(std::string(error.what()) + ", or several with commas between");
    }
  }
}

Texts lights_off_texts(const RenderOptions& options) {
  const std::vector<int>& off = options.settings.lights_off;
  return off.empty() ? Texts{} : Texts{list_text(off, 1)};
}

void read_no_lights(RenderOptions& options, std::string_view) { options.settings.no_lights = true; }

// The window keeps the switch while it has lights of its own, which the command line refuses.
Texts no_lights_texts(const RenderOptions& options) {
  return options.settings.no_lights && options.settings.lights.empty() ? Texts{""} : Texts{};
}

void read_cameras(RenderOptions& options, std::string_view text) {
  if (text == "all" || text == "none") {
    options.all_cameras = text == "all";
    options.settings.camera.ignore_file_cameras = text == "none";
    return;
  }
  std::vector<int>& cameras = options.cameras;
  for (const std::string_view index : split(text, ',')) {
    try {
      cameras.push_back(parse_whole(index, 0, kMaxCameras));
    } catch (const ValueError& error) {
      throw ValueError(std::string(error.what()) + ", several with commas between, all or none");
    }
    if (std::count(cameras.begin(), cameras.end(), cameras.back()) > 1) {
      throw ValueError(std::string(index) + " is given twice");
    }
  }
}

Texts camera_texts(const RenderOptions& options) {
  const scene::CameraChoice& camera = options.settings.camera;
  if (options.all_cameras) return {"all"};
  if (!options.cameras.empty()) return {list_text(options.cameras, 0)};
  // An eye of the user's own puts the file's cameras aside by itself.
  const bool none = camera.ignore_file_cameras && !camera.position && !camera.focal_point;
  return none ? Texts{"none"} : Texts{};
}

glm::vec3 parse_up(std::string_view text) {
  struct Axis {
    std::string_view name;
    glm::vec3 up;
  };
  constexpr Axis kAxes[] = {{"+X", {1, 0, 0}},  {"-X", {-1, 0, 0}}, {"+Y", {0, 1, 0}},
                            {"-Y", {0, -1, 0}}, {"+Z", {0, 0, 1}},  {"-Z", {0, 0, -1}},
                            {"X", {1, 0, 0}},   {"Y", {0, 1, 0}},   {"Z", {0, 0, 1}}};
  for (const Axis& axis : kAxes) {
    if (axis.name == text) return axis.up;
  }
  std::array<float, 3> up{};
  if (parse_numbers(text, up, -kAnyNumber, kAnyNumber)) return parse_direction(text);
  throw ValueError("expected +X, -X, +Y, -Y, +Z, -Z or a direction X,Y,Z");
}

FrameRange parse_frames(std::string_view text) {
  const std::string otherwise =
      "expected A:B, two whole numbers in 0.." + std::to_string(kLargestFrameNumber) + ", A not above B";
  const auto [first, last] = parse_pair(text, ':', 0, kLargestFrameNumber, otherwise);
  if (first > last) throw ValueError(otherwise);
  return {first, last};
}

std::string frames_text(const FrameRange& frames) {
  return std::to_string(frames.first) + ":" + std::to_string(frames.last);
}

void read_background(RenderOptions& options, std::string_view text) {
  if (text == "environment") {
    options.settings.background = scene::Background::environment;
    return;
  }
  std::array<float, 4> color{0, 0, 0, 1};
  const std::span<float> all(color);
  if (!parse_numbers(text, all, 0.0, 1.0) && !parse_numbers(text, all.first(3), 0.0, 1.0)) {
    throw ValueError("expected R,G,B or R,G,B,A, numbers in 0..1, or environment");
  }
  options.background_shown = color;
}

Texts background_texts(const RenderOptions& options) {
  if (options.settings.background == scene::Background::environment) return {"environment"};
  if (!options.background_shown) return {};
  const auto& [r, g, b, a] = *options.background_shown;
  return {shortest(glm::vec3(r, g, b)) + (a == 1.0f ? "" : "," + shortest(a))};
}

scene::Shutter parse_shutter(std::string_view text) {
  constexpr double kMostFrames = 1000.0;
  const auto [open, close] = parse_tuple<2>(text, "OPEN,CLOSE", -kMostFrames, kMostFrames);
  if (close < open) throw ValueError("the shutter closes before it opens");
  return {open, close};
}

std::string shutter_text(const scene::Shutter& shutter) {
  return shortest(shutter.open) + "," + shortest(shutter.close);
}

scene::PixelPlace parse_pixel_place(std::string_view text) {
  const std::vector<std::string_view> parts = split(text, ',');
  if (parts.size() != 2) throw ValueError("expected X,Y, two whole numbers from 0");
  return {parse_whole(parts[0], 0, raster::kMaxFrameSide - 1),
          parse_whole(parts[1], 0, raster::kMaxFrameSide - 1)};
}

std::string pixel_place_text(const scene::PixelPlace& place) {
  return std::to_string(place.x) + "," + std::to_string(place.y);
}

raster::SimdTarget parse_simd(std::string_view text) {
  using raster::SimdTarget;
  std::vector<Named<SimdTarget>> targets;
  for (int i = static_cast<int>(SimdTarget::automatic); i <= static_cast<int>(SimdTarget::neon); ++i) {
    const auto target = static_cast<SimdTarget>(i);
    targets.push_back({target, raster::name_of(target)});
  }
  const SimdTarget wanted = parse_choice(text, std::span<const Named<SimdTarget>>(targets));
  if (wanted == SimdTarget::automatic) return wanted;
  std::string available;
  for (const SimdTarget target : raster::available_simd_targets()) {
    if (target == wanted) return wanted;
    available += (available.empty() ? "" : ", ") + std::string(raster::name_of(target));
  }
  throw ValueError("this machine has not got it; it has " + available);
}

std::string simd_text(const raster::SimdTarget& target) { return std::string(raster::name_of(target)); }

std::string stored(std::string_view text) { return std::string(text); }

std::string copied(const std::string& text) { return text; }

}  // namespace barrido::cli
