// What extensions add to materials, as it stands (KHR_materials_specular, _ior, _transmission …). A property
// of the wrong type counts as one that is not there.
#include <algorithm>
#include <iterator>

#include <glm/common.hpp>

#include "pipeline/gltf/import_parts.h"
#include "pipeline/gltf/values.h"

namespace barrido::scene::gltf {
namespace {

/// The properties of one extension's object.
class Properties {
 public:
  Properties(Import& import, const tinygltf::Value& object, std::string place)
      : import_(import), object_(object), place_(std::move(place)) {}

  /// At least 0, as all of these properties are.
  float number(const char* name, float otherwise) const {
    const tinygltf::Value& value = member(object_, name);
    return value.IsNumber() ? std::max(to_float(value.GetNumberAsDouble()), 0.0f) : otherwise;
  }
  float fraction(const char* name, float otherwise) const { return std::min(number(name, otherwise), 1.0f); }

  glm::vec3 color(const char* name, glm::vec3 otherwise) const {
    const tinygltf::Value& value = member(object_, name);
    if (!value.IsArray() || value.ArrayLen() < 3) return otherwise;
    glm::vec3 color;
    for (int c = 0; c < 3; ++c) {
      color[c] = std::max(to_float(gltf::number(item(value, static_cast<std::size_t>(c)))), 0.0f);
    }
    return color;
  }
  float alpha(const char* name) const {
    const tinygltf::Value& value = member(object_, name);
    if (!value.IsArray() || value.ArrayLen() < 4) return 1.0f;
    return std::clamp(to_float(gltf::number(item(value, 3))), 0.0f, 1.0f);
  }

  TextureUse texture(const char* name) const {
    const tinygltf::Value& value = member(object_, name);
    if (!member(value, "index").IsNumber()) return {};
    const int index = whole_number(member(value, "index"));
    const std::size_t textures = import_.scene.textures.size();
    if (index < 0 || static_cast<std::size_t>(index) >= textures) {
      import_.report.fail(place_ + '.' + name,
                          "must be the number of a texture, and there are " + std::to_string(textures));
    }
    tinygltf::ExtensionMap extensions;
    const tinygltf::Value& transform = member(member(value, "extensions"), "KHR_texture_transform");
    if (transform.IsObject()) extensions["KHR_texture_transform"] = transform;
    return texture_use(import_, index, std::max(whole_number(member(value, "texCoord")), 0), extensions);
  }

 private:
  Import& import_;
  const tinygltf::Value& object_;
  std::string place_;
};

constexpr const char* kSpecularGlossiness = "KHR_materials_pbrSpecularGlossiness";

using Read = void (*)(const Properties& from, MaterialLayers& to);
struct Extension {
  const char* name;
  Read read;
};

constexpr Extension kExtensions[] = {
    {kSpecularGlossiness,
     [](const Properties& from, MaterialLayers& to) {
       to.specular_glossiness = {from.color("specularFactor", glm::vec3(1.0f)),
                                 from.fraction("glossinessFactor", 1.0f),
                                 from.texture("specularGlossinessTexture")};
     }},
    {"KHR_materials_ior",
     [](const Properties& from, MaterialLayers& to) { to.ior = from.number("ior", to.ior); }},
    {"KHR_materials_specular",
     [](const Properties& from, MaterialLayers& to) {
       to.specular = from.fraction("specularFactor", to.specular);
       to.specular_color = from.color("specularColorFactor", to.specular_color);
       to.specular_texture = from.texture("specularTexture");
       to.specular_color_texture = from.texture("specularColorTexture");
     }},
    {"KHR_materials_sheen",
     [](const Properties& from, MaterialLayers& to) {
       to.sheen_color = from.color("sheenColorFactor", to.sheen_color);
       to.sheen_color_texture = from.texture("sheenColorTexture");
     }},
    {"KHR_materials_clearcoat",
     [](const Properties& from, MaterialLayers& to) {
       to.clearcoat = from.fraction("clearcoatFactor", to.clearcoat);
       to.clearcoat_roughness = from.fraction("clearcoatRoughnessFactor", to.clearcoat_roughness);
       to.clearcoat_texture = from.texture("clearcoatTexture");
       to.clearcoat_roughness_texture = from.texture("clearcoatRoughnessTexture");
     }},
    {"KHR_materials_iridescence",
     [](const Properties& from, MaterialLayers& to) {
       to.iridescence = from.fraction("iridescenceFactor", to.iridescence);
       to.iridescence_ior = from.number("iridescenceIor", to.iridescence_ior);
       to.iridescence_thickness_nm = from.number("iridescenceThicknessMaximum", to.iridescence_thickness_nm);
       to.iridescence_texture = from.texture("iridescenceTexture");
     }},
    {"KHR_materials_anisotropy",
     [](const Properties& from, MaterialLayers& to) {
       to.anisotropy = from.fraction("anisotropyStrength", to.anisotropy);
     }},
    {"KHR_materials_transmission",
     [](const Properties& from, MaterialLayers& to) {
       to.transmission = from.fraction("transmissionFactor", to.transmission);
       to.transmission_texture = from.texture("transmissionTexture");
     }},
    {"KHR_materials_volume",
     [](const Properties& from, MaterialLayers& to) {
       to.thickness = from.number("thicknessFactor", to.thickness);
       to.thickness_texture = from.texture("thicknessTexture");
       to.attenuation_distance = from.number("attenuationDistance", to.attenuation_distance);
       to.attenuation_color = from.color("attenuationColor", to.attenuation_color);
     }},
};

std::string place_of(const std::string& material, const char* extension) {
  return material + ".extensions." + extension;
}

}  // namespace

std::shared_ptr<const MaterialLayers> layers_of(Import& import, const tinygltf::Material& source,
                                                const std::string& place) {
  std::shared_ptr<MaterialLayers> layers;
  for (const Extension& extension : kExtensions) {
    const auto found = source.extensions.find(extension.name);
    if (found == source.extensions.end()) continue;
    if (!layers) layers = std::make_shared<MaterialLayers>();
    extension.read(Properties(import, found->second, place_of(place, extension.name)), *layers);
  }
  return layers;
}

void use_specular_glossiness(Import& import, const tinygltf::Material& source, const std::string& place,
                             Material& material) {
  const Properties from(import, source.extensions.at(kSpecularGlossiness),
                        place_of(place, kSpecularGlossiness));
  const glm::vec3 diffuse = glm::min(from.color("diffuseFactor", glm::vec3(1.0f)), glm::vec3(1.0f));
  material.base_color = glm::vec4(diffuse, from.alpha("diffuseFactor"));
  material.base_color_texture = from.texture("diffuseTexture");
  material.metallic = 0.0f;
  material.roughness = 1.0f - material.layers->specular_glossiness->glossiness;
  material.metallic_roughness_texture = {};
}

}  // namespace barrido::scene::gltf
