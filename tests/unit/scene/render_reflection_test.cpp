// Environments in whole frames: behind everything, in mirrors, and rendered by the z-buffer (T17).
#include <array>
#include <memory>

#include <gtest/gtest.h>

#include "tests/unit/scene/frame_fixture.h"

namespace barrido::scene {
namespace {

using testing::front_view;
using testing::middle;
using testing::Pixel;
using testing::pixel_of;
using testing::SceneBuilder;
using testing::unlit;

/// Solid faces in the order +X −X +Y −Y +Z −Z.
std::shared_ptr<const raster::Texture> six_colors() {
  std::array<std::array<std::uint8_t, 4>, 6> texels{{{255, 0, 0, 255},
                                                     {0, 255, 255, 255},
                                                     {0, 255, 0, 255},
                                                     {255, 0, 255, 255},
                                                     {0, 0, 255, 255},
                                                     {255, 255, 0, 255}}};
  std::array<raster::Pixels8, 6> faces;
  for (std::size_t i = 0; i < 6; ++i) faces[i] = {1, 1, texels[i]};
  raster::TextureOptions options;
  options.seamless = false;
  return std::make_shared<raster::Texture>(raster::Texture::make_cube(faces, options));
}

TEST(RenderReflection, TheEnvironmentIsBehindEverything) {  // T17
  RenderSettings settings = front_view();
  settings.environment = six_colors();
  settings.background = Background::environment;
  const Scene empty;
  EXPECT_EQ(middle(empty, settings), (Pixel{255, 255, 0, 255}));  // looking along −Z
  settings.camera.position = glm::vec3(-5, 0, 0);
  EXPECT_EQ(middle(empty, settings), (Pixel{255, 0, 0, 255}));
  // A model with Z up stands in the same room: up is still the room's ceiling.
  settings.camera.up = {0, 0, 1};
  settings.camera.position = glm::vec3(0, 0.01f, -5);
  EXPECT_EQ(middle(empty, settings), (Pixel{0, 255, 0, 255}));
  SceneBuilder builder;
  builder.add_mesh_node(testing::square(builder.add_material(unlit({1, 1, 1, 1}))));
  RenderSettings front = front_view();
  front.environment = six_colors();
  front.background = Background::environment;
  EXPECT_EQ(middle(builder.scene, front), (Pixel{255, 255, 255, 255}));
}

Material mirror() {
  Material material;
  material.roughness = 0.0f;
  return material;
}

TEST(RenderReflection, MirrorsShowWhatIsBehindTheEye) {  // T17
  SceneBuilder builder;
  builder.add_mesh_node(testing::square(builder.add_material(mirror())));
  RenderSettings settings = front_view();
  settings.environment = six_colors();
  settings.no_lights = true;
  settings.ambient = glm::vec3(0.0f);
  EXPECT_EQ(middle(builder.scene, settings), (Pixel{0, 0, 255, 255}));  // +Z
  settings.camera.azimuth_deg = 30;
  EXPECT_EQ(middle(builder.scene, settings), (Pixel{0, 0, 255, 255}));
  settings.camera.azimuth_deg = 60;
  EXPECT_EQ(middle(builder.scene, settings), (Pixel{0, 255, 255, 255}));  // −X
}

TEST(RenderReflection, ADynamicEnvironmentShowsTheOtherObjects) {  // T17, by the z-buffer
  SceneBuilder builder;
  builder.add_mesh_node(testing::square(builder.add_material(mirror())));
  // A large red square 8 before the mirror, seen only by way of it.
  Material red = unlit({1, 0, 0, 1});
  red.double_sided = true;
  const int node = builder.add_mesh_node(testing::square(builder.add_material(red)), {0, 0, 8});
  builder.scene.nodes[static_cast<std::size_t>(node)].transform.scale = {6, 6, 1};
  RenderSettings settings = front_view();
  settings.environment = six_colors();
  settings.no_lights = true;
  settings.ambient = glm::vec3(0.0f);
  EXPECT_EQ(middle(builder.scene, settings), (Pixel{0, 0, 255, 255}));
  settings.dynamic_environment = true;
  EXPECT_EQ(middle(builder.scene, settings), (Pixel{255, 0, 0, 255}));
  settings.color_management = ColorManagement::none;
  EXPECT_EQ(middle(builder.scene, settings), (Pixel{255, 0, 0, 255}));
}

TEST(RenderReflection, TheDynamicMapIsTheRightWayRound) {
  // A red square stands to the right of the mirror's axis and above it, so that is where it shows.
  SceneBuilder builder;
  builder.add_mesh_node(testing::square(builder.add_material(mirror())));
  Material red = unlit({1, 0, 0, 1});
  red.double_sided = true;
  builder.add_mesh_node(testing::square(builder.add_material(red)), {1.0f, 1.0f, 4.0f});
  RenderSettings settings = front_view();
  settings.camera.position = glm::vec3(0, 0, 3);
  settings.environment = six_colors();
  settings.dynamic_environment = true;
  settings.no_lights = true;
  settings.ambient = glm::vec3(0.0f);
  SceneRenderer renderer(builder.scene);
  const raster::Framebuffer frame = renderer.render(settings);
  const Pixel is_red{255, 0, 0, 255}, is_blue{0, 0, 255, 255};
  EXPECT_EQ(pixel_of(frame, 32 + 12, 32 + 12), is_red);
  EXPECT_EQ(pixel_of(frame, 32 - 12, 32 + 12), is_blue);
  EXPECT_EQ(pixel_of(frame, 32 + 12, 32 - 12), is_blue);
}

}  // namespace
}  // namespace barrido::scene
