#include "pipeline/scene/view.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "pipeline/files/error.h"
#include "pipeline/scene/scene_nodes.h"
#include "tests/unit/scene/scene_fixture.h"

namespace barrido::scene {
namespace {

using testing::SceneBuilder;

struct Looked {
  Eye eye;
  View view;
};

Looked look(const Scene& scene, const RenderSettings& settings) {
  const std::vector<int> nodes = nodes_of_scene(scene, resolve_scene_index(scene, settings.scene_index));
  const std::vector<Pose> poses = framing_poses(scene, settings.animation);
  const Bounds bounds = find_bounds(scene, nodes, poses, glm::dvec3(settings.camera.up));
  const Eye eye = choose_eye(scene, nodes, poses[0], bounds, settings);
  return {eye, view_of(eye, bounds.sphere, static_cast<double>(settings.width) / settings.height)};
}

glm::vec3 projected(const View& view, const glm::vec3& world) {
  const glm::vec4 clip = view.clip_from_eye * view.eye_from_world * glm::vec4(world, 1.0f);
  return glm::vec3(clip) / clip.w;
}

void expect_all_in_view(const Scene& scene, const RenderSettings& settings) {
  const View view = look(scene, settings).view;
  float reach = 0.0f;
  const std::span<const float> p = scene.meshes[0].primitives[0].positions.values();
  for (std::size_t i = 0; i < p.size(); i += 3) {
    const glm::vec3 ndc = projected(view, {p[i], p[i + 1], p[i + 2]});
    for (int k = 0; k < 3; ++k) EXPECT_LE(std::abs(ndc[k]), 1.0f) << i;
    reach = std::max({reach, std::abs(ndc.x), std::abs(ndc.y)});
  }
  EXPECT_GT(reach, 0.4f) << "the model must fill a good part of the frame";
}

TEST(View, FramesModelsOfAnySizeAndAnywhere) {
  for (const float size : {1e-12f, 1e-3f, 1.0f, 1e6f, 1e15f}) {
    for (const float offset : {0.0f, 100.0f}) {
      SceneBuilder builder;
      const float o = offset * size;
      builder.add_mesh_node(testing::triangles({o - size, 0, 0, o + size, 0, 0, o, size, o + size}));
      for (const glm::vec3& up :
           {glm::vec3(0, 1, 0), glm::vec3(0, 0, 1), glm::vec3(0, -1, 0), glm::vec3(-1, 0, 0)}) {
        RenderSettings settings;
        settings.camera.up = up;
        expect_all_in_view(builder.scene, settings);
        settings.width = 300;
        settings.height = 900;
        settings.camera.azimuth_deg = 70;
        expect_all_in_view(builder.scene, settings);
      }
    }
  }
}

TEST(View, ScenesWithoutExtentAreFramedToo) {
  const auto is_finite = [](const View& view) {
    for (int c = 0; c < 4; ++c) {
      for (int r = 0; r < 4; ++r) {
        if (!std::isfinite(view.clip_from_eye[c][r]) || !std::isfinite(view.eye_from_world[c][r]))
          return false;
      }
    }
    return true;
  };
  EXPECT_TRUE(is_finite(look(Scene{}, {}).view));
  SceneBuilder point;
  point.add_mesh_node(testing::triangles({5, 5, 5, 5, 5, 5, 5, 5, 5}));
  EXPECT_TRUE(is_finite(look(point.scene, {}).view));
  EXPECT_NEAR(projected(look(point.scene, {}).view, {5, 5, 5}).x, 0, 1e-3);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  SceneBuilder broken;
  broken.add_mesh_node(testing::triangles({nan, nan, nan, 0, 0, 0, 1, 0, 0, 0, 1, 0}));
  EXPECT_TRUE(is_finite(look(broken.scene, {}).view));
}

TEST(View, TheDefaultEyeIsInFrontToTheRightAndAbove) {
  const glm::dvec3 y_up = default_eye_direction({0, 1, 0});
  EXPECT_GT(y_up.x, 0.2);
  EXPECT_GT(y_up.y, 0.2);
  EXPECT_GT(y_up.z, 0.7);
  const glm::dvec3 z_up = default_eye_direction({0, 0, 1});
  EXPECT_GT(z_up.x, 0.2);
  EXPECT_GT(z_up.z, 0.2);
  EXPECT_LT(z_up.y, -0.7);
}

TEST(View, AzimuthMovesTheEyeToTheRightElevationUp) {  // as vtkCamera
  SceneBuilder builder;
  builder.add_mesh_node(testing::square());
  RenderSettings settings;
  settings.camera.position = glm::vec3(0, 0, 5);
  settings.camera.focal_point = glm::vec3(0, 0, 0);
  settings.camera.azimuth_deg = 90;
  EXPECT_NEAR(look(builder.scene, settings).eye.position.x, 5, 1e-9);
  settings.camera.azimuth_deg = 0;
  settings.camera.elevation_deg = 90;
  const Eye eye = look(builder.scene, settings).eye;
  EXPECT_NEAR(eye.position.y, 5, 1e-9);
  EXPECT_NEAR(eye.up.z, -1, 1e-9);
}

TEST(View, PositionAndFocalPointAreTakenAsGiven) {
  SceneBuilder builder;
  builder.add_mesh_node(testing::square());
  RenderSettings settings;
  settings.camera.position = glm::vec3(3, 4, 5);
  settings.camera.focal_point = glm::vec3(1, 0, 0);
  settings.camera.view_angle_deg = 40.0f;
  const Looked looked = look(builder.scene, settings);
  const glm::vec3 center = projected(looked.view, {1, 0, 0});
  EXPECT_NEAR(center.x, 0, 1e-5);
  EXPECT_NEAR(center.y, 0, 1e-5);
  EXPECT_NEAR(looked.view.clip_from_eye[1][1], 1 / std::tan(20 * M_PI / 180), 1e-5);
  // Straight down, along the up direction.
  settings.camera.position = glm::vec3(0, 9, 0);
  settings.camera.focal_point = glm::vec3(0, 0, 0);
  EXPECT_NEAR(projected(look(builder.scene, settings).view, {0, 0, 0}).x, 0, 1e-5);
  // An eye at its own focal point still looks somewhere.
  settings.camera.focal_point = settings.camera.position;
  EXPECT_TRUE(std::isfinite(look(builder.scene, settings).view.eye_from_world[3][2]));
}

/// A camera 10 in front of the square, in a node scaled by 3.
SceneBuilder with_camera(Camera::Kind kind) {
  SceneBuilder builder;
  builder.add_mesh_node(testing::square());
  Camera camera;
  camera.kind = kind;
  camera.vertical_fov_rad = 0.5f;
  camera.half_height = 2.0f;
  camera.near_plane = 1.0f;
  camera.far_plane = kind == Camera::Kind::orthographic ? 50.0f : 0.0f;
  builder.scene.cameras.push_back(camera);
  Node node;
  node.camera = 0;
  node.transform.translation = {0, 0, 10};
  node.transform.scale = {3, 3, 3};
  builder.add_node(node);
  return builder;
}

TEST(View, FileCamerasKeepTheirFieldOfViewAndIgnoreScale) {
  const SceneBuilder perspective = with_camera(Camera::Kind::perspective);
  RenderSettings settings;
  settings.width = 400;
  settings.height = 100;
  const View view = look(perspective.scene, settings).view;
  EXPECT_NEAR(view.clip_from_eye[1][1], 1 / std::tan(0.25), 1e-5);
  EXPECT_NEAR(view.clip_from_eye[0][0], view.clip_from_eye[1][1] / 4, 1e-5);
  EXPECT_NEAR(view.eye_from_world[3][2], -10, 1e-5);
  EXPECT_NEAR(view.eye_from_world[0][0], 1, 1e-6);
  const SceneBuilder parallel = with_camera(Camera::Kind::orthographic);
  EXPECT_NEAR(look(parallel.scene, settings).view.clip_from_eye[1][1], 0.5, 1e-6);
  settings.camera.ignore_file_cameras = true;
  EXPECT_NE(look(perspective.scene, settings).view.eye_from_world[3][2], -10);
}

/// The square's bounds reach 1.02·√2 before and behind it.
TEST(View, AMovedFileCameraKeepsItsPlanesOrWidensThem) {
  SceneBuilder builder = with_camera(Camera::Kind::perspective);
  builder.scene.cameras[0].near_plane = 0.01f;
  builder.scene.cameras[0].far_plane = 20.0f;
  RenderSettings settings;
  settings.camera.camera_index = 0;
  settings.camera.position = glm::vec3(0, 0, 5);
  settings.camera.focal_point = glm::vec3(0, 0, 0);
  Eye eye = look(builder.scene, settings).eye;
  EXPECT_NEAR(eye.near_plane, 0.01, 1e-6);
  EXPECT_NEAR(eye.far_plane, 20, 1e-6);
  settings.camera.position = glm::vec3(0, 0, 50);
  eye = look(builder.scene, settings).eye;
  EXPECT_NEAR(eye.near_plane, 0.01, 1e-6);
  EXPECT_GT(eye.far_plane, 51);
  builder.scene.cameras[0].near_plane = 8.0f;
  builder.scene.cameras[0].far_plane = 0.0f;
  settings.camera.position = glm::vec3(0, 0, 5);
  eye = look(builder.scene, settings).eye;
  EXPECT_LT(eye.near_plane, 4);
  EXPECT_EQ(eye.far_plane, 0) << "infinite stays infinite";
  settings.camera.orthographic_height = 2.0f;
  EXPECT_GT(look(builder.scene, settings).eye.far_plane, 6);
  settings.camera.orthographic_height.reset();
  settings.camera.camera_index = kNone;
  settings.camera.ignore_file_cameras = true;
  EXPECT_LT(look(builder.scene, settings).eye.far_plane, 7) << "not the file's";
}

TEST(View, ACameraThatIsNotThereIsNamed) {
  const SceneBuilder builder = with_camera(Camera::Kind::perspective);
  RenderSettings settings;
  settings.camera.camera_index = 1;
  try {
    look(builder.scene, settings);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("camera 1: the scene has 1 camera"), std::string::npos)
        << error.what();
  }
  settings.camera.camera_index = 0;
  settings.scene_index = 4;
  EXPECT_THROW(look(builder.scene, settings), InputError);
}

}  // namespace
}  // namespace barrido::scene
