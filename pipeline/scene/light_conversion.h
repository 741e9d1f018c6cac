// From a file's or a user's lights to fixed-function ones, and the lights of a scene that has none. Enters:
// lights, where they stand, the eye; leaves: lights in world space. Knows no geometry.
#pragma once

#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "pipeline/scene/animate.h"
#include "pipeline/scene/render_scene.h"
#include "pipeline/state.h"

namespace barrido::scene {

/// Where a light is and where it shines, in some space.
struct LightPlace {
  glm::vec3 position{0, 0, 0};
  glm::vec3 direction{0, 0, -1};
};

/// KHR_lights_punctual: I = colour × intensity/π, attenuation 1/d² (directional: none), range, soft cone. An
/// exact intensity is the course's I_p: not divided, and attenuated only where the file says how (L4). An
/// exact spot exponent makes OpenGL's hard cone.
pipeline::Light convert_light(const Light& light, const LightPlace& place);

/// True when the intensity is in candela or lux, so that it has to be exposed.
inline bool is_physical(const Light& light) { return !light.exact_intensity.has_value(); }

/// The course's three-light set-up (V2) in eye space: the key from the upper left in front of the object, the
/// fill opposite with half its intensity, the back light behind and above. A white diffuse surface stays just
/// below 1 whichever way it faces, the default ambient light included.
std::vector<pipeline::Light> three_light_setup();

/// Ambient light I_a where nobody gives one: with lights, and in their absence.
inline constexpr float kDefaultAmbient = 0.05f;
inline constexpr float kAmbientWithoutLights = 1.0f;

/// `light` seen from another space.
pipeline::Light transformed(const pipeline::Light& light, const glm::mat4& to_from_space);

struct SceneLights {
  std::vector<pipeline::Light> lights;  ///< World space
  glm::vec3 ambient{0, 0, 0};
};

/// The lights of one frame, in the order: user's, else the file's in node order, else the three-light set-up.
/// `physical_scale` multiplies the file's physical lights (see metering.h). More than the pipeline can take
/// are left out with a warning.
SceneLights choose_lights(const Scene& scene, const std::vector<int>& nodes, int scene_index,
                          const Pose& pose, const RenderSettings& settings, const glm::mat4& eye_from_world,
                          float physical_scale, std::vector<std::string>& warnings);

/// The nodes among `nodes` that carry a light, in order.
std::vector<int> light_nodes(const Scene& scene, const std::vector<int>& nodes);

/// Where a node's light is: at its origin, shining along its −Z.
LightPlace place_of_node(const glm::mat4& world_from_node);

}  // namespace barrido::scene
