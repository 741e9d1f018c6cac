// extras.barrido: exact fixed-function values beside glTF's own (docs/barrido-extras.schema.json). Types,
// ranges and counts were checked with the rest of the document.
#include <nlohmann/json.hpp>

#include "pipeline/gltf/import_parts.h"
#include "pipeline/scene/names.h"

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

template <class Value>
Value value_of(const json& from, const char* name, Value otherwise) {
  const auto value = from.find(name);
  return value == from.end() ? otherwise : value_named<Value>(value->get<std::string>()).value_or(otherwise);
}

/// A direction that may not be 0.
void read_axis(const Report& report, const json& from, const std::string& place, glm::vec3& axis) {
  std::optional<glm::vec3> given;
  read(from, "axis", given);
  if (given && *given == glm::vec3(0.0f)) report.fail(place + ".axis", "must not be 0, 0, 0");
  axis = given.value_or(axis);
}

SolidTexture solid_of(const Report& report, const json& from, const std::string& place) {
  SolidTexture solid = standard_solid(value_of(from, "procedure", raster::PatternKind::checker));
  raster::Pattern& pattern = solid.pattern;
  solid.scale = to_float(from.value("scale", double{solid.scale}));
  solid.space = value_of(from, "space", solid.space);
  read_axis(report, from, place, solid.axis);
  pattern.octaves = static_cast<int>(from.value("octaves", double{static_cast<double>(pattern.octaves)}));
  pattern.gain = to_float(from.value("gain", double{pattern.gain}));
  pattern.turbulence = to_float(from.value("turbulence", double{pattern.turbulence}));
  pattern.has_threshold = from.contains("threshold");
  pattern.threshold = to_float(from.value("threshold", 0.0));
  for (const std::size_t which : {0, 1}) {
    std::optional<glm::vec4> color;
    read(from, which == 0 ? "dark" : "light", color);
    if (color) pattern.colors[which] = {color->r, color->g, color->b, color->a};
  }
  return solid;
}

void read_pair(const json& from, const char* name, glm::vec2& to) {
  const auto value = from.find(name);
  if (value != from.end()) to = {float_at(*value, 0), float_at(*value, 1)};
}

MappingChoice mapping_of(const Report& report, const json& from, const std::string& place) {
  MappingChoice mapping;
  mapping.surface = value_of(from, "surface", raster::MappingSurface::sphere);
  mapping.ray = value_of(from, "from", mapping.ray);
  mapping.at_vertices = from.value("at", std::string("fragments")) == "vertices";
  read_axis(report, from, place, mapping.axis);
  read(from, "centre", mapping.centre);
  mapping.size = to_float(from.value("size", double{mapping.size}));
  read_pair(from, "repeats", mapping.repeats);
  read_pair(from, "offset", mapping.offset);
  if (mapping.repeats.x == 0.0f || mapping.repeats.y == 0.0f) {
    report.fail(place + ".repeats", "neither of the two may be 0");
  }
  return mapping;
}

void read_textures(const Report& report, const json& from, const std::string& place, TextureChoice& choice) {
  if (const auto texture = from.find("texture"); texture != from.end()) {
    choice.solid = solid_of(report, *texture, place + ".extras.barrido.texture");
  }
  if (const auto mapping = from.find("mapping"); mapping != from.end()) {
    choice.mapping = mapping_of(report, *mapping, place + ".extras.barrido.mapping");
  }
  if (from.contains("tiles")) choice.tiles = value_of(from, "tiles", raster::TileChange::none);
}

/// Heights from a picture, or 1 everywhere.
void read_displacement(Import& import, const json& from, Material& material) {
  const auto found = from.find("displacement");
  if (found == from.end()) return;
  MaterialDisplacement displacement;
  displacement.by.scale = to_float(found->value("scale", double{displacement.by.scale}));
  displacement.by.bias = to_float(found->value("bias", double{displacement.by.bias}));
  displacement.by.pieces = found->value("pieces", displacement.by.pieces);
  if (const auto texture = found->find("texture"); texture != found->end()) {
    displacement.texture =
        texture_use(import, texture->value("index", kNone), texture->value("texCoord", 0), {});
    if (displacement.texture.texture == kNone) return;
  }
  material.displacement = std::make_shared<const MaterialDisplacement>(displacement);
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
    read_textures(import.report, barrido, element("materials", i), import.scene.materials[i].texture);
    read_displacement(import, barrido, import.scene.materials[i]);
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
