#include "viewer/barrido/render_values.h"

#include <algorithm>

#include "raster/fragments/primitive.h"
#include "viewer/barrido/values.h"

namespace barrido::cli {
namespace {

using pipeline::ShadeModel;

constexpr std::array<Choice<ShadeModel>, pipeline::kShadeModelCount> kShadings{
    {{"flat", ShadeModel::flat},
     {"gouraud", ShadeModel::gouraud},
     {"cheap-phong", ShadeModel::cheap_phong},
     {"phong", ShadeModel::phong}}};

constexpr int kLargestFrameNumber = 999'999;
constexpr int kMaxCameras = 1000;

bool is_given_twice(const std::vector<int>& cameras) {
  return std::find(cameras.begin(), cameras.end() - 1, cameras.back()) != cameras.end() - 1;
}

}  // namespace

std::string_view name_of(ShadeModel model) {
  return kShadings[static_cast<std::size_t>(model)].name;  // The table is in the order of the enumeration.
}

void set_resolution(RenderOptions& options, std::string_view text) {
  const auto sides = split(text, ',');
  try {
    if (sides.size() != 2) throw ValueError("");
    options.settings.width = parse_whole(sides[0], 1, raster::kMaxFrameSide);
    options.settings.height = parse_whole(sides[1], 1, raster::kMaxFrameSide);
  } catch (const ValueError&) {
    throw ValueError("expected W,H, two whole numbers in 1.." + std::to_string(raster::kMaxFrameSide));
  }
}

void set_shadings(RenderOptions& options, std::string_view text) {
  options.shadings.clear();
  if (text == "all") {
    for (const Choice<ShadeModel>& choice : kShadings) options.shadings.push_back(choice.value);
    return;
  }
  for (const std::string_view name : split(text, ',')) {
    try {
      options.shadings.push_back(parse_choice(name, kShadings));
    } catch (const ValueError& error) {
      throw ValueError(std::string(error.what()) + " (or several with commas between, or all)");
    }
    const auto last = options.shadings.end() - 1;
    if (std::find(options.shadings.begin(), last, *last) != last) {
      throw ValueError(std::string(name) + " is given twice");
    }
  }
}

void set_views(RenderOptions& options, std::string_view text) {
  options.views.clear();
  std::vector<std::string_view> names{"picture"};
  for (int i = 0; i < inspect::kStructureViewCount; ++i) {
    names.push_back(inspect::name_of(static_cast<inspect::StructureView>(i)));
  }
  if (text == "all") {
    for (std::size_t i = 1; i < names.size(); ++i) {
      options.views.push_back(inspect::structure_view_of(names[i]));
    }
    return;
  }
  for (const std::string_view name : split(text, ',')) {
    const auto view = inspect::structure_view_of(name);
    if (!view && name != "picture") {
      throw ValueError("expected " + one_of(names) + did_you_mean(name, names) +
                       " (or several with commas between, or all)");
    }
    if (std::find(options.views.begin(), options.views.end(), view) != options.views.end()) {
      throw ValueError(std::string(name) + " is given twice");
    }
    options.views.push_back(view);
  }
}

void set_stats(RenderOptions& options, std::string_view text) {
  constexpr std::array<Choice<StatsFormat>, 2> kFormats{
      {{"text", StatsFormat::text}, {"json", StatsFormat::json}}};
  options.stats = text.empty() ? StatsFormat::text : parse_choice(text, kFormats);
}

void set_environment(RenderOptions& options, std::string_view text) {
  if (text.empty()) throw ValueError("expected a picture, a folder or dynamic");
  options.settings.dynamic_environment = text == "dynamic";
  options.environment_path = text == "dynamic" ? std::string() : std::string(text);
}

void set_background(RenderOptions& options, std::string_view text) {
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

void set_ambient(RenderOptions& options, std::string_view text) {
  const auto color = parse_tuple<3>(text, "R,G,B", 0.0, 1e6);
  options.settings.ambient = glm::vec3(color[0], color[1], color[2]);
}

void set_cameras(RenderOptions& options, std::string_view text) {
  if (text == "all" || text == "none") {
    options.all_cameras = text == "all";
    options.settings.camera.ignore_file_cameras = text == "none";
    return;
  }
  for (const std::string_view index : split(text, ',')) {
    try {
      options.cameras.push_back(parse_whole(index, 0, kMaxCameras));
    } catch (const ValueError& error) {
      throw ValueError(std::string(error.what()) + ", several with commas between, all or none");
    }
    if (is_given_twice(options.cameras)) throw ValueError(std::string(index) + " is given twice");
  }
}

void set_up(RenderOptions& options, std::string_view text) {
  constexpr std::array<Choice<std::array<float, 3>>, 9> kAxes{{{"+X", {1, 0, 0}},
                                                               {"-X", {-1, 0, 0}},
                                                               {"+Y", {0, 1, 0}},
                                                               {"-Y", {0, -1, 0}},
                                                               {"+Z", {0, 0, 1}},
                                                               {"-Z", {0, 0, -1}},
                                                               {"X", {1, 0, 0}},
                                                               {"Y", {0, 1, 0}},
                                                               {"Z", {0, 0, 1}}}};
  std::array<float, 3> up{};
  const bool numbers = parse_numbers(text, up, -kAnyNumber, kAnyNumber);
  for (const auto& axis : kAxes) {
    if (axis.name == text) up = axis.value;
  }
  if (up == std::array<float, 3>{}) {
    throw ValueError(numbers ? "expected a direction, not 0,0,0"
                             : "expected +X, -X, +Y, -Y, +Z, -Z or a direction X,Y,Z");
  }
  options.settings.camera.up = {up[0], up[1], up[2]};
}

void set_camera_up(RenderOptions& options, std::string_view text) {
  const glm::vec3 up = parse_point(text);
  if (up == glm::vec3(0.0f)) throw ValueError("expected a direction, not 0,0,0");
  options.settings.camera.view_up = up;
}

void set_orthographic_height(RenderOptions& options, std::string_view text) {
  options.settings.camera.orthographic_height = static_cast<float>(parse_number(text, 1e-18, kAnyNumber));
}

void set_lights_off(RenderOptions& options, std::string_view text) {
  for (const std::string_view number : split(text, ',')) {
    try {
      options.settings.lights_off.push_back(parse_whole(number, 1, raster::kMaxLights) - 1);
    } catch (const ValueError& error) {
      throw ValueError(std::string(error.what()) + ", or several with commas between");
    }
  }
}

void set_frames(RenderOptions& options, std::string_view text) {
  const auto ends = split(text, ':');
  FrameRange range;
  try {
    if (ends.size() != 2) throw ValueError("");
    range.first = parse_whole(ends[0], 0, kLargestFrameNumber);
    range.last = parse_whole(ends[1], range.first, kLargestFrameNumber);
  } catch (const ValueError&) {
    throw ValueError("expected A:B, two whole numbers in 0.." + std::to_string(kLargestFrameNumber) +
                     ", A not above B");
  }
  options.frames = range;
}

void set_simd(RenderOptions& options, std::string_view text) {
  constexpr std::array<Choice<raster::SimdTarget>, 6> kTargets{{{"auto", raster::SimdTarget::automatic},
                                                                {"scalar", raster::SimdTarget::scalar},
                                                                {"sse4", raster::SimdTarget::sse4},
                                                                {"avx2", raster::SimdTarget::avx2},
                                                                {"avx512", raster::SimdTarget::avx512},
                                                                {"neon", raster::SimdTarget::neon}}};
  options.simd = parse_choice(text, kTargets);
  if (options.simd == raster::SimdTarget::automatic) return;
  std::string available;
  for (const raster::SimdTarget target : raster::available_simd_targets()) {
    if (target == options.simd) return;
    available += (available.empty() ? "" : ", ") + std::string(raster::name_of(target));
  }
  throw ValueError("this machine has not got it; it has " + available);
}

glm::vec3 parse_point(std::string_view text) {
  const auto point = parse_tuple<3>(text, "X,Y,Z", -kAnyNumber, kAnyNumber);
  return {point[0], point[1], point[2]};
}

float parse_degrees(std::string_view text, double least, double most) {
  return static_cast<float>(parse_number(text, least, most));
}

}  // namespace barrido::cli
