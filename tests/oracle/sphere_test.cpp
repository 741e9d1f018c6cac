// A sphere under lights, Phong-shaded, against the closed form (course L1 to L6, L9, V5). The sphere is seen
// by parallel rays, so that the normal at a pixel is known exactly: ((x − cx)/r, (y − cy)/r, …).
//
// Tolerance. With 384 × 192 facets two neighbouring normals are h = 2π/384 = 0.0164 apart; within a facet the
// interpolated normal deviates from the true one by at most about h²/8 = 3.3e-5, and the surface lies as much
// inside the sphere. Rounding a position to 1/256 pixel moves it by 2.4e-5. Seen at an angle both are divided
// by N_z, and pixels with N_z > 0.25 are compared: the direction is known to δ = 2.3e-4, and so is N·L. cos^n
// is steepest where its slope is 0.61·√n, and R turns twice as fast as N. The highlights lie where N_z > 0.8,
// so that δ = 6e-5 there: √n·1.2·δ·k_s with k_s ≤ 0.6.
#include <cmath>

#include <gtest/gtest.h>

#include "pipeline/matrix.h"
#include "tests/oracle/harness.h"

namespace barrido::oracle {
namespace {

constexpr int kSize = 176;
constexpr double kRadius = 1.0;
constexpr double kDepth = 5.0;     // of the sphere's centre
constexpr double kHalfView = 1.1;  // of the orthographic view
constexpr double kLeastNormalZ = 0.25;

DrawnMesh sphere_mesh() {
  constexpr int kSlices = 384, kStacks = 192;
  DrawnMesh mesh;
  for (int j = 0; j <= kStacks; ++j) {
    const double theta = M_PI * j / kStacks;
    for (int i = 0; i <= kSlices; ++i) {
      const double phi = 2 * M_PI * i / kSlices;
      const glm::dvec3 n(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi));
      mesh.add(n * kRadius + glm::dvec3(0, 0, -kDepth), n);
    }
  }
  for (std::uint32_t j = 0; j < kStacks; ++j) {
    for (std::uint32_t i = 0; i < kSlices; ++i) {
      const std::uint32_t a = j * (kSlices + 1) + i, b = a + kSlices + 1;
      mesh.indices.insert(mesh.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
    }
  }
  return mesh;
}

pipeline::State sphere_state(const OracleModel& model) {
  pipeline::State state;
  state.clip_from_eye = pipeline::orthographic(-kHalfView, kHalfView, -kHalfView, kHalfView, 1.0, 10.0);
  state.shade_model = pipeline::ShadeModel::phong;
  state.cull_face = pipeline::CullFace::back;
  state.depth.test = true;
  set_lighting(state, model);
  return state;
}

/// Where a light just rises, whether a highlight counts hangs on the last bit of N·L.
bool is_on_terminator(const OracleModel& model, const glm::dvec3& p, const glm::dvec3& n) {
  for (const OracleLight& light : model.lights) {
    const glm::dvec3 offset = glm::dvec3(light.position) - p * light.position.w;
    if (std::abs(glm::dot(glm::normalize(offset), n)) < 2e-3) return true;
  }
  return false;
}

/// Draws the sphere under `model` and compares every pixel that is not too near the silhouette.
Comparison compare_sphere(const OracleModel& model) {
  static const DrawnMesh mesh = sphere_mesh();
  FloatFrame frame(kSize, kSize);
  frame.draw(sphere_state(model), mesh.geometry());
  Comparison comparison;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const double px = ((x + 0.5) / kSize * 2 - 1) * kHalfView, py = ((y + 0.5) / kSize * 2 - 1) * kHalfView;
      const double z2 = 1.0 - (px * px + py * py) / (kRadius * kRadius);
      if (z2 < kLeastNormalZ * kLeastNormalZ) continue;
      const glm::dvec3 n(px / kRadius, py / kRadius, std::sqrt(z2));
      const glm::dvec3 p = n * kRadius + glm::dvec3(0, 0, -kDepth);
      if (is_on_terminator(model, p, n)) continue;
      comparison.add(x, y, glm::dvec3(frame.at(x, y)), illuminated(model, p, n));
    }
  }
  EXPECT_GT(comparison.compared, 15000);
  return comparison;
}

OracleModel matte() {
  OracleModel model;
  model.ambient = {0.2, 0.25, 0.3};
  model.material.ka = model.material.kd = {0.8, 0.5, 0.3};
  return model;
}

OracleLight from(const glm::dvec3& direction, const glm::dvec3& color = {1, 1, 1}) {
  OracleLight light;
  light.position = glm::dvec4(direction, 0.0);
  light.color = color;
  return light;
}

constexpr double kDiffuseTolerance = 3e-4;
double highlight_tolerance(double n) { return kDiffuseTolerance + std::sqrt(n) * 4.5e-5; }

TEST(SphereOracle, AmbientAloneIsADisc) {  // L1
  const Comparison comparison = compare_sphere(matte());
  EXPECT_LE(comparison.largest, 1e-6);  // a constant
}

TEST(SphereOracle, Lambert) {  // L2, L6
  OracleModel model = matte();
  model.lights = {from({0.5, 0.6, 0.4}, {1.0, 0.9, 0.7})};
  EXPECT_LE(compare_sphere(model).largest, kDiffuseTolerance);
  model.lights = {from({0.7, 0.3, -0.6})};  // most of what is seen is turned away
  EXPECT_LE(compare_sphere(model).largest, kDiffuseTolerance);
}

TEST(SphereOracle, PhongHighlight) {  // L3
  for (const double n : {1.0, 5.0, 20.0, 80.0, 200.0}) {
    OracleModel model = matte();
    model.phong = true;
    model.material.ks = {0.5, 0.5, 0.5};
    model.material.n = n;
    model.lights = {from({-0.4, 0.5, 0.8}, {1.0, 0.8, 0.6})};
    EXPECT_LE(compare_sphere(model).largest, highlight_tolerance(n)) << "n = " << n;
  }
}

TEST(SphereOracle, BlinnHighlight) {  // L9
  for (const double n : {1.0, 32.0, 128.0}) {
    OracleModel model = matte();
    model.material.ks = {0.6, 0.6, 0.6};
    model.material.n = n;
    model.lights = {from({-0.4, 0.5, 0.8})};
    EXPECT_LE(compare_sphere(model).largest, highlight_tolerance(n)) << "n = " << n;
  }
}

TEST(SphereOracle, LocalViewer) {
  for (const bool phong : {false, true}) {
    OracleModel model = matte();
    model.phong = phong;
    model.local_viewer = true;
    model.material.ks = {0.6, 0.6, 0.6};
    model.material.n = 30;
    model.lights = {from({0.3, 0.2, 0.9})};
    EXPECT_LE(compare_sphere(model).largest, highlight_tolerance(30));
  }
}

TEST(SphereOracle, DistanceAttenuation) {  // L4
  const glm::dvec4 place(1.2, 0.8, -3.0, 1.0);
  OracleLight course;  // I_p/(d + d0)
  course.position = place;
  course.kc = 0.5;
  course.kl = 1;
  OracleLight physical;  // I_p/(4π d²)
  physical.position = place;
  physical.color = glm::dvec3(20);
  physical.kc = 0;
  physical.kq = 4 * M_PI;
  OracleLight opengl;
  opengl.position = place;
  opengl.kc = 0.3;
  opengl.kl = 0.2;
  opengl.kq = 0.1;
  for (const OracleLight& light : {course, physical, opengl}) {
    OracleModel model = matte();
    model.lights = {light};
    // 20/(4π d²) with d ≥ 0.9 reaches 2: the tolerance grows with the brightness.
    EXPECT_LE(compare_sphere(model).largest, 2.5 * kDiffuseTolerance);
  }
}

TEST(SphereOracle, SeveralLights) {  // L5, V5
  OracleModel model = matte();
  model.phong = true;
  model.material.ks = {0.3, 0.3, 0.3};
  model.material.n = 15;
  OracleLight lamp;
  lamp.position = {-1.5, 0.5, -3.5, 1.0};
  lamp.color = {0.2, 0.5, 0.9};
  lamp.kq = 0.2;
  model.lights = {from({0.6, 0.4, 0.7}, {0.7, 0.6, 0.5}), from({-0.8, 0.1, 0.3}, {0.1, 0.2, 0.4}), lamp,
                  from({0.0, -1.0, 0.3}, {-0.15, -0.1, -0.05})};
  EXPECT_LE(compare_sphere(model).largest, highlight_tolerance(15));
}

TEST(SphereOracle, ValuesOverTheMaximumSurvive) {  // L8
  OracleModel model = matte();
  model.lights = {from({0.1, 0.2, 1.0}, {4, 3, 2})};
  EXPECT_LE(compare_sphere(model).largest, 4 * kDiffuseTolerance);
}

}  // namespace
}  // namespace barrido::oracle
