#include "pipeline/scene/light_conversion.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "pipeline/scene/framing.h"
#include "raster/base/portable_math.h"

namespace barrido::scene {
namespace {

constexpr float kKeyIntensity = 0.82f;
constexpr float kFillIntensity = 0.5f * kKeyIntensity;
constexpr float kBackIntensity = 0.45f;

pipeline::Light directional(const glm::vec3& towards_light, float intensity) {
  pipeline::Light light;
  light.position = glm::vec4(glm::vec3(unit_or(glm::dvec3(towards_light), {0, 0, 1})), 0.0f);
  light.diffuse = light.specular = glm::vec4(glm::vec3(intensity), 1.0f);
  return light;
}

void set_cone(pipeline::Light& out, const Light& light) {
  if (light.spot_exponent) {
    out.spot_exponent = *light.spot_exponent;
    out.spot_cutoff_deg = std::min(light.outer_cone_rad * static_cast<float>(180.0 / kPi), 90.0f);
    return;
  }
  out.spot_inner_cos = static_cast<float>(portable_cos(light.inner_cone_rad));
  out.spot_outer_cos = static_cast<float>(portable_cos(light.outer_cone_rad));
  // Equal cosines would switch the soft cone off; this is the sharpest edge it can have.
  out.spot_inner_cos = std::max(out.spot_inner_cos, out.spot_outer_cos + 1e-6f);
}

void set_attenuation(pipeline::Light& out, const Light& light) {
  std::array<float, 3> k{1.0f, 0.0f, 0.0f};
  if (light.attenuation) {
    k = *light.attenuation;
  } else if (is_physical(light)) {
    k = {0.0f, 0.0f, 1.0f};
  }
  out.constant_attenuation = k[0];
  out.linear_attenuation = k[1];
  out.quadratic_attenuation = k[2];
  out.range = light.range;
}

void scale(pipeline::Light& light, float factor) {
  light.diffuse = glm::vec4(glm::vec3(light.diffuse) * factor, light.diffuse.a);
  light.specular = glm::vec4(glm::vec3(light.specular) * factor, light.specular.a);
}

std::vector<pipeline::Light> user_lights(const std::vector<UserLight>& lights,
                                         const glm::mat4& world_from_eye, const glm::dvec3& origin) {
  std::vector<pipeline::Light> converted;
  for (const UserLight& light : lights) {
    const bool at_eye = light.space == UserLight::Space::camera;
    const glm::vec3 position = at_eye ? light.position : glm::vec3(glm::dvec3(light.position) - origin);
    converted.push_back(convert_light(light.light, {position, light.direction}));
    if (at_eye) converted.back() = transformed(converted.back(), world_from_eye);
  }
  return converted;
}

std::vector<pipeline::Light> file_lights(const Scene& scene, const std::vector<int>& nodes, const Pose& pose,
                                         float physical_scale) {
  std::vector<pipeline::Light> converted;
  for (const int node : light_nodes(scene, nodes)) {
    const auto index = static_cast<std::size_t>(node);
    const Light& light = scene.lights[static_cast<std::size_t>(scene.nodes[index].light)];
    converted.push_back(convert_light(light, place_of_node(pose.world_from_node[index])));
    if (is_physical(light)) scale(converted.back(), physical_scale);
  }
  return converted;
}

glm::vec3 choose_ambient(const Scene& scene, int scene_index, const RenderSettings& settings) {
  if (settings.ambient) return *settings.ambient;
  if (scene_index != kNone) {
    const SceneSettings& own = scene.scenes[static_cast<std::size_t>(scene_index)].settings;
    if (own.ambient) return *own.ambient;
  }
  return glm::vec3(settings.no_lights ? kAmbientWithoutLights : kDefaultAmbient);
}

void switch_off(std::vector<pipeline::Light>& lights, const std::vector<int>& off,
                std::vector<std::string>& warnings) {
  const auto count = static_cast<int>(lights.size());
  if (std::any_of(off.begin(), off.end(), [&](int place) { return place >= count; })) {
    warnings.push_back("a light to be switched off does not exist: there " +
                       (count == 1 ? std::string("is 1 light") : "are " + std::to_string(count) + " lights"));
  }
  std::vector<pipeline::Light> on;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (std::find(off.begin(), off.end(), static_cast<int>(i)) == off.end()) on.push_back(lights[i]);
  }
  lights = std::move(on);
}

}  // namespace

pipeline::Light convert_light(const Light& light, const LightPlace& place) {
  pipeline::Light out;
  const float intensity =
      light.exact_intensity ? *light.exact_intensity : light.intensity * static_cast<float>(1.0 / kPi);
  out.diffuse = out.specular = glm::vec4(light.color * intensity, 1.0f);
  const glm::vec3 direction(unit_or(glm::dvec3(place.direction), {0, 0, -1}));
  if (light.kind == Light::Kind::directional) {
    out.position = glm::vec4(-direction, 0.0f);
    return out;
  }
  out.position = glm::vec4(place.position, 1.0f);
  set_attenuation(out, light);
  if (light.kind == Light::Kind::spot) {
    out.spot_direction = direction;
    set_cone(out, light);
  }
  return out;
}

std::vector<pipeline::Light> three_light_setup() {
  return {directional({-0.55f, 0.60f, 0.58f}, kKeyIntensity),
          directional({0.80f, 0.10f, 0.59f}, kFillIntensity),
          directional({0.15f, 0.62f, -0.77f}, kBackIntensity)};
}

pipeline::Light transformed(const pipeline::Light& light, const glm::mat4& to_from_space) {
  pipeline::Light out = light;
  out.position = to_from_space * light.position;
  out.spot_direction = glm::mat3(to_from_space) * light.spot_direction;
  return out;
}

std::vector<int> light_nodes(const Scene& scene, const std::vector<int>& nodes) {
  std::vector<int> lights;
  std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(lights),
               [&](int node) { return scene.nodes[static_cast<std::size_t>(node)].light != kNone; });
  return lights;
}

LightPlace place_of_node(const glm::mat4& world_from_node) {
  return {glm::vec3(world_from_node[3]), -glm::vec3(world_from_node[2])};
}

SceneLights choose_lights(const Scene& scene, const std::vector<int>& nodes, int scene_index,
                          const Pose& pose, const RenderSettings& settings, const glm::mat4& eye_from_world,
                          float physical_scale, std::vector<std::string>& warnings) {
  SceneLights chosen;
  chosen.ambient = choose_ambient(scene, scene_index, settings);
  if (settings.no_lights) return chosen;
  const glm::mat4 world_from_eye = glm::inverse(eye_from_world);
  if (!settings.lights.empty()) {
    chosen.lights = user_lights(settings.lights, world_from_eye, pose.origin);
  } else {
    chosen.lights = file_lights(scene, nodes, pose, physical_scale);
  }
  if (chosen.lights.empty()) {
    for (const pipeline::Light& light : three_light_setup()) {
      chosen.lights.push_back(transformed(light, world_from_eye));
    }
  }
  if (chosen.lights.size() > raster::kMaxLights) {
    warnings.push_back("more than " + std::to_string(raster::kMaxLights) + " lights: the first " +
                       std::to_string(raster::kMaxLights) + " are used");
    chosen.lights.resize(raster::kMaxLights);
  }
  switch_off(chosen.lights, settings.lights_off, warnings);
  return chosen;
}

}  // namespace barrido::scene
