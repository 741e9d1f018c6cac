// extras.barrido of materials, lights and scenes.
#include "import_support.h"

namespace barrido::scene::test {
namespace {

Model with_extras(const json& material, const json& light, const json& scene) {
  Model model = triangle();
  model.document["materials"] = {{{"extras", {{"barrido", material}}}}};
  model.document["extensionsUsed"] = {"KHR_lights_punctual"};
  model.document["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "point"}, {"extras", {{"barrido", light}}}}};
  model.document["scenes"][0]["extras"]["barrido"] = scene;
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

}  // namespace
}  // namespace barrido::scene::test
