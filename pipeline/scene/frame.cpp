#include "pipeline/scene/frame.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "pipeline/files/error.h"
#include "pipeline/scene/metering.h"
#include "pipeline/scene/scene_nodes.h"
#include "pipeline/scene/studio.h"
#include "pipeline/scene/view.h"

namespace barrido::scene {
namespace {

/// Below this a reflection is too faint to be worth six pictures.
constexpr float kLeastDynamicReflectance = 0.2f;

/// Dark grey as seen on the screen, where nobody asks for another background.
constexpr glm::vec4 kDefaultBackground{0.2f, 0.2f, 0.2f, 1.0f};

double aspect_of(const RenderSettings& settings) {
  return static_cast<double>(settings.width) / static_cast<double>(settings.height);
}

/// Kept from frame to frame, as a turntable asks for them again and again.
Bounds bounds_of(const Scene& scene, const PosedScene& posed, const RenderSettings& settings,
                 SceneCaches& caches) {
  const glm::vec3 up = settings.camera.up;
  const auto [slot, is_new] =
      caches.bounds.try_emplace({posed.scene_index, settings.animation}, up, Bounds{});
  if (is_new || slot->second.first != up) {
    slot->second = {
        up, find_bounds(scene, posed.nodes, framing_poses(scene, settings.animation), glm::dvec3(up))};
  }
  return slot->second.second;
}

/// Room for what displacement moves outwards, as far as the largest node makes it.
Bounds grown(Bounds bounds, const Scene& scene, const PosedScene& posed, const RenderSettings& settings) {
  double largest = 0.0;
  for (const int node : posed.nodes) {
    const auto index = static_cast<std::size_t>(node);
    if (scene.nodes[index].mesh == kNone) continue;
    const glm::dmat3 matrix(glm::mat3(posed.pose.world_from_node[index]));
    for (int c = 0; c < 3; ++c) largest = std::max(largest, glm::dot(matrix[c], matrix[c]));
  }
  const double by = double{farthest_displacement(scene, settings.displacement)} * std::sqrt(largest);
  if (!(by > 0.0) || !std::isfinite(by)) return bounds;
  bounds.sphere.radius += by;
  for (glm::dvec2& ring : bounds.rings) ring += glm::dvec2(by, ring.y < 0.0 ? -by : by);
  return bounds;
}

/// The same at every moment, so that lights that grow are seen to.
float light_scale(const PosedScene& posed, SceneCaches& caches) {
  const Scene& scene = caches.at_rest;
  const auto [slot, is_new] = caches.light_scale.try_emplace(posed.scene_index, 1.0f);
  if (is_new && !light_nodes(scene, posed.nodes).empty()) {
    slot->second = physical_light_scale(scene, posed.nodes, pose_at(scene, kNone, 0.0));
  }
  return slot->second;
}

/// Colours of the user are as seen on the screen; those of a file are linear, as all its numbers.
glm::vec4 choose_clear_color(const SceneSettings* own, const RenderSettings& settings) {
  if (!settings.background_color && own != nullptr && own->background) return *own->background;
  const glm::vec4 seen = settings.background_color.value_or(kDefaultBackground);
  return glm::vec4(frame_color(glm::vec3(seen), settings), seen.a);
}

std::optional<raster::FogState> choose_fog(const SceneSettings* own, const RenderSettings& settings,
                                           const glm::vec4& background) {
  if (!settings.fog) return own != nullptr ? own->fog : std::nullopt;
  raster::FogState fog = *settings.fog;
  const glm::vec3 given(fog.color[0], fog.color[1], fog.color[2]);
  const glm::vec3 color =
      settings.fog_takes_background ? glm::vec3(background) : frame_color(given, settings);
  fog.color = {color.r, color.g, color.b, fog.color[3]};
  return fog;
}

const raster::Texture& studio(raster::Encoding encoding, SceneCaches& caches) {
  const auto found = caches.studio.find(encoding);
  if (found != caches.studio.end()) return found->second;
  return caches.studio.emplace(encoding, make_studio(encoding)).first->second;
}

/// Whether any pixel of the frame, or of the environments of its objects, shows the surroundings.
bool needs_surroundings(const SceneFrame& frame, const RenderSettings& settings) {
  if (settings.background == Background::environment) return true;
  for (const Draw& draw : frame.list.draws) {
    if (draw.surface.reflection_unit != kNone) return true;
  }
  return false;
}

void choose_surroundings(SceneFrame& frame, const SceneSettings* own, const RenderSettings& settings,
                         SceneCaches& caches) {
  const bool has_environment = settings.environment && settings.environment->is_cube();
  if (has_environment) {
    frame.surroundings = settings.environment.get();
    const glm::mat3 upright_from_world(glm::transpose(world_from_upright(glm::dvec3(settings.camera.up))));
    frame.surroundings_from_world = glm::mat4(upright_from_world);
  } else if (needs_surroundings(frame, settings)) {
    frame.surroundings = &studio(color_encoding(settings), caches);
    frame.surroundings_from_world = glm::mat4(glm::mat3(frame.view.eye_from_world));
  }
  frame.backdrop_in_view = settings.background == Background::environment;
  const bool has_color = settings.background_color || (own != nullptr && own->background);
  frame.backdrop_in_reflection = has_environment || frame.backdrop_in_view || !has_color;
}

SurfaceOptions surface_options(const RenderSettings& settings) {
  SurfaceOptions options;
  options.encoding = color_encoding(settings);
  options.textures = settings.textures;
  options.mip_colors = settings.mip_colors;
  options.min_filter = settings.min_filter;
  options.mag_filter = settings.mag_filter;
  options.max_anisotropy = settings.max_anisotropy;
  options.reflections = settings.environment ? Reflections::all : Reflections::metals;
  options.specular_model = settings.lighting;
  options.material = settings.material;
  options.maps = settings.maps;
  const pipeline::ColorOrigin& lit = pipeline::shading_mode(settings.shading).lit;
  options.fragment_light = lit.at_fragments;
  options.fragment_normals = lit.at_fragments && !lit.at_vertices;
  options.texture = settings.texture;
  // OpenGL's limits where OpenGL's results are asked for.
  if (!uses_float_frame(settings)) options.limits = {128.0f, true};
  return options;
}

/// One warning a frame of maps that the shading mode cannot draw.
void warn_of_dropped_maps(const SceneFrame& frame, const RenderSettings& settings,
                          std::vector<std::string>& warnings) {
  const auto any = [&](bool SurfaceState::*drops) {
    return std::any_of(frame.list.draws.begin(), frame.list.draws.end(),
                       [&](const Draw& draw) { return draw.surface.*drops; });
  };
  const std::string mode(pipeline::shading_mode(settings.shading).words);
  if (any(&SurfaceState::drops_normals)) {
    warnings.push_back("normal and bump maps are not drawn: " + mode +
                       " shading has no normal at a fragment; --shading phong has");
  }
  if (any(&SurfaceState::drops_occlusion)) {
    warnings.push_back("occlusion maps are not drawn: " + mode +
                       " shading adds up ambient light at vertices; --shading phong does at fragments");
  }
}

/// A texture that the user wants, on surfaces that have no coordinates for it.
void warn_of_coordinates(const SceneFrame& frame, const RenderSettings& settings,
                         std::vector<std::string>& warnings) {
  const std::optional<SolidTexture>& solid = settings.texture.solid;
  const bool needs_some = settings.texture.picture || (solid && solid->space == SolidTexture::Space::surface);
  if (!needs_some) return;
  const auto lacks_some = [](const Draw& draw) {
    for (std::size_t unit = 0; unit < raster::kMaxTextureUnits; ++unit) {
      if (draw.surface.texcoord_set[unit] != kNone && draw.geometry.texcoord[unit].data == nullptr)
        return true;
    }
    return false;
  };
  const auto count = std::count_if(frame.list.draws.begin(), frame.list.draws.end(), lacks_some);
  if (count == 0) return;
  warnings.push_back(std::to_string(count) + (count == 1 ? " surface has" : " surfaces have") +
                     " no texture coordinates for --texture: --mapping gives them some");
}

}  // namespace

raster::Encoding color_encoding(const RenderSettings& settings) {
  return settings.color_management == ColorManagement::srgb ? raster::Encoding::srgb
                                                            : raster::Encoding::linear;
}

PosedScene pose_scene(const Scene& scene, const RenderSettings& settings, SceneCaches& caches) {
  const int animations = static_cast<int>(scene.animations.size());
  if (settings.animation != kNone && (settings.animation < 0 || settings.animation >= animations)) {
    throw InputError(
        scene.source, "animation " + std::to_string(settings.animation),
        "the file has " + std::to_string(animations) + (animations == 1 ? " animation" : " animations"));
  }
  PosedScene posed;
  posed.scene_index = resolve_scene_index(scene, settings.scene_index);
  posed.nodes = nodes_of_scene(scene, posed.scene_index);
  posed.pose = pose_at(scene, settings.animation, settings.time_s);
  posed.bounds = grown(bounds_of(scene, posed, settings, caches), scene, posed, settings);
  return posed;
}

View choose_view(const Scene& scene, const PosedScene& posed, const RenderSettings& settings) {
  const Eye eye = choose_eye(scene, posed.nodes, posed.pose, posed.bounds, settings);
  return view_of(eye, posed.bounds.sphere, aspect_of(settings), posed.pose.origin);
}

SceneFrame prepare_frame(const Scene& scene, const RenderSettings& settings, SceneCaches& caches,
                         std::vector<std::string>& warnings, const std::function<void(View&)>& look) {
  SceneFrame frame;
  frame.posed = pose_scene(scene, settings, caches);
  frame.aspect = aspect_of(settings);
  frame.view = choose_view(scene, frame.posed, settings);
  if (look) look(frame.view);
  frame.lights = choose_lights(scene, frame.posed.nodes, frame.posed.scene_index, frame.posed.pose, settings,
                               frame.view.eye_from_world, light_scale(frame.posed, caches), warnings);
  const int index = frame.posed.scene_index;
  const SceneSettings* own =
      index == kNone ? nullptr : &scene.scenes[static_cast<std::size_t>(index)].settings;
  frame.clear_color = choose_clear_color(own, settings);
  frame.fog = choose_fog(own, settings, frame.clear_color);
  SurfaceOptions options = surface_options(settings);
  options.variant = resolve_variant(scene, settings.variant);
  options.scene_size = static_cast<float>(2.0 * frame.posed.bounds.sphere.radius);
  options.origin = frame.posed.pose.origin;
  options.eye_from_world = frame.view.eye_from_world;
  caches.textures.give(settings.texture.picture);
  caches.displacer.begin_frame(settings, warnings);
  frame.list =
      collect_draws(scene, frame.posed.nodes, frame.posed.pose,
                    {settings.crease_angle_deg, options, caches.displacer, caches.geometry, caches.textures});
  warn_of_dropped_maps(frame, settings, warnings);
  warn_of_coordinates(frame, settings, warnings);
  choose_surroundings(frame, own, settings, caches);
  return frame;
}

std::map<int, glm::dvec3> reflecting_nodes(const SceneFrame& frame) {
  std::map<int, std::pair<glm::dvec3, int>> sums;
  for (const Draw& draw : frame.list.draws) {
    const int unit = draw.surface.reflection_unit;
    if (unit == kNone) continue;
    const std::array<float, 4>& share = draw.surface.units[static_cast<std::size_t>(unit)].env_color;
    if (std::max({share[0], share[1], share[2]}) < kLeastDynamicReflectance) continue;
    auto& [sum, count] = sums.try_emplace(draw.node, glm::dvec3(0.0), 0).first->second;
    sum += glm::dvec3(draw.world_from_object * glm::vec4(draw.center, 1.0f));
    ++count;
  }
  std::map<int, glm::dvec3> centers;
  for (const auto& [node, sum] : sums) centers[node] = sum.first / static_cast<double>(sum.second);
  return centers;
}

}  // namespace barrido::scene
