// The four ways to spread the illumination model over polygons (course S1, S4, S6, S7, S10), on a bumpy patch
// seen in perspective. Every pixel is predicted from the triangle's vertices by barycentric coordinates in
// double precision; nothing is interpolated step by step.
//
// Tolerance. Positions are rounded to 1/256 pixel, so a pixel sees values from up to √2/512 = 0.0028 pixel
// away. The patch's triangles are at least 25 pixels high: colours that change by at most C over one move by
// at most C·0.0028/25·2 = 2.2e-4·C; float arithmetic adds some 1e-6. Pixels within 1/100 pixel of an edge are
// left out.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "pipeline/matrix.h"
#include "tests/oracle/harness.h"

namespace barrido::oracle {
namespace {

constexpr int kWidth = 200, kHeight = 150;
constexpr double kMargin = 0.01;
constexpr double kTolerance = 2.2e-4;

/// 5 × 4 cells that overfill the view, with random depths and normals; no part hides another.
DrawnMesh patch_mesh() {
  constexpr std::uint32_t kColumns = 5, kRows = 4;
  std::mt19937 random(7);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() % 65536) / 65535.0;
  };
  DrawnMesh mesh;
  for (std::uint32_t j = 0; j <= kRows; ++j) {
    for (std::uint32_t i = 0; i <= kColumns; ++i) {
      // A position is a point of the image plane times its depth: the picture of the grid stays a grid.
      const double z = uniform(3.0, 6.0);
      const glm::dvec3 p((i * 2.0 / kColumns - 1.0) * 0.80 * z, (j * 2.0 / kRows - 1.0) * 0.60 * z, -z);
      mesh.add(p, glm::normalize(glm::dvec3(uniform(-0.7, 0.7), uniform(-0.7, 0.7), 1.0)));
    }
  }
  for (std::uint32_t j = 0; j < kRows; ++j) {
    for (std::uint32_t i = 0; i < kColumns; ++i) {
      const std::uint32_t a = j * (kColumns + 1) + i, b = a + kColumns + 1;
      mesh.indices.insert(mesh.indices.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
  }
  return mesh;
}

OracleModel model_with(bool phong, double n) {
  OracleModel model;
  model.ambient = {0.1, 0.1, 0.2};
  model.material.ka = model.material.kd = {0.7, 0.5, 0.4};
  model.material.ks = {0.5, 0.4, 0.3};
  model.material.n = n;
  model.phong = phong;
  model.local_viewer = true;
  OracleLight lamp;
  lamp.position = {0.5, 1.5, 0.5, 1.0};
  lamp.color = {2.0, 1.8, 1.6};
  lamp.kl = 0.3;
  OracleLight sun;
  sun.position = {-0.5, 0.3, 0.8, 0.0};
  sun.color = {0.4, 0.4, 0.5};
  model.lights = {lamp, sun};
  return model;
}

struct PatchView {
  DrawnMesh drawn = patch_mesh();
  pipeline::State state;
  OracleModel model;

  explicit PatchView(pipeline::ShadeModel shading, bool phong = false, double n = 8)
      : model(model_with(phong, n)) {
    state.clip_from_eye = pipeline::perspective(2 * std::atan(0.55), double(kWidth) / kHeight, 1.0, 20.0);
    state.shade_model = shading;
    state.depth.test = true;
    set_lighting(state, model);
  }
  OracleMesh mesh() const {
    return {drawn.rounded_positions(), drawn.indices, glm::dmat4(state.clip_from_eye), kWidth, kHeight};
  }
};

/// Compares all pixels with what `predict(mesh, hit)` says.
template <class Predict>
Comparison compare(const PatchView& setup, Predict&& predict) {
  FloatFrame frame(kWidth, kHeight);
  frame.draw(setup.state, setup.drawn.geometry());
  const OracleMesh mesh = setup.mesh();
  Comparison comparison;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const OracleMesh::Hit hit = mesh.at(x + 0.5, y + 0.5, kMargin);
      if (hit.triangle >= 0) comparison.add(x, y, glm::dvec3(frame.at(x, y)), predict(mesh, hit));
    }
  }
  EXPECT_GT(comparison.compared, kWidth * kHeight * 9 / 10);
  return comparison;
}

std::vector<glm::dvec3> vertex_colors(const PatchView& setup) {
  const std::vector<glm::dvec3> p = setup.drawn.rounded_positions(), n = setup.drawn.rounded_normals();
  std::vector<glm::dvec3> colors;
  for (std::size_t i = 0; i < p.size(); ++i)
    colors.push_back(illuminated(setup.model, p[i], glm::normalize(n[i])));
  return colors;
}

TEST(ShadingOracle, FlatAtTheCentroid) {  // S1, the course
  PatchView setup(pipeline::ShadeModel::flat);
  setup.state.flat_at = pipeline::FlatAt::centroid;
  const std::vector<glm::dvec3> normals = setup.drawn.rounded_normals();
  const Comparison comparison = compare(setup, [&](const OracleMesh& mesh, const OracleMesh::Hit& hit) {
    const glm::dvec3 third(1.0 / 3.0);
    const glm::dvec3 p = mixed(mesh, hit.triangle, third, mesh.positions());
    const glm::dvec3 n = glm::normalize(mixed(mesh, hit.triangle, third, normals));
    return illuminated(setup.model, p, n);
  });
  EXPECT_LE(comparison.largest, 2e-6);  // one float evaluation a triangle, nothing interpolated
}

TEST(ShadingOracle, FlatAtTheProvokingVertex) {  // S1, OpenGL
  PatchView setup(pipeline::ShadeModel::flat);
  setup.state.flat_at = pipeline::FlatAt::provoking_vertex;
  const std::vector<glm::dvec3> colors = vertex_colors(setup);
  const Comparison comparison = compare(setup, [&](const OracleMesh& mesh, const OracleMesh::Hit& hit) {
    return colors[mesh.vertex(hit.triangle, 2)];
  });
  EXPECT_LE(comparison.largest, 2e-6);
}

TEST(ShadingOracle, Gouraud) {  // S4, perspective-correct
  const PatchView setup(pipeline::ShadeModel::gouraud);
  const std::vector<glm::dvec3> colors = vertex_colors(setup);
  const Comparison comparison = compare(setup, [&](const OracleMesh& mesh, const OracleMesh::Hit& hit) {
    return mixed(mesh, hit.triangle, hit.weights, colors);
  });
  EXPECT_LE(comparison.largest, kTolerance);
}

TEST(ShadingOracle, GouraudLinearOnTheScreen) {  // S10
  PatchView setup(pipeline::ShadeModel::gouraud);
  setup.state.color_interpolation = pipeline::ColorInterpolation::screen;
  const std::vector<glm::dvec3> colors = vertex_colors(setup);
  Comparison correct;
  const Comparison screen = compare(setup, [&](const OracleMesh& mesh, const OracleMesh::Hit& hit) {
    const glm::dvec3 color = mixed(mesh, hit.triangle, hit.screen, colors);
    correct.add(0, 0, color, mixed(mesh, hit.triangle, hit.weights, colors));
    return color;
  });
  EXPECT_LE(screen.largest, kTolerance);
  EXPECT_GT(correct.largest, 0.02) << "the two interpolations must differ visibly here";
}

TEST(ShadingOracle, Phong) {  // S6: normals and positions interpolated, the whole model per pixel
  for (const bool phong : {false, true}) {
    const PatchView setup(pipeline::ShadeModel::phong, phong, 20);
    const std::vector<glm::dvec3> normals = setup.drawn.rounded_normals();
    const Comparison comparison = compare(setup, [&](const OracleMesh& mesh, const OracleMesh::Hit& hit) {
      const glm::dvec3 p = mixed(mesh, hit.triangle, hit.weights, mesh.positions());
      const glm::dvec3 n = glm::normalize(mixed(mesh, hit.triangle, hit.weights, normals));
      return illuminated(setup.model, p, n);
    });
    EXPECT_LE(comparison.largest, 2 * kTolerance);  // a highlight is steeper than its triangle is high
  }
}

/// Cheap Phong's prediction: dot products at the vertices, interpolated with their signs; the model from
/// them. A light's attenuation f goes along as f·(N·L) and, so that the n-th power brings it back,
/// f^(1/n)·(R·V).
Comparison compare_cheap_phong(const PatchView& setup, bool power_at_vertex) {
  const std::vector<glm::dvec3> p = setup.drawn.rounded_positions(), n = setup.drawn.rounded_normals();
  const OracleMaterial& m = setup.model.material;
  std::vector<std::vector<glm::dvec3>> dots(setup.model.lights.size());
  for (std::size_t l = 0; l < dots.size(); ++l) {
    for (std::size_t v = 0; v < p.size(); ++v) {
      const OracleLight& light = setup.model.lights[l];
      const Dots at = dots_at(setup.model, light, p[v], glm::normalize(n[v]));
      const double f = attenuation(light, p[v]);
      dots[l].emplace_back(f * at.diffuse,
                           power_at_vertex ? f * highlight_of(at, m.n) : std::pow(f, 1 / m.n) * at.highlight,
                           0);
    }
  }
  return compare(setup, [&](const OracleMesh& mesh, const OracleMesh::Hit& hit) {
    glm::dvec3 color = setup.model.ambient * m.ka;
    for (std::size_t l = 0; l < dots.size(); ++l) {
      const glm::dvec3 mix = mixed(mesh, hit.triangle, hit.weights, dots[l]);
      const Dots d{mix.x, mix.y};
      color += setup.model.lights[l].color * (m.kd * std::max(d.diffuse, 0.0) +
                                              m.ks * (power_at_vertex ? d.highlight : highlight_of(d, m.n)));
    }
    return color;
  });
}

TEST(ShadingOracle, CheapPhongWithThePowerPerPixel) {  // S7
  for (const bool phong : {false, true}) {
    PatchView setup(pipeline::ShadeModel::cheap_phong, phong, 10);
    setup.state.cheap_phong_power = pipeline::CheapPhongPower::pixel;
    EXPECT_LE(compare_cheap_phong(setup, false).largest, 2 * kTolerance);
  }
}

TEST(ShadingOracle, CheapPhongWithThePowerAtTheVertices) {  // S7
  for (const bool phong : {false, true}) {
    PatchView setup(pipeline::ShadeModel::cheap_phong, phong, 10);
    setup.state.cheap_phong_power = pipeline::CheapPhongPower::vertex;
    EXPECT_LE(compare_cheap_phong(setup, true).largest, kTolerance);
  }
}

}  // namespace
}  // namespace barrido::oracle
