// Maps of materials as pixels: what is drawn of the file's and the user's, and what is left out with a word.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/scene/frame_fixture.h"

namespace barrido::scene {
namespace {

constexpr int kSide = 32;

Image picture_of(const auto& texel) {
  Image image;
  image.width = image.height = kSide;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      for (const float value : texel(x, y)) {
        image.rgba.push_back(static_cast<std::uint8_t>(std::lround(255.0f * value)));
      }
    }
  }
  return image;
}

std::array<float, 4> grey(float value) { return {value, value, value, 1.0f}; }

/// Two gentle waves a side.
float wave(int i) {
  constexpr float kTurn = 6.2831853f;
  return 0.5f + 0.25f * std::sin(kTurn * static_cast<float>(i) * 2.0f / kSide);
}
float height(int x, int y) { return std::round(255.0f * wave(x) * wave(y)) / 255.0f; }

constexpr float kHeight = 0.1f;

std::array<float, 4> normal(int x, int y) {
  const float u = (height(x + 1, y) - height(x - 1, y)) * 0.5f * kSide * kHeight;
  const float v = (height(x, y + 1) - height(x, y - 1)) * 0.5f * kSide * kHeight;
  const float length = std::sqrt(u * u + v * v + 1.0f);
  return {0.5f - 0.5f * u / length, 0.5f + 0.5f * v / length, 0.5f + 0.5f / length, 1.0f};  // y upwards
}

/// A square with coordinates, v downwards, under one lamp from the side.
struct MappedSquare {
  Scene scene;
  RenderSettings settings = testing::front_view();

  explicit MappedSquare(float size = 1.0f) {
    testing::SceneBuilder builder;
    Material material = testing::matte({0.8f, 0.8f, 0.8f});
    Primitive square = testing::square(builder.add_material(material));
    square.texcoords[0] = FloatArray({0, 1, 1, 1, 1, 0, 0, 0});
    std::vector<float> scaled(square.positions.values().begin(), square.positions.values().end());
    for (float& value : scaled) value *= size;
    square.positions = FloatArray(std::move(scaled));
    builder.add_mesh_node(square);
    scene = std::move(builder.scene);
    UserLight lamp;
    lamp.light.kind = Light::Kind::directional;
    lamp.light.exact_intensity = 1.0f;
    lamp.direction = {1, -0.5f, -1};
    settings.lights = {lamp};
    settings.ambient = glm::vec3(0.2f);
    settings.camera.position = glm::vec3(0, 0, 5 * size);
    settings.color_management = ColorManagement::none;
  }
  Material& material() { return scene.materials[0]; }
  TextureUse add(Image image) {
    scene.images.push_back(std::move(image));
    Texture texture;
    texture.image = static_cast<int>(scene.images.size()) - 1;
    texture.min_filter = raster::MinFilter::linear;
    scene.textures.push_back(texture);
    return {static_cast<int>(scene.textures.size()) - 1, 0, glm::mat3(1.0f)};
  }
  raster::Framebuffer draw() const { return SceneRenderer(scene).render(settings); }
};

/// Mean and largest difference of the pictures' channels, in 1/255.
std::pair<double, int> difference(const raster::Framebuffer& a, const raster::Framebuffer& b) {
  const auto *left = reinterpret_cast<const std::uint8_t*>(a.color8().data()),
             *right = reinterpret_cast<const std::uint8_t*>(b.color8().data());
  const std::size_t bytes = a.color8().size() * 4;
  double sum = 0.0;
  int most = 0;
  for (std::size_t i = 0; i < bytes; ++i) {
    const int found = std::abs(left[i] - right[i]);
    sum += found;
    most = std::max(most, found);
  }
  return {sum / static_cast<double>(bytes), most};
}

TEST(Maps, HeightsAndTheNormalMapMadeOfThemAreOnePicture) {
  MappedSquare plain, bump, normals;
  bump.material().bump = {bump.add(picture_of([](int x, int y) { return grey(height(x, y)); })), kHeight,
                          raster::BumpForm::invariant};
  normals.material().normal_texture = normals.add(picture_of(normal));
  const raster::Framebuffer with_heights = bump.draw(), with_normals = normals.draw();
  // P_u and P_v are as long as each other, and the texels of both maps are of 8 bits.
  const auto [mean, most] = difference(with_heights, with_normals);
  EXPECT_LT(mean, 0.5);
  EXPECT_LE(most, 4);
  EXPECT_GT(difference(with_heights, plain.draw()).second, 20);  // and not for want of bumps
}

TEST(Maps, TheInvariantFormDoesNotDependOnTheSizeOfTheObject) {
  const auto drawn = [](float size, raster::BumpForm form) {
    MappedSquare square(size);
    square.material().bump = {square.add(picture_of([](int x, int y) { return grey(height(x, y)); })),
                              kHeight, form};
    return square.draw();
  };
  EXPECT_LE(difference(drawn(1, raster::BumpForm::invariant), drawn(4, raster::BumpForm::invariant)).second,
            1);
  EXPECT_GT(difference(drawn(1, raster::BumpForm::blinn), drawn(4, raster::BumpForm::blinn)).second, 8);
}

TEST(Maps, OcclusionTakesAmbientLightAlone) {
  MappedSquare square;
  square.settings.no_lights = true;
  square.settings.lights.clear();
  square.settings.ambient = glm::vec3(1.0f);
  const int whole = testing::middle(square.scene, square.settings)[0];
  square.material().occlusion_texture = square.add(picture_of([](int, int) { return grey(0.25f); }));
  square.material().occlusion_strength = 0.5f;
  EXPECT_NEAR(testing::middle(square.scene, square.settings)[0], whole * (1.0 + 0.5 * (64 / 255.0 - 1.0)),
              1.0);
  square.settings.shading = pipeline::ShadeModel::cheap_phong;
  EXPECT_NEAR(testing::middle(square.scene, square.settings)[0], whole * (1.0 + 0.5 * (64 / 255.0 - 1.0)),
              1.0);
  square.settings.maps.drawn = false;
  EXPECT_EQ(testing::middle(square.scene, square.settings)[0], whole);
}

TEST(Maps, TransparencyMakesAnOpaqueMaterialBlend) {
  MappedSquare square;
  square.settings.background_color = glm::vec4(0, 0, 1, 1);
  const testing::Pixel whole = testing::middle(square.scene, square.settings);
  square.material().transparency_texture = square.add(picture_of([](int, int) {
    return std::array<float, 4>{0.4f, 1, 1, 1};
  }));
  const testing::Pixel through = testing::middle(square.scene, square.settings);
  EXPECT_NEAR(through[0], 0.4 * whole[0], 1.0);
  EXPECT_NEAR(through[2], 0.4 * whole[2] + 0.6 * 255, 1.5);
}

TEST(Maps, SpecularityIsAFactorOfTheHighlight) {
  const auto red_with = [](float factor) {
    MappedSquare square;
    square.material().exact.specular = glm::vec3(0.5f);
    square.material().exact.diffuse = glm::vec3(0.2f);
    square.material().exact.shininess = 1.0f;
    square.material().specularity_texture = square.add(picture_of([&](int, int) { return grey(factor); }));
    return testing::middle(square.scene, square.settings)[0];
  };
  EXPECT_NEAR(red_with(0.4f) - red_with(0.0f), 0.4 * (red_with(1.0f) - red_with(0.0f)), 1.0);
  EXPECT_GT(red_with(1.0f), red_with(0.0f) + 30);
}

TEST(Maps, WhatAModeCannotDrawIsOneWarning) {
  MappedSquare square;
  square.material().normal_texture = square.add(picture_of(normal));
  square.material().occlusion_texture = square.material().normal_texture;
  const auto warnings = [&](pipeline::ShadeModel model) {
    square.settings.shading = model;
    SceneRenderer renderer(square.scene);
    renderer.render(square.settings);
    return renderer.warnings();
  };
  EXPECT_TRUE(warnings(pipeline::ShadeModel::phong).empty());
  EXPECT_EQ(warnings(pipeline::ShadeModel::gouraud).size(), 2u);
  ASSERT_EQ(warnings(pipeline::ShadeModel::cheap_phong).size(), 1u);
  EXPECT_NE(warnings(pipeline::ShadeModel::cheap_phong)[0].find("no normal at a fragment"),
            std::string::npos);
  square.settings.maps.drawn = false;
  EXPECT_TRUE(warnings(pipeline::ShadeModel::flat).empty());
}

TEST(Maps, WithoutCoordinatesThereIsNothingToLayThemOn) {
  MappedSquare square;
  const raster::Framebuffer before = square.draw();
  square.material().normal_texture = square.add(picture_of(normal));
  square.scene.meshes[0].primitives[0].texcoords[0] = {};
  EXPECT_EQ(difference(square.draw(), before).second, 0);
}

}  // namespace
}  // namespace barrido::scene
