// Everything about one frame that is settled before anything is drawn. Enters: a scene, settings, and what
// earlier frames left in the caches; leaves: pose, eye, lights, draws and surroundings. Draws nothing.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/scene/draw_list.h"
#include "pipeline/scene/draw_state.h"
#include "pipeline/scene/environment_pass.h"
#include "pipeline/scene/framing.h"
#include "pipeline/scene/light_conversion.h"
#include "pipeline/scene/reflection_maps.h"
#include "pipeline/scene/render_scene.h"

namespace barrido::scene {

/// What does not change from frame to frame, made when first needed.
struct SceneCaches {
  explicit SceneCaches(const Scene& scene)
      : at_rest(scene), textures(scene), geometry(scene), displacer(scene, textures) {}

  const Scene& at_rest;  ///< With all its pictures.
  TextureCache textures;
  GeometryCache geometry;
  Displacer displacer;
  ReflectionMaps reflections;
  std::map<raster::Encoding, raster::Texture> studio;
  std::map<std::pair<int, int>, std::pair<glm::vec3, Bounds>>
      bounds;                        ///< By scene and animation; with their up
  std::map<int, float> light_scale;  ///< By scene
};

/// A part of the scene, and when: the nodes of one root in one pose.
struct PosedScene {
  int scene_index = kNone;
  std::vector<int> nodes;
  Pose pose;
  Bounds bounds;
};

struct SceneFrame {
  PosedScene posed;
  double aspect = 1.0;  ///< Width over height
  View view;
  SceneLights lights;
  std::optional<raster::FogState> fog;
  glm::vec4 clear_color{0, 0, 0, 1};
  DrawList list;
  /// What surfaces reflect: the user's environment, fixed to the world, or the studio, fixed to the eye. Null
  /// where neither a surface nor the background shows them.
  const raster::Texture* surroundings = nullptr;
  glm::mat4 surroundings_from_world{1.0f};
  bool backdrop_in_view = false;       ///< The surroundings are the background of the frame.
  bool backdrop_in_reflection = true;  ///< … and of environments rendered for its objects.
};

/// @throws InputError when the scene or animation asked for does not exist.
PosedScene pose_scene(const Scene& scene, const RenderSettings& settings, SceneCaches& caches);

/// The view of `posed` that the settings ask for. @throws InputError when there is no such camera.
View choose_view(const Scene& scene, const PosedScene& posed, const RenderSettings& settings);

/// `look`, unless empty, changes the view (where on the lens it goes through) before the rest is chosen.
/// @throws InputError as the two above.
SceneFrame prepare_frame(const Scene& scene, const RenderSettings& settings, SceneCaches& caches,
                         std::vector<std::string>& warnings, const std::function<void(View&)>& look = {});

/// Encoding of colour pictures: decoded for frames in linear light, else used as they are.
raster::Encoding color_encoding(const RenderSettings& settings);

/// The nodes that reflect enough to have surroundings of their own, with the middle of what they draw.
std::map<int, glm::dvec3> reflecting_nodes(const SceneFrame& frame);

}  // namespace barrido::scene
