#include "pipeline/scene/moving_properties.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <glm/common.hpp>

#include "pipeline/scene/animate.h"
#include "raster/base/portable_math.h"

namespace barrido::scene {
namespace {

using Property = PropertyChannel::Property;

constexpr float kHalfPi = 1.57079633f;
/// As narrow and as wide as perspective allows.
constexpr float kLeastFov = 1e-4f, kMostFov = 3.1f;
constexpr float kSmallest = 1e-6f;

/// The parts of a property that is one only as a whole; see PropertyChannel::rest.
using Parts = std::array<float, 5>;
/// By material and which of its textures; of emission none.
using Key = std::pair<int, TextureUse Material::*>;

/// Of the materials, in order of first mention: pointers to members have no order.
class PartsOfMaterials {
 public:
  Parts& of(const PropertyChannel& channel) {
    for (auto& [key, parts] : parts_) {
      if (key == Key{channel.index, channel.use}) return parts;
    }
    return parts_.emplace_back(Key{channel.index, channel.use}, channel.rest).second;
  }

 private:
  std::vector<std::pair<Key, Parts>> parts_;
};

template <class T>
T& element_of(std::vector<T>& elements, const PropertyChannel& channel) {
  return elements[static_cast<std::size_t>(channel.index)];
}

void move_texture(const PropertyChannel& channel, double time_s, PartsOfMaterials& parts, Scene& moved) {
  Parts& transform = parts.of(channel);
  const std::size_t first = channel.property == Property::texture_offset     ? 0
                            : channel.property == Property::texture_rotation ? 2
                                                                             : 3;
  sample_numbers(channel.keys, time_s, std::span(transform).subspan(first, first == 2 ? 1 : 2));
  (element_of(moved.materials, channel).*channel.use).transform =
      texture_matrix({transform[0], transform[1]}, double{transform[2]}, {transform[3], transform[4]});
}

void move_emission(const PropertyChannel& channel, double time_s, PartsOfMaterials& parts, Scene& moved) {
  Parts& emission = parts.of(channel);
  const bool is_factor = channel.property == Property::emissive_factor;
  sample_numbers(channel.keys, time_s, std::span(emission).subspan(is_factor ? 0 : 3, is_factor ? 3 : 1));
  for (int c = 0; c < 3; ++c) {
    const float factor = std::max(emission[static_cast<std::size_t>(c)], 0.0f);
    element_of(moved.materials, channel).emissive[c] = factor * std::max(emission[3], 0.0f);
  }
}

/// One number, or a colour, and its bounds.
void move_numbers(const PropertyChannel& channel, double time_s, std::span<float> numbers, float least,
                  float most) {
  sample_numbers(channel.keys, time_s, numbers);
  for (float& number : numbers) number = std::clamp(number, least, most);
}

void move_light(const PropertyChannel& channel, double time_s, Light& light) {
  constexpr float kMost = 1e30f;
  switch (channel.property) {
    case Property::light_color:
      return move_numbers(channel, time_s, std::span(&light.color.x, 3), 0.0f, kMost);
    case Property::light_intensity:
      return move_numbers(channel, time_s, std::span(&light.intensity, 1), 0.0f, kMost);
    case Property::light_range:
      return move_numbers(channel, time_s, std::span(&light.range, 1), 0.0f, kMost);
    case Property::light_inner_cone:
      return move_numbers(channel, time_s, std::span(&light.inner_cone_rad, 1), 0.0f, kHalfPi);
    default:
      return move_numbers(channel, time_s, std::span(&light.outer_cone_rad, 1), 0.0f, kHalfPi);
  }
}

void move_camera(const PropertyChannel& channel, double time_s, Camera& camera) {
  constexpr float kMost = 1e18f;
  switch (channel.property) {
    case Property::camera_fov:
      return move_numbers(channel, time_s, std::span(&camera.vertical_fov_rad, 1), kLeastFov, kMostFov);
    case Property::camera_half_width:
      return move_numbers(channel, time_s, std::span(&camera.half_width, 1), kSmallest, kMost);
    case Property::camera_half_height:
      return move_numbers(channel, time_s, std::span(&camera.half_height, 1), kSmallest, kMost);
    case Property::camera_near: {
      const bool perspective = camera.kind == Camera::Kind::perspective;
      return move_numbers(channel, time_s, std::span(&camera.near_plane, 1), perspective ? kSmallest : 0.0f,
                          kMost);
    }
    default:
      return move_numbers(channel, time_s, std::span(&camera.far_plane, 1), 0.0f, kMost);
  }
}

void move_material(const PropertyChannel& channel, double time_s, Material& material) {
  switch (channel.property) {
    case Property::base_color:
      return move_numbers(channel, time_s, std::span(&material.base_color.x, 4), 0.0f, 1.0f);
    case Property::metallic:
      return move_numbers(channel, time_s, std::span(&material.metallic, 1), 0.0f, 1.0f);
    case Property::roughness:
      return move_numbers(channel, time_s, std::span(&material.roughness, 1), 0.0f, 1.0f);
    default:
      return move_numbers(channel, time_s, std::span(&material.alpha_cutoff, 1), 0.0f, 1e30f);
  }
}

void move(const PropertyChannel& channel, double time_s, PartsOfMaterials& parts, Scene& moved) {
  switch (channel.property) {
    case Property::base_color:
    case Property::metallic:
    case Property::roughness:
    case Property::alpha_cutoff:
      return move_material(channel, time_s, element_of(moved.materials, channel));
    case Property::emissive_factor:
    case Property::emissive_strength:
      return move_emission(channel, time_s, parts, moved);
    case Property::texture_offset:
    case Property::texture_rotation:
    case Property::texture_scale:
      return move_texture(channel, time_s, parts, moved);
    case Property::light_color:
    case Property::light_intensity:
    case Property::light_range:
    case Property::light_inner_cone:
    case Property::light_outer_cone:
      return move_light(channel, time_s, element_of(moved.lights, channel));
    default:
      return move_camera(channel, time_s, element_of(moved.cameras, channel));
  }
}

/// What single channels cannot know of each other.
void keep_in_order(Scene& moved) {
  for (Light& light : moved.lights)
    light.inner_cone_rad = std::min(light.inner_cone_rad, light.outer_cone_rad);
  for (Camera& camera : moved.cameras) {
    if (camera.far_plane != 0.0f) {
      camera.far_plane = std::max(camera.far_plane, camera.near_plane * 1.000001f + kSmallest);
    }
  }
}

}  // namespace

glm::mat3 texture_matrix(const glm::vec2& offset, double rotation_rad, const glm::vec2& scale) {
  const double angle = std::fmod(rotation_rad, 2.0 * kPi);
  const auto c = static_cast<float>(portable_cos(angle));
  const auto s = static_cast<float>(portable_sin(angle));
  return {glm::vec3(c * scale.x, -s * scale.x, 0), glm::vec3(s * scale.y, c * scale.y, 0),
          glm::vec3(offset.x, offset.y, 1)};
}

bool has_moving_properties(const Scene& scene) {
  return std::any_of(scene.animations.begin(), scene.animations.end(),
                     [](const Animation& animation) { return !animation.properties.empty(); });
}

Scene copy_without_pictures(const Scene& scene) {
  Scene copy;
  copy.source = scene.source;
  copy.textures = scene.textures;
  copy.materials = scene.materials;
  copy.variants = scene.variants;
  copy.meshes = scene.meshes;
  copy.nodes = scene.nodes;
  copy.cameras = scene.cameras;
  copy.lights = scene.lights;
  copy.skins = scene.skins;
  copy.animations = scene.animations;
  copy.scenes = scene.scenes;
  copy.default_scene = scene.default_scene;
  return copy;
}

void move_properties(const Scene& scene, int animation, double time_s, Scene& moved) {
  moved.materials = scene.materials;
  moved.lights = scene.lights;
  moved.cameras = scene.cameras;
  if (animation < 0 || static_cast<std::size_t>(animation) >= scene.animations.size()) return;
  PartsOfMaterials parts;
  for (const PropertyChannel& channel : scene.animations[static_cast<std::size_t>(animation)].properties) {
    move(channel, time_s, parts, moved);
  }
  keep_in_order(moved);
}

}  // namespace barrido::scene
