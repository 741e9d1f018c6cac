#include "viewer/view/commands.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "raster/base/portable_math.h"
#include "viewer/barrido/specs.h"
#include "viewer/barrido/values.h"

namespace barrido::view {
namespace {

/// Three digits are enough for a distance that nobody measured.
float rounded(double value) {
  if (!(value > 0.0)) return 0.0f;
  double scale = 1.0;
  while (value * scale < 100.0) scale *= 10.0;
  while (value * scale >= 1000.0) scale /= 10.0;
  return static_cast<float>(std::floor(value * scale + 0.5) / scale);
}

cli::FogChoice fog_for(raster::FogMode mode, const Look& look) {
  const glm::dvec3 offset = look.bounds.center - look.eye.position;
  const double distance = std::sqrt(glm::dot(offset, offset));
  cli::FogChoice fog;
  fog.state.enabled = true;
  fog.state.mode = mode;
  fog.state.start = rounded(std::max(distance - look.bounds.radius, distance * 0.1));
  fog.state.end = rounded(distance + look.bounds.radius * 1.5);
  fog.state.density = rounded((mode == raster::FogMode::exp ? 0.7 : 0.8) / std::max(distance, 1e-9));
  return fog;
}

/// A light of a frame, world space, as one that the user could have given.
scene::UserLight user_light(const pipeline::Light& light) {
  using Kind = scene::Light::Kind;
  scene::UserLight user;
  const glm::vec3 color(light.diffuse);
  const float most = std::max({std::abs(color.r), std::abs(color.g), std::abs(color.b)});
  const bool negative = color.r + color.g + color.b < 0.0f;
  user.light.exact_intensity = negative ? -most : most;
  if (most > 0.0f) user.light.color = glm::max(color / (negative ? -most : most), glm::vec3(0.0f));
  if (light.position.w == 0.0f) {
    user.light.kind = Kind::directional;
    user.direction = -glm::vec3(light.position);
    return user;
  }
  user.position = glm::vec3(light.position);
  user.light.range = light.range;
  user.light.attenuation =
      std::array{light.constant_attenuation, light.linear_attenuation, light.quadratic_attenuation};
  const bool soft = light.spot_outer_cos < light.spot_inner_cos;
  user.light.kind = soft || light.spot_cutoff_deg <= 90.0f ? Kind::spot : Kind::point;
  if (user.light.kind == Kind::point) return user;
  user.direction = light.spot_direction;
  if (soft) {
    user.light.inner_cone_rad = static_cast<float>(portable_acos(light.spot_inner_cos));
    user.light.outer_cone_rad = static_cast<float>(portable_acos(light.spot_outer_cos));
  } else {
    user.light.spot_exponent = light.spot_exponent;
    user.light.outer_cone_rad = static_cast<float>(radians(light.spot_cutoff_deg));
  }
  return user;
}

}  // namespace

void step_fog(Viewer& viewer) {
  cli::RenderOptions& options = viewer.active();
  const std::optional<Look> look = viewer.look();
  if (!look) return;
  using raster::FogMode;
  if (!options.fog) {
    options.fog = fog_for(FogMode::linear, *look);
  } else if (options.fog->state.mode == FogMode::exp2) {
    options.fog.reset();
  } else {
    options.fog = fog_for(options.fog->state.mode == FogMode::linear ? FogMode::exp : FogMode::exp2, *look);
  }
}

void step_antialiasing(Viewer& viewer, int step) {
  struct Stage {
    scene::Sampling sampling;
    int count;
  };
  using scene::Sampling;
  constexpr Stage kStages[] = {{Sampling::uniform, 1},  {Sampling::uniform, 4},  {Sampling::uniform, 9},
                               {Sampling::uniform, 16}, {Sampling::uniform, 64}, {Sampling::jittered, 16},
                               {Sampling::adaptive, 1}};
  constexpr int kCount = static_cast<int>(std::size(kStages));
  scene::SampleChoice& samples = viewer.active().settings.samples;
  int now = 0;
  for (int i = 0; i < kCount; ++i) {
    const bool same = kStages[i].sampling == samples.sampling;
    if (same && (kStages[i].count <= samples.count || samples.sampling != Sampling::uniform)) now = i;
  }
  const Stage& next = kStages[(now + step + kCount) % kCount];
  samples.sampling = next.sampling;
  samples.count = next.count;
  // What adaptive sampling does not have is left out, as the command line would say.
  if (next.sampling != Sampling::adaptive) return;
  samples.filter = {};
  samples.shutter.reset();
  samples.lens_radius.reset();
  samples.f_stop.reset();
  samples.focus_distance.reset();
  samples.focus_pixel.reset();
}

void step_environment(Viewer& viewer) {
  cli::RenderOptions& options = viewer.active();
  const std::string& given = viewer.environment_given();
  const bool has_picture = !options.environment_path.empty();
  options.settings.background = scene::Background::color;
  if (has_picture) {
    options.environment_path.clear();
  } else if (!options.settings.dynamic_environment) {
    options.settings.dynamic_environment = true;
  } else {
    options.settings.dynamic_environment = false;
    options.environment_path = given;
  }
}

void toggle_environment_background(Viewer& viewer) {
  cli::RenderOptions& options = viewer.active();
  if (options.settings.background == scene::Background::environment) {
    options.settings.background = scene::Background::color;
  } else if (options.environment_path.empty()) {
    viewer.message = "a background needs an environment picture: --environment PATH, or drop one";
  } else {
    options.settings.background = scene::Background::environment;
  }
}

void toggle_light(cli::RenderOptions& options, int number) {
  std::vector<int>& off = options.settings.lights_off;
  const auto found = std::find(off.begin(), off.end(), number);
  if (found != off.end()) {
    off.erase(found);
  } else {
    off.insert(std::upper_bound(off.begin(), off.end(), number), number);
  }
}

scene::UserLight canonical(const scene::UserLight& light) {
  try {
    return cli::parse_light(cli::light_text(light));
  } catch (const cli::ValueError&) {
    return cli::parse_light("point");
  }
}

std::vector<scene::UserLight> shown_lights(Viewer& viewer) {
  const scene::RenderSettings& settings = viewer.active().settings;
  if (!settings.lights.empty() || settings.no_lights || viewer.model() == nullptr) return settings.lights;
  std::vector<scene::UserLight> lights;
  if (viewer.model()->scene().lights.empty()) {
    for (const char* preset : {"key", "fill", "back"}) lights.push_back(cli::parse_light(preset));
    return lights;
  }
  for (const pipeline::Light& light : viewer.model()->lights(viewer.active())) {
    lights.push_back(canonical(user_light(light)));
  }
  return lights;
}

void take_over_lights(Viewer& viewer) {
  cli::RenderOptions& options = viewer.active();
  if (viewer.model() == nullptr || !options.settings.lights.empty()) return;
  options.settings.no_lights = false;
  options.settings.lights = shown_lights(viewer);
  viewer.changed = true;
}

void remove_light(cli::RenderOptions& options, int number) {
  std::vector<scene::UserLight>& lights = options.settings.lights;
  if (number < 0 || static_cast<std::size_t>(number) >= lights.size()) return;
  lights.erase(lights.begin() + number);
  std::vector<int>& off = options.settings.lights_off;
  std::erase(off, number);
  for (int& other : off) other -= other > number;
}

}  // namespace barrido::view
