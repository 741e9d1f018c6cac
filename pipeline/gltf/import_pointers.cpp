// KHR_animation_pointer: which property of which object a channel moves. Pointers that lead to what is not
// drawn, or does not move here, are left out with a warning.
#include <algorithm>
#include <charconv>
#include <span>
#include <string_view>

#include "pipeline/gltf/import_pointers.h"
#include "pipeline/gltf/values.h"

namespace barrido::scene::gltf {
namespace {

using Property = PropertyChannel::Property;
using Path = AnimationChannel::Path;

/// Where objects stand that a pointer can lead into; '#' is their number.
struct Target {
  std::string_view pattern;
  Property property;
  int components;
  TextureUse Material::*use = nullptr;
};

constexpr std::string_view kTransform = "/extensions/KHR_texture_transform/";

constexpr Target kTargets[] = {
    {"/materials/#/pbrMetallicRoughness/baseColorFactor", Property::base_color, 4},
    {"/materials/#/pbrMetallicRoughness/metallicFactor", Property::metallic, 1},
    {"/materials/#/pbrMetallicRoughness/roughnessFactor", Property::roughness, 1},
    {"/materials/#/emissiveFactor", Property::emissive_factor, 3},
    {"/materials/#/extensions/KHR_materials_emissive_strength/emissiveStrength", Property::emissive_strength,
     1},
    {"/materials/#/alphaCutoff", Property::alpha_cutoff, 1},
    {"/extensions/KHR_lights_punctual/lights/#/color", Property::light_color, 3},
    {"/extensions/KHR_lights_punctual/lights/#/intensity", Property::light_intensity, 1},
    {"/extensions/KHR_lights_punctual/lights/#/range", Property::light_range, 1},
    {"/extensions/KHR_lights_punctual/lights/#/spot/innerConeAngle", Property::light_inner_cone, 1},
    {"/extensions/KHR_lights_punctual/lights/#/spot/outerConeAngle", Property::light_outer_cone, 1},
    {"/cameras/#/perspective/yfov", Property::camera_fov, 1},
    {"/cameras/#/perspective/znear", Property::camera_near, 1},
    {"/cameras/#/perspective/zfar", Property::camera_far, 1},
    {"/cameras/#/orthographic/xmag", Property::camera_half_width, 1},
    {"/cameras/#/orthographic/ymag", Property::camera_half_height, 1},
    {"/cameras/#/orthographic/znear", Property::camera_near, 1},
    {"/cameras/#/orthographic/zfar", Property::camera_far, 1},
};

struct TexturePlace {
  std::string_view pattern;
  TextureUse Material::*use;
};
constexpr TexturePlace kTextures[] = {
    {"/materials/#/pbrMetallicRoughness/baseColorTexture", &Material::base_color_texture},
    {"/materials/#/pbrMetallicRoughness/metallicRoughnessTexture", &Material::metallic_roughness_texture},
    {"/materials/#/normalTexture", &Material::normal_texture},
    {"/materials/#/occlusionTexture", &Material::occlusion_texture},
    {"/materials/#/emissiveTexture", &Material::emissive_texture},
};
struct TransformPart {
  std::string_view name;
  Property property;
  int components;
};
constexpr TransformPart kTransformParts[] = {{"offset", Property::texture_offset, 2},
                                             {"rotation", Property::texture_rotation, 1},
                                             {"scale", Property::texture_scale, 2}};

constexpr std::pair<std::string_view, Path> kNodePaths[] = {{"/nodes/#/translation", Path::translation},
                                                            {"/nodes/#/rotation", Path::rotation},
                                                            {"/nodes/#/scale", Path::scale},
                                                            {"/nodes/#/weights", Path::weights}};

/// What is left of `pointer` behind the pattern, whose '#' gives `index`.
std::optional<std::string_view> rest_after(std::string_view pointer, std::string_view pattern, int& index) {
  const std::size_t number = pattern.find('#');
  if (!pointer.starts_with(pattern.substr(0, number))) return std::nullopt;
  pointer.remove_prefix(number);
  const auto [end, error] = std::from_chars(pointer.data(), pointer.data() + pointer.size(), index);
  if (error != std::errc{} || pointer[0] == '-') return std::nullopt;
  pointer.remove_prefix(static_cast<std::size_t>(end - pointer.data()));
  if (!pointer.starts_with(pattern.substr(number + 1))) return std::nullopt;
  return pointer.substr(pattern.size() - number - 1);
}

std::optional<Target> find_target(std::string_view pointer, int& index) {
  for (const Target& target : kTargets) {
    if (const auto rest = rest_after(pointer, target.pattern, index); rest && rest->empty()) return target;
  }
  for (const TexturePlace& texture : kTextures) {
    const auto rest = rest_after(pointer, texture.pattern, index);
    if (!rest || !rest->starts_with(kTransform)) continue;
    for (const TransformPart& part : kTransformParts) {
      if (rest->substr(kTransform.size()) == part.name) {
        return Target{pointer, part.property, part.components, texture.use};
      }
    }
  }
  return std::nullopt;
}

bool is_of_light(Property property) {
  return property >= Property::light_color && property <= Property::light_outer_cone;
}
bool is_of_camera(Property property) { return property >= Property::camera_fov; }

std::size_t count_of(const Scene& scene, Property property) {
  return is_of_light(property)    ? scene.lights.size()
         : is_of_camera(property) ? scene.cameras.size()
                                  : scene.materials.size();
}

const tinygltf::ExtensionMap& extensions_of(const tinygltf::Material& source, TextureUse Material::*use) {
  const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
  return use == &Material::base_color_texture           ? pbr.baseColorTexture.extensions
         : use == &Material::metallic_roughness_texture ? pbr.metallicRoughnessTexture.extensions
         : use == &Material::normal_texture             ? source.normalTexture.extensions
         : use == &Material::occlusion_texture          ? source.occlusionTexture.extensions
                                                        : source.emissiveTexture.extensions;
}

/// PropertyChannel::rest of a material's property, from the file.
std::array<float, 5> rest_of(const tinygltf::Material& source, const Target& target) {
  const auto or_else = [](const tinygltf::Value& value, double otherwise) {
    return to_float(value.IsNumber() ? value.GetNumberAsDouble() : otherwise);
  };
  if (target.property == Property::emissive_factor || target.property == Property::emissive_strength) {
    const tinygltf::Value& strength =
        member(member(source.extensions, "KHR_materials_emissive_strength"), "emissiveStrength");
    const std::vector<double>& factor = source.emissiveFactor;
    return {to_float(factor[0]), to_float(factor[1]), to_float(factor[2]), or_else(strength, 1.0), 0.0f};
  }
  if (target.use == nullptr) return {};
  const tinygltf::Value& transform = member(extensions_of(source, target.use), "KHR_texture_transform");
  const tinygltf::Value& offset = member(transform, "offset");
  const tinygltf::Value& scale = member(transform, "scale");
  return {or_else(item(offset, 0), 0.0), or_else(item(offset, 1), 0.0),
          or_else(member(transform, "rotation"), 0.0), or_else(item(scale, 0), 1.0),
          or_else(item(scale, 1), 1.0)};
}

}  // namespace

std::optional<NodePointer> node_pointer(std::string_view pointer) {
  for (const auto& [pattern, path] : kNodePaths) {
    int node = kNone;
    if (const auto rest = rest_after(pointer, pattern, node); rest && rest->empty()) {
      return NodePointer{node, path};
    }
  }
  return std::nullopt;
}

std::optional<PropertyPointer> property_pointer(Import& import, std::string_view pointer) {
  int index = kNone;
  const std::optional<Target> target = find_target(pointer, index);
  if (!target) return std::nullopt;
  const std::size_t count = count_of(import.scene, target->property);
  if (static_cast<std::size_t>(index) >= count) {
    import.report.fail("animations: KHR_animation_pointer \"" + one_line(std::string(pointer), 80) + '"',
                       "there are " + std::to_string(count));
  }
  PropertyPointer found;
  found.channel.property = target->property;
  found.channel.index = index;
  found.channel.use = target->use;
  found.components = target->components;
  if (!is_of_light(target->property) && !is_of_camera(target->property)) {
    found.channel.rest = rest_of(import.document.model().materials[static_cast<std::size_t>(index)], *target);
  }
  return found;
}

}  // namespace barrido::scene::gltf
