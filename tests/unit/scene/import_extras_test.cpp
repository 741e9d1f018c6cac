// extras.barrido of materials, lights and scenes; and that its JSON schema in docs/ says what the table says.
#include <fstream>
#include <set>

#include "import_support.h"
#include "pipeline/gltf/schema.h"

namespace barrido::scene::test {
namespace {

const char* const kPicture =
    "data:image/"
    "png;base64,iVBORw0KGgoAAAANSUhEUgAAAAQAAAAECAIAAAAmkwkpAAAAEElEQVR42mM4ESACRwzEcQDzAxLBrjWe+gAAAABJRU5E"
    "rkJggg==";

Model with_extras(const json& material, const json& light, const json& scene) {
  Model model = triangle();
  model.document["materials"] = {{{"extras", {{"barrido", material}}}}};
  model.document["meshes"][0]["primitives"][0]["material"] = 0;
  model.document["extensionsUsed"] = {"KHR_lights_punctual"};
  model.document["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "point"}, {"extras", {{"barrido", light}}}}};
  model.document["scenes"][0]["extras"]["barrido"] = scene;
  model.document["images"] = {{{"uri", kPicture}}};
  model.document["textures"] = {{{"source", 0}}, {{"source", 0}}};
  return model;
}

const json kNothing = json::object();

TEST(ImportExtras, Material) {
  const Scene scene = with_extras({{"ambient", {0.1, 0.2, 0.3}},
                                   {"diffuse", {0.5, 0.5, 0}},
                                   {"specular", {1, 1, 2}},
                                   {"emission", {0, 0, 0.25}},
                                   {"shininess", 200}},
                                  kNothing, kNothing)
                          .import();
  const ExactMaterial& exact = scene.materials[0].exact;
  EXPECT_EQ(exact.ambient, glm::vec3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(exact.diffuse, glm::vec3(0.5f, 0.5f, 0));
  EXPECT_EQ(exact.specular, glm::vec3(1, 1, 2));
  EXPECT_EQ(exact.emission, glm::vec3(0, 0, 0.25f));
  EXPECT_EQ(exact.shininess, 200.0f);
}

TEST(ImportExtras, WhatIsAbsentStaysEmpty) {
  const Scene scene = with_extras(kNothing, kNothing, kNothing).import();
  EXPECT_FALSE(scene.materials[0].exact.diffuse);
  EXPECT_FALSE(scene.lights[0].exact_intensity);
  EXPECT_FALSE(scene.lights[0].attenuation);
  EXPECT_FALSE(scene.scenes[0].settings.fog);
}

TEST(ImportExtras, TextureMappingAndTiles) {
  const Scene scene = with_extras({{"texture",
                                    {{"procedure", "noise"},
                                     {"scale", 0.5},
                                     {"axis", {1, 0, 0}},
                                     {"space", "world"},
                                     {"dark", {0.1, 0.2, 0.3}},
                                     {"light", {0.5, 0.5, 0.5, 0.25}},
                                     {"octaves", 3},
                                     {"gain", 0.25},
                                     {"threshold", 0.5}}},
                                   {"mapping",
                                    {{"surface", "box"},
                                     {"from", "reflection"},
                                     {"at", "vertices"},
                                     {"axis", {0, 0, 1}},
                                     {"centre", {1, 2, 3}},
                                     {"size", 4},
                                     {"repeats", {2, -1}},
                                     {"offset", {0.5, 0.25}}}},
                                   {"tiles", "both"}},
                                  kNothing, kNothing)
                          .import();
  const TextureChoice& choice = scene.materials[0].texture;
  ASSERT_TRUE(choice.solid && choice.mapping);
  SolidTexture solid = standard_solid(raster::PatternKind::noise);
  solid.pattern.octaves = 3;
  solid.pattern.gain = 0.25f;
  solid.pattern.has_threshold = true;
  solid.pattern.threshold = 0.5f;
  solid.pattern.colors = {{{0.1f, 0.2f, 0.3f, 1}, {0.5f, 0.5f, 0.5f, 0.25f}}};
  solid.space = SolidTexture::Space::world;
  solid.scale = 0.5f;
  solid.axis = {1, 0, 0};
  EXPECT_EQ(*choice.solid, solid);
  MappingChoice mapping;
  mapping.surface = raster::MappingSurface::box;
  mapping.ray = raster::MappingRay::reflection;
  mapping.at_vertices = true;
  mapping.axis = {0, 0, 1};
  mapping.centre = glm::vec3(1, 2, 3);
  mapping.size = 4;
  mapping.repeats = {2, -1};
  mapping.offset = {0.5f, 0.25f};
  EXPECT_EQ(*choice.mapping, mapping);
  EXPECT_EQ(choice.tiles, raster::TileChange::both);
  EXPECT_TRUE(scene.warnings.empty());
}

TEST(ImportExtras, TexturesThatCannotBeAreRefused) {
  const auto refused = [](const json& material) {
    EXPECT_THROW(with_extras(material, kNothing, kNothing).import(), InputError) << material;
  };
  refused({{"texture", {{"procedure", "marbel"}}}});
  refused({{"texture", {{"scale", 1}}}});
  refused({{"texture", {{"procedure", "marble"}, {"scale", 0}}}});
  refused({{"texture", {{"procedure", "marble"}, {"axis", {0, 0, 0}}}}});
  refused({{"texture", {{"procedure", "noise"}, {"octaves", 17}}}});
  refused({{"mapping", {{"surface", "spere"}}}});
  refused({{"mapping", {{"surface", "sphere"}, {"repeats", {0, 1}}}}});
  refused({{"mapping", {{"surface", "sphere"}, {"size", 0}}}});
  refused({{"tiles", "some"}});
}

TEST(ImportExtras, LightMayBeNegative) {
  const Scene scene =
      with_extras(kNothing, {{"intensity", -0.5}, {"attenuation", {1, 0.5, 0.25}}, {"spotExponent", 8}},
                  kNothing)
          .import();
  EXPECT_EQ(scene.lights[0].exact_intensity, -0.5f);
  EXPECT_EQ(scene.lights[0].attenuation, (std::array<float, 3>{1, 0.5f, 0.25f}));
  EXPECT_EQ(scene.lights[0].spot_exponent, 8.0f);
  EXPECT_TRUE(scene.warnings.empty());
}

TEST(ImportExtras, Scene) {
  const json fog = {{"mode", "linear"}, {"start", 2}, {"end", 10}, {"color", {0.5, 0.6, 0.7}}};
  const Scene scene =
      with_extras(kNothing, kNothing, {{"ambient", {0.2, 0.2, 0.2}}, {"background", {0, 0, 1}}, {"fog", fog}})
          .import();
  const SceneSettings& settings = scene.scenes[0].settings;
  EXPECT_EQ(settings.ambient, glm::vec3(0.2f, 0.2f, 0.2f));
  EXPECT_EQ(settings.background, glm::vec4(0, 0, 1, 1));
  ASSERT_TRUE(settings.fog);
  EXPECT_TRUE(settings.fog->enabled);
  EXPECT_EQ(settings.fog->mode, raster::FogMode::linear);
  EXPECT_EQ(settings.fog->start, 2.0f);
  EXPECT_EQ(settings.fog->end, 10.0f);
  EXPECT_EQ(settings.fog->color, (std::array<float, 4>{0.5f, 0.6f, 0.7f, 1}));
}

TEST(ImportExtras, FogModesAndDefaults) {
  const auto fog = [](const json& text) {
    return *with_extras(kNothing, kNothing, {{"fog", text}}).import().scenes[0].settings.fog;
  };
  EXPECT_EQ(fog({{"mode", "exp"}}).mode, raster::FogMode::exp);
  EXPECT_EQ(fog({{"mode", "exp2"}, {"density", 0.25}}).mode, raster::FogMode::exp2);
  EXPECT_EQ(fog({{"mode", "exp2"}, {"density", 0.25}}).density, 0.25f);
  EXPECT_EQ(fog({{"mode", "exp"}}).density, 1.0f);
  EXPECT_EQ(fog({{"mode", "exp"}}).end, 1.0f);
}

TEST(ImportExtras, WrongValuesAreErrorsWithTheirPlace) {
  EXPECT_CONTAINS(import_error(with_extras({{"diffuse", {1, 1}}}, kNothing, kNothing)),
                  "materials[0].extras.barrido.diffuse: must have 3 elements, not 2");
  EXPECT_CONTAINS(import_error(with_extras({{"specular", {1, -1, 0}}}, kNothing, kNothing)),
                  "materials[0].extras.barrido.specular[1]: is -1");
  EXPECT_CONTAINS(import_error(with_extras(json::array(), kNothing, kNothing)),
                  "extras.barrido: must be an object");
  EXPECT_CONTAINS(import_error(with_extras(kNothing, {{"intensity", "strong"}}, kNothing)),
                  "extensions.KHR_lights_punctual.lights[0].extras.barrido.intensity: must be a number");
  EXPECT_CONTAINS(import_error(with_extras(kNothing, {{"attenuation", {0, 0, 0}}}, kNothing)),
                  "attenuation: at least one of the three");
  EXPECT_CONTAINS(import_error(with_extras(kNothing, kNothing, {{"fog", {{"mode", "thick"}}}})),
                  "scenes[0].extras.barrido.fog.mode: is \"thick\"; known are linear, exp, exp2");
  EXPECT_CONTAINS(import_error(with_extras(kNothing, kNothing, {{"fog", kNothing}})), "\"mode\" is missing");
}

TEST(ImportExtras, UnknownPropertiesAreWarnings) {
  const Scene scene = with_extras({{"shinyness", 3}}, kNothing, kNothing).import();
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_CONTAINS(scene.warnings[0], "materials[0].extras.barrido.shinyness: there is no such property");
}

TEST(ImportExtras, ExtrasOfOthersMayBeAnything) {
  Model model = triangle();
  model.document["materials"] = {{{"extras", 7}}, {{"extras", {{"other", {{"diffuse", "red"}}}}}}};
  model.document["scenes"][0]["extras"] = json::array({1, 2});
  EXPECT_TRUE(model.import().warnings.empty());
}

const gltf::Schema& schema_at(const gltf::Schema& schema, std::string_view name) {
  for (const gltf::Property& property : schema.properties) {
    if (property.name == name) return *property.schema;
  }
  throw std::out_of_range(std::string(name));
}

const gltf::Schema& barrido_of_materials() {
  return *schema_at(gltf::document_schema(), "materials").barrido;
}
const gltf::Schema& barrido_of_lights() {
  const auto* lights = gltf::find_extension_object("KHR_lights_punctual", gltf::ObjectType::document);
  return *schema_at(*lights->schema, "lights").barrido;
}
const gltf::Schema& barrido_of_scenes() { return *schema_at(gltf::document_schema(), "scenes").barrido; }

/// What JSON Schema says where the table has that row.
json written_form(const gltf::Property& row);

json written_form(const gltf::Schema& table) {
  json form = {{"type", "object"}, {"properties", json::object()}, {"additionalProperties", !table.closed}};
  for (const gltf::Property& row : table.properties) {
    form["properties"][std::string(row.name)] = written_form(row);
    if (row.required) form["required"].push_back(row.name);
  }
  return form;
}

json written_form(const gltf::Property& row) {
  json number = {{"type", "number"}};
  if (row.range.min != gltf::Range{}.min) {
    number[row.above_min ? "exclusiveMinimum" : "minimum"] = row.range.min;
  }
  if (row.range.max != gltf::Range{}.max) number["maximum"] = row.range.max;
  switch (row.kind) {
    case gltf::Kind::integer:
      number["type"] = "integer";
      return number;
    case gltf::Kind::number:
      return number;
    case gltf::Kind::numbers:
      return {{"type", "array"}, {"items", number}, {"minItems", row.min_items}, {"maxItems", row.max_items}};
    case gltf::Kind::text: {
      json choices = json::array();
      std::istringstream words{std::string(row.choices)};
      for (std::string word; std::getline(words, word, '|');) choices.push_back(word);
      return {{"enum", choices}};
    }
    case gltf::Kind::index:
      return {{"type", "integer"}, {"minimum", 0}};
    case gltf::Kind::object:
      return written_form(*row.schema);
    default:
      return "a kind that extras.barrido does not have";
  }
}

/// A part of a JSON schema with its references put in, without what only people read.
json plain(const json& schema, const json& definitions) {
  if (!schema.is_object()) return schema;
  json form = json::object();
  for (const auto& [name, value] : schema.items()) {
    if (name == "$ref") {
      const auto target = value.get<std::string>().substr(std::string("#/$defs/").size());
      form.update(plain(definitions.at(target), definitions));
    } else if (name == "properties") {
      for (const auto& [property, part] : value.items()) form[name][property] = plain(part, definitions);
    } else if (name != "title" && name != "description" && name != "default" && name != "contains") {
      form[name] = plain(value, definitions);
    }
  }
  return form;
}

TEST(ImportExtras, JsonSchemaSaysWhatTheTableSays) {
  std::ifstream file(std::string(BARRIDO_SOURCE_DIR) + "/docs/barrido-extras.schema.json");
  const json schema = json::parse(file), &definitions = schema.at("$defs");
  EXPECT_EQ(plain(definitions.at("material"), definitions), written_form(barrido_of_materials()));
  EXPECT_EQ(plain(definitions.at("light"), definitions), written_form(barrido_of_lights()));
  EXPECT_EQ(plain(definitions.at("scene"), definitions), written_form(barrido_of_scenes()));
}

/// A value that the row allows, and that no default is.
json sample(const gltf::Property& row) {
  constexpr double kNumber = 0.625;
  if (row.kind == gltf::Kind::numbers) return std::vector<double>(row.min_items, kNumber);
  if (row.kind == gltf::Kind::number) return kNumber;
  if (row.kind == gltf::Kind::text) return std::string(row.choices.substr(row.choices.rfind('|') + 1));
  if (row.name == "texture") return {{"procedure", "marble"}};
  if (row.name == "mapping") return {{"surface", "box"}};
  if (row.name == "displacement") return {{"scale", 0.25}};
  if (row.name == "texCoord") return 1;
  if (row.kind == gltf::Kind::integer) return 3;
  if (row.kind == gltf::Kind::index) return 1;
  return row.name == "fog" ? json{{"mode", "linear"}} : json{{"index", 0}};
}

/// Everything that extras.barrido can set, as text.
std::string settings_of(const Scene& scene) {
  std::ostringstream text;
  const auto put = [&](const auto& value) { text << (value ? (*value)[0] : -1.0f) << ' '; };
  const ExactMaterial& material = scene.materials[0].exact;
  for (const auto* color : {&material.ambient, &material.diffuse, &material.specular, &material.emission}) {
    put(*color);
  }
  const Material& maps = scene.materials[0];
  for (const TextureUse* use : {&maps.bump.texture, &maps.transparency_texture, &maps.specularity_texture}) {
    text << use->texture << ' ' << use->texcoord_set << ' ';
  }
  text << maps.bump.height << ' ' << static_cast<int>(maps.bump.form) << ' ';
  if (const MaterialDisplacement* moves = maps.displacement.get()) {
    text << moves->texture.texture << ' ' << moves->by.scale << ' ' << moves->by.bias << ' '
         << moves->by.pieces << ' ';
  }
  const Light& light = scene.lights[0];
  const SceneSettings& settings = scene.scenes[0].settings;
  put(light.attenuation);
  put(settings.ambient);
  put(settings.background);
  for (const auto& number : {material.shininess, light.exact_intensity, light.spot_exponent}) {
    text << number.value_or(-1) << ' ';
  }
  const TextureChoice& texture = scene.materials[0].texture;
  if (texture.tiles) text << "tiles " << static_cast<int>(*texture.tiles) << ' ';
  if (texture.solid) {
    const SolidTexture& solid = *texture.solid;
    const raster::Pattern& pattern = solid.pattern;
    text << static_cast<int>(pattern.kind) << ' ' << static_cast<int>(solid.space) << ' ' << solid.scale
         << ' ' << solid.axis.x << ' ' << pattern.octaves << ' ' << pattern.gain << ' ' << pattern.turbulence
         << ' ' << pattern.has_threshold << ' ' << pattern.colors[0][0] << ' ' << pattern.colors[1][0] << ' ';
  }
  if (texture.mapping) {
    const MappingChoice& mapping = *texture.mapping;
    text << static_cast<int>(mapping.surface) << ' ' << static_cast<int>(mapping.ray) << ' '
         << mapping.at_vertices << ' ' << mapping.axis.x << ' ' << mapping.centre.has_value() << ' '
         << mapping.size << ' ' << mapping.repeats.x << ' ' << mapping.offset.x;
  }
  if (settings.fog) {
    text << static_cast<int>(settings.fog->mode) << ' ' << settings.fog->density << ' ' << settings.fog->start
         << ' ' << settings.fog->end << ' ' << settings.fog->color[0];
  }
  return text.str();
}

TEST(ImportExtras, EveryRowOfTheTableIsRead) {
  const auto expect_read = [](const gltf::Schema& table, const json& base, const auto& model_with) {
    for (const gltf::Property& row : table.properties) {
      json changed = base;
      changed[std::string(row.name)] = sample(row);
      const Scene with = model_with(changed).import(), without = model_with(base).import();
      EXPECT_NE(settings_of(with), settings_of(without)) << row.name;
      EXPECT_TRUE(with.warnings.empty());
    }
  };
  expect_read(barrido_of_materials(), kNothing,
              [](const json& value) { return with_extras(value, kNothing, kNothing); });
  for (const char* name : {"bump", "transparencyTexture", "specularityTexture"}) {
    expect_read(schema_at(barrido_of_materials(), name), {{"index", 0}}, [&](const json& value) {
      return with_extras({{name, value}}, kNothing, kNothing);
    });
  }
  expect_read(barrido_of_lights(), kNothing,
              [](const json& value) { return with_extras(kNothing, value, kNothing); });
  expect_read(barrido_of_scenes(), kNothing,
              [](const json& value) { return with_extras(kNothing, kNothing, value); });
  expect_read(schema_at(barrido_of_materials(), "texture"), {{"procedure", "noise"}}, [](const json& value) {
    return with_extras({{"texture", value}}, kNothing, kNothing);
  });
  expect_read(schema_at(barrido_of_materials(), "mapping"), {{"surface", "sphere"}}, [](const json& value) {
    return with_extras({{"mapping", value}}, kNothing, kNothing);
  });
  expect_read(schema_at(barrido_of_scenes(), "fog"), {{"mode", "linear"}}, [](const json& value) {
    return with_extras(kNothing, kNothing, {{"fog", value}});
  });
}

}  // namespace
}  // namespace barrido::scene::test
