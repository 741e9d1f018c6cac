// Whole frames of small scenes: what a pixel must show is plain from the scene.
#include "pipeline/scene/render_scene.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "pipeline/files/error.h"
#include "tests/unit/scene/frame_fixture.h"

namespace barrido::scene {
namespace {

using testing::front_view;
using testing::matte;
using testing::middle;
using testing::Pixel;
using testing::pixel_of;
using testing::SceneBuilder;
using testing::unlit;

int sum(const Pixel& p) { return p[0] + p[1] + p[2]; }

TEST(RenderScene, UnlitColorsAreEncodedOrTakenAsTheyAre) {
  SceneBuilder builder;
  builder.add_mesh_node(testing::square(builder.add_material(unlit({1.0f, 0.2158605f, 0.0f, 0.3f}))));
  RenderSettings settings = front_view();
  EXPECT_EQ(middle(builder.scene, settings), (Pixel{255, 128, 0, 255}));  // opaque: alpha counts as 1
  settings.color_management = ColorManagement::none;
  EXPECT_EQ(middle(builder.scene, settings), (Pixel{255, 55, 0, 255}));
}

TEST(RenderScene, TheUsersBackgroundIsSeenAsGivenWhateverTheExposure) {
  const Scene empty;
  RenderSettings settings = front_view();
  settings.background_color = glm::vec4(0.2f, 0.4f, 0.6f, 0.5f);
  const Pixel wanted{51, 102, 153, 128};
  EXPECT_EQ(middle(empty, settings), wanted);
  settings.exposure_ev = 2.0f;
  EXPECT_EQ(middle(empty, settings), wanted);
  settings.tone_map = raster::ToneMap::reinhard;
  EXPECT_EQ(middle(empty, settings), wanted);
  settings.color_management = ColorManagement::none;
  EXPECT_EQ(middle(empty, settings), wanted);
}

TEST(RenderScene, ExposureIsAFactorOfTwoAStop) {
  SceneBuilder builder;
  builder.add_mesh_node(testing::square(builder.add_material(unlit({0.1f, 0.1f, 0.1f, 1}))));
  RenderSettings settings = front_view();
  settings.color_management = ColorManagement::none;
  settings.exposure_ev = 1.0f;
  EXPECT_EQ(middle(builder.scene, settings), (Pixel{51, 51, 51, 255}));
}

TEST(RenderScene, TransparentThingsAreDrawnBackToFrontInWhateverOrderTheyStand) {  // L7
  for (const bool swapped : {false, true}) {
    SceneBuilder builder;
    const int red = builder.add_material(unlit({1, 0, 0, 0.5f}, AlphaMode::blend));
    const int green = builder.add_material(unlit({0, 1, 0, 0.5f}, AlphaMode::blend));
    const int blue = builder.add_material(unlit({0, 0, 1, 1}));
    const auto add_red = [&] { builder.add_mesh_node(testing::square(red), {0, 0, 1}); };
    if (swapped) add_red();
    builder.add_mesh_node(testing::square(green), {0, 0, 0});
    if (!swapped) add_red();
    builder.add_mesh_node(testing::square(blue), {0, 0, -1});
    RenderSettings settings = front_view();
    settings.color_management = ColorManagement::none;
    EXPECT_EQ(middle(builder.scene, settings), (Pixel{128, 64, 64, 255}));
  }
}

TEST(RenderScene, TrianglesOfOneTransparentMeshAreSortedToo) {
  // Two squares in one primitive, the nearer one first.
  Primitive both =
      testing::triangles({-1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1, -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0},
                         {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7});
  const std::vector<float> red{1, 0, 0, 0.5f}, green{0, 1, 0, 0.5f};
  std::vector<float> colors;
  for (int v = 0; v < 8; ++v) {
    const std::vector<float>& color = v < 4 ? red : green;
    colors.insert(colors.end(), color.begin(), color.end());
  }
  both.colors = FloatArray(colors);
  SceneBuilder builder;
  both.material = builder.add_material(unlit({1, 1, 1, 1}, AlphaMode::blend));
  builder.add_mesh_node(both);
  RenderSettings settings = front_view();
  settings.color_management = ColorManagement::none;
  EXPECT_EQ(middle(builder.scene, settings), (Pixel{128, 64, 0, 255}));
}

TEST(RenderScene, MaskedTexelsBelowTheCutoffAreHoles) {
  for (const float alpha : {0.3f, 0.7f}) {
    SceneBuilder builder;
    Material material = unlit({1, 0, 0, alpha}, AlphaMode::mask);
    builder.add_mesh_node(testing::square(builder.add_material(material)));
    EXPECT_EQ(middle(builder.scene, front_view()),
              alpha < 0.5f ? (Pixel{0, 0, 0, 255}) : (Pixel{255, 0, 0, 255}));
  }
}

TEST(RenderScene, BacksAreCulledUnlessDoubleSidedAndMirroredFrontsAreNot) {
  const auto seen = [](bool double_sided, bool turned, bool mirrored,
                       std::optional<pipeline::CullFace> cull) {
    SceneBuilder builder;
    Material material = matte({1, 1, 1});
    material.double_sided = double_sided;
    const int node = builder.add_mesh_node(testing::square(builder.add_material(material)));
    Transform& transform = builder.scene.nodes[static_cast<std::size_t>(node)].transform;
    if (turned) transform.rotation = {0, 0, 1, 0};  // half a turn about Y
    if (mirrored) transform.scale = {-1, 1, 1};
    RenderSettings settings = front_view();
    settings.cull = cull;
    return sum(middle(builder.scene, settings)) > 150;  // lit from the front, that is, not only there
  };
  EXPECT_TRUE(seen(false, false, false, {}));
  EXPECT_FALSE(seen(false, true, false, {}));
  EXPECT_TRUE(seen(true, true, false, {}));
  EXPECT_TRUE(seen(false, false, true, {}));
  EXPECT_FALSE(seen(false, true, true, {}));
  EXPECT_TRUE(seen(false, true, false, pipeline::CullFace::none));
  EXPECT_FALSE(seen(true, false, false, pipeline::CullFace::front));
}

TEST(RenderScene, MetalsAreNotBlackEvenWithoutLights) {
  for (const float roughness : {0.0f, 0.5f, 1.0f}) {
    SceneBuilder builder;
    Material metal;
    metal.base_color = {1.0f, 0.8f, 0.4f, 1.0f};
    metal.roughness = roughness;
    builder.add_mesh_node(testing::square(builder.add_material(metal)));
    for (const ColorManagement mode : {ColorManagement::srgb, ColorManagement::none}) {
      RenderSettings settings = front_view();
      settings.color_management = mode;
      settings.no_lights = true;
      const Pixel p = middle(builder.scene, settings);
      EXPECT_GT(p[0], 50);
      EXPECT_GT(p[0], p[2] + 15) << "the metal's colour must show";
    }
  }
}

Texture texture_of(int image) {
  Texture texture;
  texture.image = image;
  texture.min_filter = raster::MinFilter::nearest;
  texture.mag_filter = raster::MagFilter::nearest;
  return texture;
}

/// 2 × 1 texels, red and green, under a square whose two sets of coordinates put them left and right, or
/// right and left.
SceneBuilder textured() {
  SceneBuilder builder;
  builder.scene.images.push_back({"two", 2, 1, {255, 0, 0, 100, 0, 255, 0, 255}});
  builder.scene.textures.push_back(texture_of(0));
  Material material = unlit({1, 1, 1, 1});
  material.base_color_texture.texture = 0;
  Primitive primitive = testing::square(builder.add_material(material));
  primitive.texcoords[0] = FloatArray(std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1});
  primitive.texcoords[1] = FloatArray(std::vector<float>{1, 0, 0, 0, 0, 1, 1, 1});
  builder.add_mesh_node(primitive);
  return builder;
}

Pixel right_of_middle(const Scene& scene, const RenderSettings& settings) {
  SceneRenderer renderer(scene);
  return pixel_of(renderer.render(settings), settings.width / 2 + 6, settings.height / 2);
}

TEST(RenderScene, TextureCoordinateSetsAndTransforms) {
  SceneBuilder builder = textured();
  const Pixel red{255, 0, 0, 255}, green{0, 255, 0, 255};  // OPAQUE: the picture's alpha is ignored
  EXPECT_EQ(right_of_middle(builder.scene, front_view()), green);
  builder.scene.materials[0].base_color_texture.texcoord_set = 1;
  EXPECT_EQ(right_of_middle(builder.scene, front_view()), red);
  builder.scene.materials[0].base_color_texture.transform[2] = {0.5f, 0.0f, 1.0f};  // moved by a texel
  EXPECT_EQ(right_of_middle(builder.scene, front_view()), green);
  RenderSettings without = front_view();
  without.textures = false;
  EXPECT_EQ(right_of_middle(builder.scene, without), (Pixel{255, 255, 255, 255}));
}

TEST(RenderScene, EmissionIsAddedAndNotMultipliedByTheBaseColor) {
  SceneBuilder builder = textured();
  builder.scene.materials[0] = matte({1, 1, 1});
  builder.scene.materials[0].base_color_texture.texture = 0;
  builder.scene.materials[0].emissive = {0.0f, 0.0f, 1.0f};
  RenderSettings settings = front_view();
  settings.ambient = glm::vec3(0.0f);
  settings.no_lights = true;
  EXPECT_EQ(right_of_middle(builder.scene, settings), (Pixel{0, 0, 255, 255}));
  // With a picture: factor × texture.
  builder.scene.materials[0].emissive = {0.0f, 0.2158605f, 1.0f};
  builder.scene.materials[0].emissive_texture.texture = 0;
  EXPECT_EQ(right_of_middle(builder.scene, settings), (Pixel{0, 128, 0, 255}));
}

TEST(RenderScene, VertexColorsMultiplyTheBaseColor) {
  SceneBuilder builder;
  Primitive primitive = testing::square(builder.add_material(unlit({0.5f, 1, 1, 1})));
  std::vector<float> colors;
  for (int v = 0; v < 4; ++v) colors.insert(colors.end(), {1.0f, 0.0f, 0.6f, 0.1f});
  primitive.colors = FloatArray(colors);
  builder.add_mesh_node(primitive);
  RenderSettings settings = front_view();
  settings.color_management = ColorManagement::none;
  EXPECT_EQ(middle(builder.scene, settings), (Pixel{128, 0, 153, 255}));
  builder.scene.materials[0].unlit = false;
  builder.scene.materials[0].metallic = 0.0f;
  settings.no_lights = true;
  settings.ambient = glm::vec3(1.0f);
  const Pixel lit = middle(builder.scene, settings);  // k_a = k_d = 0.96 b + 0.04, times the vertex colour
  EXPECT_NEAR(lit[0], 255 * 0.52, 1);
  EXPECT_NEAR(lit[2], 255 * 0.6, 1);
  EXPECT_EQ(lit[3], 255);
}

TEST(RenderScene, PointsWithoutNormalsAreUnlit) {
  SceneBuilder builder;
  Primitive point = testing::triangles({0, 0, 0});
  point.mode = pipeline::PrimitiveMode::points;
  point.material = builder.add_material(matte({1, 0, 0}));
  builder.add_mesh_node(point);
  RenderSettings settings = front_view();
  settings.width = settings.height = 65;
  EXPECT_EQ(middle(builder.scene, settings), (Pixel{255, 0, 0, 255}));
}

TEST(RenderScene, FogOfTheUserHasTheColorThatIsSeen) {
  SceneBuilder builder;
  builder.add_mesh_node(testing::square(builder.add_material(unlit({1, 0, 0, 1}))));
  RenderSettings settings = front_view();
  raster::FogState fog;
  fog.enabled = true;
  fog.mode = raster::FogMode::linear;
  fog.start = 0.0f;
  fog.end = 1.0f;
  fog.color = {0.2f, 0.4f, 0.6f, 1.0f};
  settings.fog = fog;
  EXPECT_EQ(middle(builder.scene, settings), (Pixel{51, 102, 153, 255}));
  settings.fog_takes_background = true;
  settings.background_color = glm::vec4(0.4f, 0.2f, 0.0f, 1.0f);
  EXPECT_EQ(middle(builder.scene, settings), (Pixel{102, 51, 0, 255}));
}

TEST(RenderScene, WireframeDrawsEdgesOnly) {
  SceneBuilder builder;
  builder.add_mesh_node(testing::square(builder.add_material(unlit({1, 1, 1, 1}))));
  RenderSettings settings = front_view();
  settings.wireframe = true;
  SceneRenderer renderer(builder.scene);
  const raster::Framebuffer frame = renderer.render(settings);
  int white = 0;
  for (const std::uint32_t pixel : frame.color8()) white += pixel == 0xffffffffu;
  EXPECT_GT(white, 60);
  EXPECT_LT(white, 300);
}

TEST(RenderScene, ACreaseAngleSmoothsWhatHasNoNormals) {  // S2, S3
  // A roof: two squares at right angles, ridge towards the eye.
  SceneBuilder builder;
  Primitive roof = testing::triangles({-1, -1, -1, 0, -1, 0, 0, 1, 0, -1, 1, -1, 1, -1, -1, 1, 1, -1},
                                      {0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2});
  roof.material = builder.add_material(matte({1, 1, 1}));
  builder.add_mesh_node(roof);
  RenderSettings settings = front_view();
  const auto step_at_ridge = [&] {
    SceneRenderer renderer(builder.scene);
    const raster::Framebuffer frame = renderer.render(settings);
    return std::abs(pixel_of(frame, 31, 32)[0] - pixel_of(frame, 32, 32)[0]);
  };
  const int flat = step_at_ridge();
  settings.crease_angle_deg = 100.0f;
  const int smooth = step_at_ridge();
  settings.crease_angle_deg = 80.0f;
  EXPECT_GT(flat, 10);
  EXPECT_LT(smooth, 5);
  EXPECT_EQ(step_at_ridge(), flat);
}

TEST(RenderScene, ChoicesThatDoNotExistAreNamed) {
  const SceneBuilder builder = textured();
  SceneRenderer renderer(builder.scene);
  RenderSettings settings = front_view();
  settings.scene_index = 3;
  EXPECT_THROW(renderer.render(settings), InputError);
  settings = front_view();
  settings.animation = 0;
  EXPECT_THROW(renderer.render(settings), InputError);
}

}  // namespace
}  // namespace barrido::scene
