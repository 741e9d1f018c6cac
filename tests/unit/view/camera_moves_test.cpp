// What the mouse does to a camera, against what a hand expects.
#include "viewer/view/camera_moves.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "raster/base/portable_math.h"

namespace barrido::view {
namespace {

const glm::dvec3 kUp(0, 1, 0);

scene::Eye front_eye() {
  scene::Eye eye;
  eye.position = {0, 0, 10};
  eye.focal_point = {0, 0, 0};
  eye.vertical_fov_rad = radians(30.0);
  return eye;
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-9) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(CameraMoves, OrbitTurnsTheEyeAboutTheFocalPoint) {
  scene::Eye eye = front_eye();
  orbit(eye, kUp, 90, 0);
  expect_near(eye.position, {10, 0, 0});
  eye = front_eye();
  orbit(eye, kUp, 0, 30);
  expect_near(eye.position, {0, 5, 10 * std::sqrt(0.75)});
  expect_near(eye.focal_point, {0, 0, 0});
}

TEST(CameraMoves, OrbitStopsShortOfThePolesAndComesBack) {
  scene::Eye eye = front_eye();
  orbit(eye, kUp, 0, 500);
  EXPECT_GT(eye.position.y, 9.99);
  EXPECT_GT(eye.position.z, 0.0);
  orbit(eye, kUp, 0, -89.5);
  expect_near(eye.position, {0, 0, 10});
  look_from(eye, StandardView::top, {{0, 0, 0}, 1.0}, kUp, 1.0);
  const double height = eye.position.y;
  orbit(eye, kUp, 0, -90);
  expect_near(eye.position, {0, 0, height});  // down to the front, where the bottom of the top view was
}

TEST(CameraMoves, ManySmallTurnsAreOneLargeTurn) {
  scene::Eye small = front_eye(), large = front_eye();
  for (int i = 0; i < 100; ++i) orbit(small, kUp, 0.5, 0.25);
  orbit(large, kUp, 50, 25);
  expect_near(small.position, large.position, 1e-6);
}

TEST(CameraMoves, PanMovesTheSceneByPartsOfThePicture) {
  scene::Eye eye = front_eye();
  const double height = 2 * 10 * std::tan(radians(15.0));
  EXPECT_NEAR(height_at_focus(eye), height, 1e-9);
  pan(eye, 0.5, 0.25);
  expect_near(eye.focal_point, {-0.5 * height, -0.25 * height, 0});
  expect_near(eye.position, {-0.5 * height, -0.25 * height, 10});
}

TEST(CameraMoves, ZoomDividesWhatIsSeen) {
  scene::Eye eye = front_eye();
  zoom(eye, 2.0);
  expect_near(eye.position, {0, 0, 5});
  eye.orthographic = true;
  eye.half_height = 3.0;
  zoom(eye, 2.0);
  expect_near(eye.position, {0, 0, 5});
  EXPECT_EQ(eye.half_height, 1.5);
  eye = front_eye();
  for (int i = 0; i < 10000; ++i) zoom(eye, 8.0);
  EXPECT_GT(eye.position.z, 0.0);
  for (int i = 0; i < 10000; ++i) zoom(eye, 1.0 / 8.0);
  EXPECT_TRUE(std::isfinite(static_cast<float>(eye.position.z) * static_cast<float>(eye.position.z)));
}

TEST(CameraMoves, OrthographicKeepsTheSizeAtTheFocalPoint) {
  scene::Eye eye = front_eye();
  const double height = height_at_focus(eye);
  toggle_orthographic(eye);
  EXPECT_TRUE(eye.orthographic);
  EXPECT_NEAR(height_at_focus(eye), height, 1e-12);
  zoom(eye, 3.0);
  toggle_orthographic(eye);
  EXPECT_FALSE(eye.orthographic);
  EXPECT_NEAR(height_at_focus(eye), height / 3.0, 1e-9);
  expect_near(eye.position, {0, 0, 10.0 / 3.0});
}

TEST(CameraMoves, StandardViewsSeeTheWholeSphere) {
  const scene::Sphere bounds{{1, 2, 3}, 2.0};
  const std::pair<StandardView, glm::dvec3> sides[] = {
      {StandardView::front, {0, 0, 1}},
      {StandardView::right, {1, 0, 0}},
      {StandardView::top, {0, 1, 0}},
      {StandardView::isometric, glm::dvec3(std::sqrt(1.0 / 3.0))}};
  for (const auto& [side, direction] : sides) {
    for (const double aspect : {0.5, 1.0, 2.0}) {
      scene::Eye eye = front_eye();
      look_from(eye, side, bounds, kUp, aspect);
      expect_near(eye.focal_point, bounds.center);
      const glm::dvec3 offset = eye.position - bounds.center;
      const double distance = glm::length(offset);
      expect_near(offset / distance, direction);
      // The sphere's silhouette is inside the narrower half angle.
      const double half_angle = std::atan(std::tan(radians(15.0)) * std::min(1.0, aspect));
      EXPECT_LT(std::asin(bounds.radius / distance), half_angle);
      EXPECT_GT(std::asin(bounds.radius / distance), half_angle * 0.9);
    }
  }
}

TEST(CameraMoves, ChoiceHoldsOnlyWhatIsNeeded) {
  scene::CameraChoice choice;
  set_camera(choice, front_eye(), false);
  EXPECT_EQ(choice.position, glm::dvec3(0, 0, 10));
  EXPECT_TRUE(choice.ignore_file_cameras);
  EXPECT_FALSE(choice.view_up);
  EXPECT_FALSE(choice.view_angle_deg);
  EXPECT_FALSE(choice.orthographic_height);

  scene::Eye eye = front_eye();
  roll(eye, 90);
  eye.vertical_fov_rad = radians(60.0);
  set_camera(choice, eye, false);
  ASSERT_TRUE(choice.view_up);
  EXPECT_NEAR(std::abs(choice.view_up->x), 1.0, 1e-6);
  EXPECT_NEAR(choice.view_angle_deg.value(), 60.0, 1e-4);
  orbit(eye, kUp, 20, 10);
  set_camera(choice, eye, false);
  EXPECT_TRUE(choice.view_up) << "a roll is kept";
  roll(eye, -90);
  set_camera(choice, eye, false);
  EXPECT_FALSE(choice.view_up) << "and goes when it is undone";
}

TEST(CameraMoves, AFileCamerasLensIsWrittenOut) {
  scene::CameraChoice choice;
  set_camera(choice, front_eye(), true);
  EXPECT_TRUE(choice.view_angle_deg);
}

TEST(CameraMoves, OrbitFromBelowAnUpAxisOfItsOwnStaysLevel) {
  const glm::dvec3 up(0, 0, 1);
  scene::Eye eye = front_eye();
  eye.position = {0, -10, 0};
  eye.up = up;
  orbit(eye, up, 37, 25);
  scene::CameraChoice choice;
  choice.up = {0, 0, 1};
  set_camera(choice, eye, false);
  EXPECT_FALSE(choice.view_up);
  EXPECT_NEAR(eye.position.z, 10 * std::sin(radians(25.0)), 1e-9);
}

}  // namespace
}  // namespace barrido::view
