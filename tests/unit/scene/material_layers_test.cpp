// What extensions add to materials, as coefficients and as pixels.
#include <cmath>

#include <gtest/gtest.h>

#include "pipeline/scene/material_conversion.h"
#include "tests/unit/scene/frame_fixture.h"

namespace barrido::scene {
namespace {

using testing::middle;
using testing::Pixel;

Material dielectric(const MaterialLayers& layers, const glm::vec3& color = glm::vec3(1.0f)) {
  Material material = testing::matte(color);
  material.layers = std::make_shared<const MaterialLayers>(layers);
  return material;
}

SurfaceCoefficients converted(const Material& material) {
  return convert_material(material, {}, Reflections::none, {});
}

TEST(MaterialLayers, ThatChangeNothingChangeNothing) {
  Material plain = testing::matte({0.7f, 0.2f, 0.4f});
  plain.roughness = 0.3f;
  Material layered = plain;
  layered.layers = std::make_shared<const MaterialLayers>();
  const SurfaceCoefficients a = converted(plain), b = converted(layered);
  EXPECT_EQ(a.diffuse, b.diffuse);
  EXPECT_EQ(a.specular, b.specular);
  EXPECT_EQ(a.shininess, b.shininess);
}

TEST(MaterialLayers, SpecularGlossinessIsAlmostFixedFunction) {
  MaterialLayers layers;
  layers.specular_glossiness = SpecularGlossiness{{0.2f, 0.1f, 0.5f}, 0.5f, {}};
  Material material = dielectric(layers, {0.8f, 0.6f, 0.4f});
  material.roughness = 0.5f;
  const SurfaceCoefficients surface = converted(material);
  const float wide = 0.0625f, n = 2.0f / wide - 2.0f;
  EXPECT_NEAR(surface.shininess, n, 1e-3f);
  EXPECT_NEAR(surface.diffuse.g, 0.6f * 0.5f + 0.1f * wide, 1e-5f);
  EXPECT_NEAR(surface.specular.b, 0.5f * (1 - wide) * (n + 2) / 8, 1e-5f);
}

TEST(MaterialLayers, SpecularAndIndexOfRefraction) {
  MaterialLayers layers;
  layers.ior = 2.0f;  // F0 = 1/9
  layers.specular_color = {1.0f, 0.5f, 0.0f};
  layers.specular = 0.5f;
  Material material = dielectric(layers);
  material.roughness = 0.5f;
  const float peak = (1 - 0.0625f) * 32.0f / 8.0f;
  const SurfaceCoefficients surface = converted(material);
  EXPECT_NEAR(surface.specular.r, 0.5f / 9 * peak, 1e-5f);
  EXPECT_NEAR(surface.specular.g, 0.25f / 9 * peak, 1e-5f);
  EXPECT_EQ(surface.specular.b, 0.0f);
}

TEST(MaterialLayers, AFilmOfNoThicknessIsNotSeen) {
  MaterialLayers layers;
  layers.iridescence = 1.0f;
  layers.iridescence_thickness_nm = 0.0f;
  Material material = dielectric(layers);
  material.roughness = 0.5f;
  Material plain = material;
  plain.layers = nullptr;
  EXPECT_NEAR(converted(material).specular.g, converted(plain).specular.g, 1e-4f);
  layers.iridescence_thickness_nm = 400.0f;
  material.layers = std::make_shared<const MaterialLayers>(layers);
  const glm::vec3 colored = converted(material).specular;
  EXPECT_GT(std::max({colored.r, colored.g, colored.b}) - std::min({colored.r, colored.g, colored.b}), 0.01f);
}

TEST(MaterialLayers, AnisotropyKeepsTheSolidAngle) {
  MaterialLayers layers;
  layers.anisotropy = 1.0f;  // αt = 1
  Material material = dielectric(layers);
  material.roughness = 0.5f;
  EXPECT_NEAR(converted(material).shininess, 2.0f / 0.25f - 2.0f, 1e-3f);
}

RenderSettings unlit_view() {
  RenderSettings settings = testing::front_view();
  settings.color_management = ColorManagement::none;
  settings.no_lights = true;
  return settings;
}

/// A square of glass in front of an unlit one of (1, 0.8, 0.6).
Scene behind(const Material& glass) {
  testing::SceneBuilder builder;
  builder.add_mesh_node(testing::square(builder.add_material(glass)), {0, 0, 0.5f});
  builder.add_mesh_node(testing::square(builder.add_material(testing::unlit({1.0f, 0.8f, 0.6f, 1.0f}))));
  return builder.scene;
}

TEST(MaterialLayers, GlassMultipliesWhatIsBehind) {
  MaterialLayers layers;
  layers.transmission = 1.0f;
  layers.specular = 0.0f;
  EXPECT_EQ(middle(behind(dielectric(layers, {1.0f, 0.5f, 0.0f})), unlit_view()), (Pixel{255, 102, 0, 255}));
  layers.attenuation_color = {0.5f, 1.0f, 1.0f};
  layers.attenuation_distance = 1.0f;
  layers.thickness = 2.0f;
  const Pixel deep = middle(behind(dielectric(layers)), unlit_view());
  EXPECT_NEAR(deep[0], 255 / 4, 1);
  EXPECT_EQ(deep[1], 204);
  layers.transmission = 0.0f;
  EXPECT_EQ(middle(behind(dielectric(layers, {1.0f, 0.5f, 0.0f})), unlit_view()), (Pixel{255, 128, 0, 255}));
}

TEST(MaterialLayers, FogIsAddedToGlassOnce) {
  MaterialLayers layers;
  layers.transmission = 1.0f;
  layers.specular = 0.0f;
  RenderSettings settings = unlit_view();
  raster::FogState fog;
  fog.mode = raster::FogMode::linear;
  fog.start = 0.0f;
  fog.end = 10.0f;
  fog.color = {0.0f, 0.0f, 1.0f, 1.0f};
  settings.fog = fog;
  // Clear glass: as without it.
  const Pixel with = middle(behind(dielectric(layers)), settings);
  testing::SceneBuilder without;
  without.add_mesh_node(testing::square(without.add_material(testing::unlit({1.0f, 0.8f, 0.6f, 1.0f}))));
  const Pixel expected = middle(without.scene, settings);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(with[c], expected[c], 1) << c;
}

TEST(MaterialLayers, AClearCoatIsASecondHighlight) {
  testing::SceneBuilder builder;
  MaterialLayers layers;
  layers.clearcoat = 1.0f;
  layers.clearcoat_roughness = 0.1f;
  const int coated = builder.add_material(dielectric(layers, {0.5f, 0.0f, 0.0f}));
  builder.add_mesh_node(testing::square(coated));
  RenderSettings settings = testing::front_view();
  settings.color_management = ColorManagement::none;
  UserLight light;
  light.space = UserLight::Space::camera;
  light.direction = {0, 0, -1};
  light.light.exact_intensity = 1.0f;
  settings.lights = {light};
  const Pixel with = middle(builder.scene, settings);
  builder.scene.materials[0].layers = nullptr;
  const Pixel without = middle(builder.scene, settings);
  EXPECT_GT(with[1], without[1] + 30) << "white light in the middle of a red square";
}

}  // namespace
}  // namespace barrido::scene
