#include <cmath>

#include <gtest/gtest.h>

#include "pipeline/scene/blended_order.h"
#include "pipeline/scene/light_conversion.h"
#include "pipeline/scene/material_conversion.h"
#include "pipeline/scene/metering.h"
#include "tests/unit/scene/scene_fixture.h"

namespace barrido::scene {
namespace {

TEST(MaterialConversion, DielectricsFollowTheFormula) {
  Material material;
  material.base_color = {0.5f, 0.25f, 1.0f, 0.7f};
  material.metallic = 0.0f;
  material.roughness = 0.5f;
  const SurfaceCoefficients surface = convert_material(material, {}, Reflections::metals, {});
  const float n = 2.0f / 0.0625f - 2.0f;
  EXPECT_NEAR(surface.shininess, n, 1e-4);
  const float share = 2.0f / (n + 2);
  EXPECT_NEAR(surface.specular.r, 0.04f * (n + 2) / 8 * (1 - share), 1e-5);
  EXPECT_NEAR(surface.diffuse.g, 0.25f * 0.96f + 0.04f * share, 1e-5);
  EXPECT_EQ(surface.diffuse.a, 0.7f);
  EXPECT_EQ(surface.reflectance, glm::vec3(0.0f));
}

TEST(MaterialConversion, ReflectionAndDiffuseTogetherKeepTheDiffuseShare) {
  Material material;
  material.metallic = 0.0f;
  material.roughness = 0.2f;
  const SurfaceCoefficients surface = convert_material(material, {}, Reflections::all, {});
  EXPECT_NEAR(surface.reflectance.r, 0.04f, 1e-4);
  EXPECT_NEAR(surface.diffuse.r * (1 - surface.reflectance.r), 0.96f, 2e-3);
}

TEST(MaterialConversion, MetalsAreNeverBlack) {
  Material material;
  material.base_color = {1.0f, 0.7f, 0.3f, 1.0f};
  const SurfaceCoefficients rough = convert_material(material, {}, Reflections::metals, {});
  EXPECT_EQ(glm::vec3(rough.diffuse), glm::vec3(1.0f, 0.7f, 0.3f));  // as chalk
  material.roughness = 0.0f;
  const SurfaceCoefficients mirror = convert_material(material, {}, Reflections::metals, {});
  EXPECT_FLOAT_EQ(mirror.reflectance.g, 0.7f);
  EXPECT_TRUE(mirror.reflection_before_texture);
  EXPECT_TRUE(std::isfinite(mirror.specular.r));
  // Vertex colours cannot colour a reflection: painted instead.
  SurfaceContext painted;
  painted.vertex_colors = true;
  EXPECT_GT(convert_material(material, painted, Reflections::metals, {}).diffuse.r, 0.9f);
}

TEST(MaterialConversion, ExactValuesAreTakenAsTheyAre) {  // extras.barrido
  Material material;
  material.exact.ambient = glm::vec3(0.1f);
  material.exact.diffuse = glm::vec3(0.2f);
  material.exact.specular = glm::vec3(0.3f);
  material.exact.shininess = 77.0f;
  const SurfaceCoefficients surface = convert_material(material, {}, Reflections::all, {128.0f, true});
  EXPECT_EQ(surface.ambient, glm::vec3(0.1f));
  EXPECT_EQ(glm::vec3(surface.diffuse), glm::vec3(0.2f));
  EXPECT_EQ(surface.specular, glm::vec3(0.3f));
  EXPECT_EQ(surface.shininess, 77.0f);
  EXPECT_EQ(surface.reflectance, glm::vec3(0.0f));
}

TEST(MaterialConversion, OpenGLsLimitsHold) {
  Material material;
  material.roughness = 0.1f;
  const SurfaceCoefficients surface = convert_material(material, {}, Reflections::metals, {128.0f, true});
  EXPECT_NEAR(surface.shininess, 128.0f, 1e-3);
  EXPECT_GT(surface.reflection_exponent, 500.0f) << "what is mirrored stays sharp";
  EXPECT_LE(surface.specular.r, 1.0f);
}

TEST(LightConversion, PhysicalLightsAreDividedByPiAndFallWithTheSquare) {
  Light light;
  light.kind = Light::Kind::spot;
  light.intensity = 31.4159265f;
  light.range = 7.0f;
  light.inner_cone_rad = 0.2f;
  light.outer_cone_rad = 0.4f;
  const pipeline::Light out = convert_light(light, {{1, 2, 3}, {0, -2, 0}});
  EXPECT_NEAR(out.diffuse.r, 10.0f, 1e-5);
  EXPECT_EQ(out.position, glm::vec4(1, 2, 3, 1));
  EXPECT_EQ(out.constant_attenuation, 0.0f);
  EXPECT_EQ(out.quadratic_attenuation, 1.0f);
  EXPECT_EQ(out.range, 7.0f);
  EXPECT_NEAR(out.spot_inner_cos, std::cos(0.2), 1e-6);
  EXPECT_NEAR(out.spot_outer_cos, std::cos(0.4), 1e-6);
  EXPECT_EQ(out.spot_direction, glm::vec3(0, -1, 0));
}

TEST(LightConversion, ExactLightsAreTheCourses) {  // V5, L4
  Light light;
  light.kind = Light::Kind::spot;
  light.exact_intensity = -0.5f;
  light.spot_exponent = 12.0f;
  const pipeline::Light out = convert_light(light, {});
  EXPECT_EQ(out.diffuse.r, -0.5f);
  EXPECT_EQ(out.constant_attenuation, 1.0f);
  EXPECT_EQ(out.quadratic_attenuation, 0.0f);
  EXPECT_EQ(out.spot_exponent, 12.0f);
  EXPECT_NEAR(out.spot_cutoff_deg, 45.0f, 1e-4);
  light.attenuation = {{0.5f, 1.0f, 0.0f}};
  EXPECT_EQ(convert_light(light, {}).linear_attenuation, 1.0f);
}

TEST(LightConversion, ThreeLightsExposeWhiteWellButDoNotClipIt) {  // V2
  const std::vector<pipeline::Light> lights = three_light_setup();
  ASSERT_EQ(lights.size(), 3u);
  EXPECT_FLOAT_EQ(lights[1].diffuse.r, 0.5f * lights[0].diffuse.r);
  EXPECT_LT(lights[0].position.x, 0.0f);
  EXPECT_GT(lights[0].position.y, 0.0f);
  EXPECT_LT(lights[2].position.z, 0.0f);
  double brightest = 0.0;
  for (int i = 0; i < 20000; ++i) {  // directions on a spiral over the sphere
    const double z = 1 - 2 * (i + 0.5) / 20000, phi = i * 2.399963;
    const glm::dvec3 n(std::sqrt(1 - z * z) * std::cos(phi), std::sqrt(1 - z * z) * std::sin(phi), z);
    double sum = kDefaultAmbient;
    for (const pipeline::Light& light : lights) {
      sum += light.diffuse.r * std::max(0.0, glm::dot(n, glm::dvec3(light.position)));
    }
    brightest = std::max(brightest, sum);
  }
  EXPECT_LT(brightest, 1.0);
  EXPECT_GT(brightest, 0.85);
}

TEST(LightConversion, TheUsersLightsReplaceTheFilesAndTooManyAreNamed) {
  testing::SceneBuilder builder;
  builder.scene.lights.resize(1);
  for (int i = 0; i < 70; ++i) {
    Node node;
    node.light = 0;
    builder.add_node(node);
  }
  const Pose pose = pose_at(builder.scene, kNone, 0.0);
  std::vector<int> nodes(70);
  for (int i = 0; i < 70; ++i) nodes[static_cast<std::size_t>(i)] = i;
  std::vector<std::string> warnings;
  RenderSettings settings;
  EXPECT_EQ(choose_lights(builder.scene, nodes, 0, pose, settings, glm::mat4(1), 1, warnings).lights.size(),
            64u);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0], "more than 64 lights: the first 64 are used");
  settings.lights.resize(2);
  EXPECT_EQ(choose_lights(builder.scene, nodes, 0, pose, settings, glm::mat4(1), 1, warnings).lights.size(),
            2u);
  settings.no_lights = true;
  const SceneLights none = choose_lights(builder.scene, nodes, 0, pose, settings, glm::mat4(1), 1, warnings);
  EXPECT_TRUE(none.lights.empty());
  EXPECT_EQ(none.ambient, glm::vec3(1.0f));
}

TEST(Metering, BringsPhysicalLightsIntoRangeAndLeavesGoodOnesAlone) {
  const auto scale_for = [](float intensity) {
    testing::SceneBuilder builder;
    builder.add_mesh_node(testing::square());
    Light sun;
    sun.intensity = intensity;
    builder.scene.lights.push_back(sun);
    Node node;
    node.light = 0;
    builder.add_node(node);
    return physical_light_scale(builder.scene, {0, 1}, pose_at(builder.scene, kNone, 0.0));
  };
  EXPECT_FLOAT_EQ(scale_for(2.0f), 1.0f);
  EXPECT_NEAR(scale_for(100000.0f) * 100000.0f / M_PI, 1.0, 1e-4);
  EXPECT_NEAR(scale_for(0.01f) * 0.01f / M_PI, 0.25, 1e-4);
  EXPECT_FLOAT_EQ(scale_for(0.0f), 1.0f);
}

/// Triangles at these depths, in one array.
std::vector<float> triangles_at(std::initializer_list<float> depths) {
  std::vector<float> positions;
  for (const float z : depths) positions.insert(positions.end(), {0, 0, -z, 1, 0, -z, 0, 1, -z});
  return positions;
}

pipeline::Geometry geometry_of(const std::vector<float>& positions) {
  pipeline::Geometry geometry;
  geometry.vertex_count = static_cast<std::uint32_t>(positions.size() / 3);
  geometry.position = {positions.data(), 3, 3};
  return geometry;
}

TEST(BlendedOrder, TrianglesOfAllDrawsFarthestFirstAndEqualsInOrder) {
  const std::vector<float> a = triangles_at({1, 5, 3}), b = triangles_at({4, 3, 2});
  const pipeline::Geometry of_a = geometry_of(a), of_b = geometry_of(b);
  const EyeDistance along_z(glm::mat4(1), true);
  const BlendedDraw draws[] = {{&of_a, along_z, {}}, {&of_b, along_z, {}}};
  const BlendedOrder order = order_blended(draws);
  using Indices = std::vector<std::uint32_t>;
  const std::pair<std::size_t, Indices> expected[] = {
      {0, {3, 4, 5}}, {1, {0, 1, 2}}, {0, {6, 7, 8}}, {1, {3, 4, 5, 6, 7, 8}}, {0, {0, 1, 2}}};
  ASSERT_EQ(order.pieces.size(), std::size(expected));
  for (std::size_t i = 0; i < std::size(expected); ++i) {
    EXPECT_EQ(order.pieces[i].draw, expected[i].first) << i;
    EXPECT_EQ(order.pieces[i].indices, expected[i].second) << i;
  }
  EXPECT_EQ(order.slices, 0);
}

TEST(BlendedOrder, PointsStayTogetherAtTheirMiddle) {
  const std::vector<float> a = triangles_at({1, 5}), b = triangles_at({3});
  const pipeline::Geometry of_a = geometry_of(a);
  pipeline::Geometry of_b = geometry_of(b);
  of_b.mode = pipeline::PrimitiveMode::points;
  const EyeDistance along_z(glm::mat4(1), true);
  const BlendedDraw draws[] = {{&of_a, along_z, {}}, {&of_b, along_z, {0, 0, -3}}};
  const BlendedOrder order = order_blended(draws);
  ASSERT_EQ(order.pieces.size(), 3u);
  EXPECT_EQ(order.pieces[1].draw, 1u);
  EXPECT_TRUE(order.pieces[1].indices.empty());
}

TEST(BlendedOrder, TooManyPiecesBecomeSlices) {
  std::vector<float> a, b;
  for (int i = 0; i < 40'000; ++i) {
    for (auto* positions : {&a, &b}) {
      const auto z = -static_cast<float>(2 * i + (positions == &b ? 1 : 0));
      positions->insert(positions->end(), {0, 0, z, 1, 0, z, 0, 1, z});
    }
  }
  const pipeline::Geometry of_a = geometry_of(a), of_b = geometry_of(b);
  const EyeDistance along_z(glm::mat4(1), true);
  const BlendedDraw draws[] = {{&of_a, along_z, {}}, {&of_b, along_z, {}}};
  const BlendedOrder order = order_blended(draws);
  EXPECT_EQ(order.slices, 1024);
  EXPECT_EQ(order.pieces.size(), 2048u);
  std::size_t indices = 0;
  for (const BlendedPiece& piece : order.pieces) indices += piece.indices.size();
  EXPECT_EQ(indices, 240'000u);
  EXPECT_GT(order.pieces[0].indices[0], 100'000u) << "the farthest slice comes first";
}

}  // namespace
}  // namespace barrido::scene
