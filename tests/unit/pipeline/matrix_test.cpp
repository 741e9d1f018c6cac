// Projections and views against what they must do to points; normal matrices against perpendicularity.
#include "pipeline/matrix.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "random.h"

namespace barrido::pipeline {
namespace {

void expect_near(const glm::vec4& a, const glm::vec4& b, float tolerance) {
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "component " << i;
}

glm::vec4 ndc(const glm::mat4& m, const glm::vec3& p) {
  const glm::vec4 clip = m * glm::vec4(p, 1.0f);
  return clip / clip.w;
}

TEST(Matrix, PerspectiveMapsTheCornersOfTheVolume) {
  const double half_height = std::tan(0.4);
  const glm::mat4 m = perspective(0.8, 2.0, 0.5, 10.0);
  const auto h = static_cast<float>(half_height);
  expect_near(ndc(m, {0.5f * h * 2, 0.5f * h, -0.5f}), {1, 1, -1, 1}, 1e-6f);
  expect_near(ndc(m, {-10 * h * 2, -10 * h, -10}), {-1, -1, 1, 1}, 1e-5f);
}

TEST(Matrix, InfinitePerspectiveIsTheLimit) {
  const glm::mat4 infinite = perspective(0.8, 1.5, 0.5, 0.0);
  const glm::mat4 far_away = perspective(0.8, 1.5, 0.5, 1e9);
  for (int c = 0; c < 4; ++c) expect_near(infinite[c], far_away[c], 1e-6f);
  EXPECT_EQ(infinite, perspective(0.8, 1.5, 0.5, std::numeric_limits<double>::infinity()));
  EXPECT_LE(ndc(infinite, {0, 0, -1e6f}).z, 1.0f);
}

TEST(Matrix, FrustumMayBeOffCentre) {
  const glm::mat4 m = frustum(-1, 3, -2, 1, 2, 20);
  expect_near(ndc(m, {-1, -2, -2}), {-1, -1, -1, 1}, 1e-6f);
  expect_near(ndc(m, {3, 1, -2}), {1, 1, -1, 1}, 1e-6f);
}

TEST(Matrix, OrthographicMapsTheBox) {
  const glm::mat4 m = orthographic(-2, 4, 1, 3, -5, 7);
  expect_near(m * glm::vec4(-2, 1, 5, 1), {-1, -1, -1, 1}, 1e-6f);
  expect_near(m * glm::vec4(4, 3, -7, 1), {1, 1, 1, 1}, 1e-6f);
}

TEST(Matrix, LookAtPutsTheFocalPointOnTheAxis) {
  const glm::dvec3 eye{1, 2, 3}, focal{-4, 0, 7};
  const glm::mat4 m = look_at(eye, focal, {0, 1, 0});
  expect_near(m * glm::vec4(eye, 1), {0, 0, 0, 1}, 1e-6f);
  expect_near(m * glm::vec4(focal, 1), {0, 0, -static_cast<float>(glm::length(focal - eye)), 1}, 1e-5f);
  const glm::vec4 up = m * glm::vec4(0, 1, 0, 0);
  EXPECT_NEAR(up.x, 0.0f, 1e-6f);
  EXPECT_GT(up.y, 0.0f);
}

TEST(Matrix, LookAtFindsAnUpWhereThereIsNone) {
  for (const glm::dvec3 forward : {glm::dvec3{0, -1, 0}, glm::dvec3{0, 0, 1}, glm::dvec3{0, 0, 0}}) {
    const glm::mat4 m = look_at({0, 0, 0}, forward, forward);
    EXPECT_NEAR(glm::determinant(m), 1.0f, 1e-6f);
  }
}

TEST(Matrix, RotationTurnsCounterClockwise) {
  expect_near(rotation(M_PI / 2, {0, 0, 5}) * glm::vec4(1, 0, 0, 1), {0, 1, 0, 1}, 1e-6f);
  expect_near(rotation(M_PI / 2, {1, 0, 0}) * glm::vec4(0, 1, 0, 1), {0, 0, 1, 1}, 1e-6f);
  expect_near(rotation(2 * M_PI / 3, {1, 1, 1}) * glm::vec4(1, 0, 0, 1), {0, 1, 0, 1}, 1e-6f);
  EXPECT_EQ(rotation(1.0, {0, 0, 0}), glm::mat4(1.0f));
}

TEST(Matrix, NormalsStayPerpendicularToTheirSurface) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    glm::mat4 m(1.0f);
    for (int c = 0; c < 3; ++c) m[c] = glm::vec4(random.vec3(-2, 2), 0.0f);
    if (i % 5 == 0) m[2] = m[0] + m[1];  // singular: space is flattened
    const glm::dvec3 a(random.vec3(-1, 1)), b(random.vec3(-1, 1));
    const glm::dvec3 normal = normal_matrix(m) * glm::cross(a, b);
    const glm::dmat3 linear(m);
    EXPECT_NEAR(glm::dot(normal, linear * a), 0.0, 1e-5 * glm::length(normal));
    EXPECT_NEAR(glm::dot(normal, linear * b), 0.0, 1e-5 * glm::length(normal));
  }
}

TEST(Matrix, RefusesEmptyVolumes) {
  EXPECT_THROW(perspective(0.0, 1.0, 0.1, 1.0), std::invalid_argument);
  EXPECT_THROW(perspective(M_PI, 1.0, 0.1, 1.0), std::invalid_argument);
  EXPECT_THROW(perspective(1.0, 0.0, 0.1, 1.0), std::invalid_argument);
  EXPECT_THROW(frustum(-1, 1, -1, 1, 0.0, 1.0), std::invalid_argument);
  EXPECT_THROW(frustum(-1, 1, -1, 1, 2.0, 1.0), std::invalid_argument);
  EXPECT_THROW(orthographic(1, 1, -1, 1, 0, 1), std::invalid_argument);
}

}  // namespace
}  // namespace barrido::pipeline
