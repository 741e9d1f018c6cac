// Khronos' NormalTangentMirrorTest: balls as geometry, and the same balls as normal maps on squares, whose
// coordinates are as drawn, mirrored in v and mirrored in u, turned a little from row to row.
#include <algorithm>
#include <array>
#include <cmath>

#include "import_support.h"
#include "pipeline/scene/render_scene.h"

namespace barrido::scene::test {
namespace {

constexpr int kWidth = 1160, kHeight = 900;
constexpr int kHalf = 30;  // of a window inside a ball, pixels
constexpr std::array kRows{122, 272, 422, 572, 722};
/// Middles of the balls: geometry, normal map, mirrored in v, in u.
constexpr std::array<std::array<int, 4>, 2> kColumns{{{102, 222, 344, 471}, {692, 812, 933, 1054}}};

/// From the front, parallel rays, one lamp from the upper left; rough and not metal, so that nothing
/// reflects.
raster::Framebuffer draw_front(const Scene& scene) {
  RenderSettings settings;
  settings.width = kWidth;
  settings.height = kHeight;
  settings.camera.position = glm::vec3(0, -0.075f, 5);
  settings.camera.focal_point = glm::vec3(0, -0.075f, 0);
  settings.camera.orthographic_height = 2.4f;
  UserLight lamp;
  lamp.light.kind = Light::Kind::directional;
  lamp.light.exact_intensity = 1.0f;
  lamp.direction = {0.4f, -0.5f, -1.0f};
  settings.lights = {lamp};
  settings.material.metallic = 0.0f;
  settings.material.roughness = 0.7f;
  return SceneRenderer(scene).render(settings);
}

/// Mean absolute difference of two windows, in 1/255.
double difference(const raster::Framebuffer& frame, int x0, int x1, int y) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(frame.color8().data());
  double sum = 0.0;
  for (int dy = -kHalf; dy <= kHalf; ++dy) {
    for (int dx = -kHalf; dx <= kHalf; ++dx) {
      for (int c = 0; c < 3; ++c) {
        const auto at = [&](int x) { return bytes[((y + dy) * kWidth + x + dx) * 4 + c]; };
        sum += std::abs(at(x0) - at(x1));
      }
    }
  }
  return sum / (3.0 * (2 * kHalf + 1) * (2 * kHalf + 1));
}

/// Middles lie at fractions of a pixel.
double least_difference(const raster::Framebuffer& frame, int x0, int x1, int y) {
  return std::min(
      {difference(frame, x0, x1 - 1, y), difference(frame, x0, x1, y), difference(frame, x0, x1 + 1, y)});
}

TEST(MirroredTangents, BallsOfNormalMapsLookAsTheBallsOfGeometryBesideThem) {
  const std::filesystem::path path =
      assets_folder() / "extensions/NormalTangentMirrorTest/glTF-Binary/NormalTangentMirrorTest.glb";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "needs the test assets in " << assets_folder();
  Scene scene = import_gltf(path);
  for (const bool own : {true, false}) {
    SCOPED_TRACE(own ? "the file's tangents" : "generated tangents");
    if (!own) scene.meshes[0].primitives[0].tangents = {};
    const raster::Framebuffer frame = draw_front(scene);
    for (const int row : kRows) {
      for (const auto& columns : kColumns) {
        for (const int column : {columns[1], columns[2], columns[3]}) {
          const double found = least_difference(frame, columns[0], column, row);
          EXPECT_LE(found, 2.0) << "row at " << row << ", ball at " << column;
        }
      }
    }
  }
}

}  // namespace
}  // namespace barrido::scene::test
