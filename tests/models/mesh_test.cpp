#include "models/tool/mesh.h"

#include <gtest/gtest.h>

#include "tests/models/mesh_checks.h"

namespace barrido::models {
namespace {

constexpr double kPi = 3.14159265358979323846;

TEST(Mesh, GridFacesItsFront) {
  const Mesh grid = make_grid({0, 0, 0}, {2, 0, 0}, {0, -1, 0}, 3, 2, {4, 5});
  expect_sound(grid);
  EXPECT_EQ(grid.positions.size(), 12u);
  EXPECT_EQ(grid.indices.size(), 36u);
  EXPECT_EQ(grid.normals.front(), Vec3(0, 0, 1));
  EXPECT_EQ(grid.texcoords.back(), Vec2(4, 5));
}

TEST(Mesh, SphereIsClosedAndOutside) {
  const Mesh sphere = make_sphere(2.0, 64, 32);
  expect_sound(sphere);
  // The inscribed polyhedron is a little smaller than the ball.
  const double ball = 4.0 / 3.0 * kPi * 8.0;
  EXPECT_LT(signed_volume(sphere), ball);
  EXPECT_GT(signed_volume(sphere), 0.99 * ball);
  EXPECT_EQ(sphere.indices.size(), 3u * 2u * 64u * 31u);  // no triangles without area at the poles
}

TEST(Mesh, TorusIsClosedAndOutside) {
  const Mesh torus = make_torus(1.0, 0.25, 64, 48, {1, 1});
  expect_sound(torus);
  const double exact = 2.0 * kPi * kPi * 0.25 * 0.25;
  EXPECT_NEAR(signed_volume(torus), exact, 0.01 * exact);
}

TEST(Mesh, BoxStandsOnTheFloor) {
  const Mesh box = make_standing_box({1, 0, 2}, {0.6, 0, 0.8}, {2, 3, 4});
  expect_sound(box);
  for (const Vec3& p : box.positions) {
    EXPECT_GE(p.y, 0.0);
    EXPECT_LE(p.y, 3.0);
  }
  // The open bottom adds nothing: it lies in the plane through the origin.
  EXPECT_NEAR(signed_volume(box), 24.0, 1e-9);
}

}  // namespace
}  // namespace barrido::models
