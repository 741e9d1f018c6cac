// Where procedures and mapped pictures lie on objects, seen in whole frames of small scenes.
#include "pipeline/scene/texture_placement.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/unit/scene/frame_fixture.h"

namespace barrido::scene {
namespace {

using testing::front_view;
using testing::Pixel;
using testing::pixel_of;
using testing::SceneBuilder;
using testing::unlit;

/// A white square, moved by so much, and an eye that went along.
Scene moved_square(float x, RenderSettings& settings) {
  SceneBuilder builder;
  builder.add_mesh_node(testing::square(builder.add_material(unlit({1, 1, 1, 1}))), {x, 0, 0});
  settings = front_view();
  settings.camera.position = glm::vec3(x, 0, 5);
  settings.camera.focal_point = glm::vec3(x, 0, 0);
  settings.color_management = ColorManagement::none;
  return builder.scene;
}

std::vector<std::uint32_t> pixels_of(const Scene& scene, const RenderSettings& settings) {
  SceneRenderer renderer(scene);
  const raster::Framebuffer frame = renderer.render(settings);
  return {frame.color8().begin(), frame.color8().end()};
}

/// 2 × 2: red, green above; blue, white below.
std::shared_ptr<const Image> four_colors() {
  auto image = std::make_shared<Image>();
  image->width = image->height = 2;
  image->rgba = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
  return image;
}

/// Of a square that fills three quarters of the frame: in each quarter, upper left first.
std::array<Pixel, 4> quarters(const Scene& scene, const RenderSettings& settings) {
  SceneRenderer renderer(scene);
  const raster::Framebuffer frame = renderer.render(settings);
  return {pixel_of(frame, 26, 38), pixel_of(frame, 38, 38), pixel_of(frame, 26, 26), pixel_of(frame, 38, 26)};
}

TEST(TexturePlacement, StripesStickToTheObjectOrStandInTheWorld) {
  for (const SolidTexture::Space space : {SolidTexture::Space::object, SolidTexture::Space::world}) {
    SolidTexture stripes;
    stripes.pattern.kind = raster::PatternKind::stripes;
    stripes.axis = {1, 0, 0};
    stripes.scale = 0.5f;
    stripes.space = space;
    RenderSettings here, there;
    const Scene one = moved_square(0.0f, here), other = moved_square(0.25f, there);
    here.texture.solid = there.texture.solid = stripes;
    const bool same = pixels_of(one, here) == pixels_of(other, there);
    EXPECT_EQ(same, space == SolidTexture::Space::object);
    // Moved by two stripes, the world's pattern is the same again.
    RenderSettings far;
    const Scene beyond = moved_square(1.0f, far);
    far.texture.solid = stripes;
    EXPECT_EQ(pixels_of(one, here), pixels_of(beyond, far));
  }
}

TEST(TexturePlacement, ColoursAreTheTwoOfThePattern) {
  RenderSettings settings;
  const Scene scene = moved_square(0.0f, settings);
  SolidTexture stripes;
  stripes.pattern.kind = raster::PatternKind::stripes;
  stripes.pattern.colors = {{{0.2f, 0.4f, 0.6f, 1}, {1, 0.5f, 0, 1}}};
  stripes.axis = {1, 0, 0};
  stripes.scale = 1.0f;  // The middle of the square is the middle of stripe 0.
  settings.texture.solid = stripes;
  SceneRenderer renderer(scene);
  const raster::Framebuffer frame = renderer.render(settings);
  EXPECT_EQ(pixel_of(frame, 32, 32), (Pixel{51, 102, 153, 255}));
  EXPECT_EQ(pixel_of(frame, 50, 32), (Pixel{255, 128, 0, 255}));
}

TEST(TexturePlacement, APlanarPictureStandsUpright) {
  RenderSettings settings;
  const Scene scene = moved_square(0.0f, settings);
  settings.texture.picture = four_colors();
  settings.mag_filter = raster::MagFilter::nearest;
  settings.texture.mapping.emplace();
  settings.texture.mapping->surface = raster::MappingSurface::planar;
  settings.texture.mapping->axis = {0, 0, 1};
  const std::array<Pixel, 4> upright{
      {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {255, 255, 255, 255}}};
  EXPECT_EQ(quarters(scene, settings), upright);
  // The coordinates of the corners say the same of a plane.
  settings.texture.mapping->at_vertices = true;
  EXPECT_EQ(quarters(scene, settings), upright);
  // So does the box, to whose front the normals point.
  settings.texture.mapping->surface = raster::MappingSurface::box;
  settings.texture.mapping->ray = raster::MappingRay::normal;
  settings.texture.mapping->axis = {0, 1, 0};
  settings.texture.mapping->at_vertices = false;
  EXPECT_EQ(quarters(scene, settings), upright);
  settings.texture.mapping->offset = {0.5f, 0.0f};
  EXPECT_EQ(quarters(scene, settings)[0], upright[1]);
}

TEST(TexturePlacement, APictureWithoutCoordinatesIsAWarning) {
  RenderSettings settings;
  const Scene scene = moved_square(0.0f, settings);
  settings.texture.picture = four_colors();
  SceneRenderer renderer(scene);
  renderer.render(settings);
  ASSERT_EQ(renderer.warnings().size(), 1u);
  EXPECT_NE(renderer.warnings()[0].find("--mapping"), std::string::npos);
  settings.texture.mapping.emplace();
  settings.texture.mapping->surface = raster::MappingSurface::box;
  renderer.render(settings);
  EXPECT_TRUE(renderer.warnings().empty());
}

TEST(TexturePlacement, MatricesTakeTheBoxToTheMapping) {
  MappingChoice choice;
  choice.surface = raster::MappingSurface::cylinder;
  choice.axis = {0, 0, 3};
  PlacedObject object;
  object.box = {{-1, -2, 3}, {1, 4, 9}};
  const glm::mat4 m = place_mapping(choice, object).matrix;
  const glm::vec4 top = m * glm::vec4(0, 1, 9, 1), side = m * glm::vec4(0, 4, 6, 1);
  EXPECT_NEAR(top.y, 1.0f, 1e-6f);
  EXPECT_NEAR(side.y, 0.0f, 1e-6f);
  EXPECT_NEAR(glm::length(glm::vec3(side)), 1.0f, 1e-6f);
  choice.axis = {0, -1, 0};
  EXPECT_NEAR((place_mapping(choice, object).matrix * glm::vec4(0, -2, 6, 1)).y, 1.0f, 1e-6f);
  choice.centre = glm::vec3(0, 0, 0);
  choice.size = 4.0f;
  EXPECT_NEAR((place_mapping(choice, object).matrix * glm::vec4(0, -2, 0, 1)).y, 1.0f, 1e-6f);
}

/// Rays along normals and reflections need the way to eye space and back.
TEST(TexturePlacement, LookingTakesDirectionsThereAndBack) {
  glm::mat4 eye(1.0f), mapping_from_object(2.0f);
  mapping_from_object[3] = {1, 2, 3, 1};
  eye[3] = {0, 0, -5, 1};
  raster::Mapping mapping;
  look_from(eye, mapping_from_object, mapping);
  EXPECT_EQ(mapping.eye_from_mapping[2], (std::array<float, 4>{0, 0, 0.5f, -6.5f}));
  EXPECT_EQ(mapping.mapping_from_eye[0], (std::array<float, 3>{2, 0, 0}));
}

}  // namespace
}  // namespace barrido::scene
