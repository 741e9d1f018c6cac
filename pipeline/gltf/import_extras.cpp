// extras.barrido: exact fixed-function values beside glTF's own (docs/barrido-extras.schema.json). Types,
// ranges and counts were checked with the rest of the document.
#include <nlohmann/json.hpp>

#include "pipeline/gltf/import_parts.h"
#include "raster/names.h"

namespace barrido::scene::gltf {
namespace {

using nlohmann::json;

/// extras.barrido of an object; null where it has none.
const json* barrido_of(const json& object) {
  const auto extras = object.find("extras");
  if (extras == object.end() || !extras->is_object()) return nullptr;
  const auto barrido = extras->find("barrido");
  return barrido == extras->end() ? nullptr : &*barrido;
}

float float_at(const json& array, std::size_t index) { return to_float(array[index].get<double>()); }

void read(const json& from, const char* name, std::optional<glm::vec3>& to) {
  const auto value = from.find(name);
  if (value != from.end()) to = glm::vec3(float_at(*value, 0), float_at(*value, 1), float_at(*value, 2));
}

/// Three numbers, or four with alpha.
void read(const json& from, const char* name, std::optional<glm::vec4>& to) {
  const auto value = from.find(name);
  if (value == from.end()) return;
  const float alpha = value->size() > 3 ? float_at(*value, 3) : 1.0f;
  to = glm::vec4(float_at(*value, 0), float_at(*value, 1), float_at(*value, 2), alpha);
}

void read(const json& from, const char* name, std::optional<float>& to) {
  const auto value = from.find(name);
  if (value != from.end()) to = to_float(value->get<double>());
}

void read(const json& from, const char* name, std::optional<std::array<float, 3>>& to) {
  const auto value = from.find(name);
  if (value != from.end()) to = {float_at(*value, 0), float_at(*value, 1), float_at(*value, 2)};
}

void read_material(const json& from, ExactMaterial& exact) {
  read(from, "ambient", exact.ambient);
  read(from, "diffuse", exact.diffuse);
  read(from, "specular", exact.specular);
  read(from, "emission", exact.emission);
  read(from, "shininess", exact.shininess);
}

/// A texture that the extras name.
TextureUse texture_of(Import& import, const json& from) {
  return texture_use(import, from["index"].get<int>(), from.value("texCoord", 0), {});
}

void read_maps(Import& import, const json& from, Material& material) {
  if (const auto bump = from.find("bump"); bump != from.end()) {
    material.bump.texture = texture_of(import, *bump);
    material.bump.height = to_float(bump->value("height", double{material.bump.height}));
    const std::string form = bump->value("form", std::string(name_of(material.bump.form)));
    material.bump.form = value_named<raster::BumpForm>(form).value_or(material.bump.form);
  }
  const auto read_map = [&](const char* name, TextureUse& to) {
    if (const auto map = from.find(name); map != from.end()) to = texture_of(import, *map);
  };
  read_map("transparencyTexture", material.transparency_texture);
  read_map("specularityTexture", material.specularity_texture);
}

void read_light(const Report& report, const json& from, const std::string& place, Light& light) {
  read(from, "intensity", light.exact_intensity);
  read(from, "attenuation", light.attenuation);
  read(from, "spotExponent", light.spot_exponent);
  if (light.attenuation && *light.attenuation == std::array<float, 3>{0, 0, 0}) {
    report.fail(place + ".extras.barrido.attenuation", "at least one of the three must be greater than 0");
  }
}

raster::FogState fog_of(const json& from) {
  raster::FogState fog;
  fog.enabled = true;
  fog.mode = value_named<raster::FogMode>(from["mode"].get<std::string>()).value_or(raster::FogMode::exp);
  fog.density = to_float(from.value("density", double{fog.density}));
  fog.start = to_float(from.value("start", double{fog.start}));
  fog.end = to_float(from.value("end", double{fog.end}));
  std::optional<glm::vec4> color;
  read(from, "color", color);
  if (color) fog.color = {color->r, color->g, color->b, color->a};
  return fog;
}

void read_scene(const json& from, SceneSettings& settings) {
  read(from, "ambient", settings.ambient);
  read(from, "background", settings.background);
  if (const auto fog = from.find("fog"); fog != from.end()) settings.fog = fog_of(*fog);
}

/// Calls visit(extras.barrido, index) for the elements of an array that have it.
template <typename Visit>
void for_each_barrido(const json& array, Visit visit) {
  for (std::size_t i = 0; i < array.size(); ++i) {
    if (const json* barrido = barrido_of(array[i])) visit(*barrido, i);
  }
}

}  // namespace

void import_material_extras(Import& import) {
  const json& document = import.document.tree();
  static const json::json_pointer kMaterials("/materials");
  if (!document.contains(kMaterials)) return;
  for_each_barrido(document[kMaterials], [&](const json& barrido, std::size_t i) {
    read_material(barrido, import.scene.materials[i].exact);
    read_maps(import, barrido, import.scene.materials[i]);
  });
}

void import_extras(Import& import) {
  const json& document = import.document.tree();
  Scene& scene = import.scene;
  static const json::json_pointer kScenes("/scenes");
  static const json::json_pointer kLights("/extensions/KHR_lights_punctual/lights");
  if (document.contains(kScenes)) {
    for_each_barrido(document[kScenes], [&](const json& barrido, std::size_t i) {
      read_scene(barrido, scene.scenes[i].settings);
    });
  }
  if (document.contains(kLights)) {
    for_each_barrido(document[kLights], [&](const json& barrido, std::size_t i) {
      read_light(import.report, barrido, element("extensions.KHR_lights_punctual.lights", i),
                 scene.lights[i]);
    });
  }
}

}  // namespace barrido::scene::gltf
