// The illumination model on vectors compared with the plain equation in double precision, for random lights
// and materials of every kind, on every path: full model, cheap Phong, tracked colours, both sides.
#include "pipeline/illumination.h"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "pipeline/cheap_phong.h"
#include "pipeline/vertex_batch.h"
#include "random_lighting.h"
#include "tests/oracle/illumination.h"

namespace barrido::pipeline {
namespace {

/// Points of one side with room for their colours.
struct Points {
  int count = 37;  // no multiple of any vector width
  bool back = false;
  alignas(64) BatchArray normal[3], position[3], color[4], lit[7];
  alignas(64) BatchArray dots[11];

  Points(Random& random, bool seen_from_behind) : back(seen_from_behind) {
    for (int i = 0; i < kVertexBatch; ++i) {
      const glm::vec3 n = random_direction(random);
      const glm::vec3 p = random.vec3(-4, 4) + glm::vec3(0, 0, -6);
      const glm::vec4 c = random.vec4(0, 1);
      for (int k = 0; k < 3; ++k) {
        normal[k][i] = n[k];
        position[k][i] = p[k];
      }
      for (int k = 0; k < 4; ++k) color[k][i] = c[k];
    }
  }

  SurfacePoints surface() const {
    return {count,
            {normal[0], normal[1], normal[2]},
            {position[0], position[1], position[2]},
            {color[0], color[1], color[2], color[3]},
            false,
            back};
  }
  LitColors out() { return {{lit[0], lit[1], lit[2], lit[3]}, {lit[4], lit[5], lit[6]}}; }

  oracle::Point at(int i) const {
    return {{normal[0][i], normal[1][i], normal[2][i]},
            {position[0][i], position[1][i], position[2][i]},
            {color[0][i], color[1][i], color[2][i], color[3][i]},
            back};
  }
};

/// Near the edge of a cone or the terminator a highlight switches on or off, and rounding decides where.
bool is_on_an_edge(const Lighting& lighting, const oracle::Point& point) {
  for (const Light& light : lighting.lights) {
    double d = 0.0;
    const glm::dvec3 l = oracle::direction(light, point.position, d);
    if (std::abs(glm::dot(point.normal, l)) < 1e-5) return true;
    const double c = -glm::dot(l, glm::normalize(glm::dvec3(light.spot_direction)));
    if (light.spot_cutoff_deg != 180.0f &&
        std::abs(c - std::cos(light.spot_cutoff_deg * M_PI / 180)) < 1e-5) {
      return true;
    }
  }
  return false;
}

void expect_colors(const Lighting& lighting, const Points& points, double tolerance) {
  for (int i = 0; i < points.count; ++i) {
    const oracle::Point point = points.at(i);
    if (is_on_an_edge(lighting, point)) continue;
    const oracle::Color expected = oracle::illuminate(lighting, point);
    for (int c = 0; c < 3; ++c) {
      ASSERT_NEAR(points.lit[c][i], expected.primary[c], tolerance) << "primary, point " << i;
      if (lighting.separate_specular) {
        ASSERT_NEAR(points.lit[4 + c][i], expected.secondary[c], tolerance) << "secondary, point " << i;
      }
    }
    ASSERT_NEAR(points.lit[3][i], expected.alpha, 1e-6);
  }
}

TEST(Illumination, AgreesWithThePlainEquationInDoublePrecision) {
  Random random(1);
  for (int scene = 0; scene < 400; ++scene) {
    SCOPED_TRACE("scene " + std::to_string(scene));
    const Lighting lighting = random_lighting(random);
    Points points(random, random.chance(0.5));
    const Illumination illumination = compile_illumination(lighting, nullptr);
    illuminate(illumination, points.surface(), points.out());
    expect_colors(lighting, points, 3e-5);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

TEST(Illumination, CheapPhongIsTheFullModelWhereNothingIsInterpolated) {
  Random random(2);
  for (int scene = 0; scene < 400; ++scene) {
    SCOPED_TRACE("scene " + std::to_string(scene));
    const Lighting lighting = random_lighting(random);
    Points points(random, random.chance(0.5));
    Illumination illumination = compile_illumination(lighting, nullptr);
    if (random.chance(0.5)) illumination.cheap_phong_power = CheapPhongPower::vertex;
    std::vector<float*> columns;
    for (int i = 0; i < cheap_phong_varyings(illumination); ++i) columns.push_back(points.dots[i]);
    cheap_phong_dots(illumination, points.surface(), columns);
    const std::vector<const float*> read(columns.begin(), columns.end());
    const SurfacePoints surface = points.surface();
    cheap_phong_colors(illumination, {points.count, points.back, read, surface.color}, points.out());
    expect_colors(lighting, points, 2e-4);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

TEST(Illumination, ConstantColorTakesThePlaceOfTheMaterial) {
  Lighting lighting;
  lighting.color_material = ColorMaterial::ambient_and_diffuse;
  lighting.ambient = {0.5f, 0.5f, 0.5f, 1};
  const glm::vec4 color{0.2f, 0.4f, 0.6f, 0.25f};
  const Illumination illumination = compile_illumination(lighting, &color);
  EXPECT_FALSE(illumination.tracks_color);
  Random random(3);
  Points points(random, false);
  illuminate(illumination, points.surface(), points.out());
  EXPECT_FLOAT_EQ(points.lit[1][0], 0.2f);
  EXPECT_FLOAT_EQ(points.lit[3][0], 0.25f);
}

TEST(Illumination, NormalsOfAnyLengthAreNormalizedWhenAskedFor) {
  Random random(4);
  const Lighting lighting = [&random] {
    Lighting l = random_lighting(random);
    l.lights = {random_light(random), random_light(random)};
    return l;
  }();
  Points points(random, false);
  const Illumination illumination = compile_illumination(lighting, nullptr);
  SurfacePoints surface = points.surface();
  surface.normalize = true;
  Points unit = points;
  for (int i = 0; i < points.count; ++i) {
    for (auto& axis : points.normal) axis[i] *= 0.01f * static_cast<float>(i + 1);
  }
  surface.normal = {points.normal[0], points.normal[1], points.normal[2]};
  illuminate(illumination, surface, points.out());
  illuminate(illumination, unit.surface(), unit.out());
  for (int i = 0; i < points.count; ++i) EXPECT_NEAR(points.lit[0][i], unit.lit[0][i], 1e-4);
}

TEST(Illumination, DegenerateInputStaysFinite) {
  Lighting lighting;
  lighting.enabled = true;
  Light at_the_point;
  at_the_point.position = {0, 0, -1, 1};
  at_the_point.constant_attenuation = 0.0f;
  at_the_point.quadratic_attenuation = 1.0f;
  Light huge;
  huge.diffuse = glm::vec4(std::numeric_limits<float>::infinity());
  huge.specular = glm::vec4(std::numeric_limits<float>::quiet_NaN());
  huge.position = {1e38f, 1e38f, 1e38f, 1};
  Light nowhere;
  nowhere.position = {0, 0, 0, 0};
  nowhere.spot_direction = {0, 0, 0};
  nowhere.spot_cutoff_deg = 45.0f;
  lighting.lights = {at_the_point, huge, nowhere};
  lighting.local_viewer = true;
  lighting.front.specular = glm::vec4(1e38f);
  lighting.front.shininess = std::numeric_limits<float>::infinity();
  Random random(5);
  Points points(random, false);
  const float values[] = {0.0f, 1e12f, -1e12f, 1e-30f};
  for (int i = 0; i < points.count; ++i) {
    for (int k = 0; k < 3; ++k) {
      points.normal[k][i] = values[(i + k) % 4];
      points.position[k][i] = i == 0 ? (k == 2 ? -1.0f : 0.0f) : values[(i / 4 + k) % 4];
    }
  }
  illuminate(compile_illumination(lighting, nullptr), points.surface(), points.out());
  for (int i = 0; i < points.count; ++i) {
    for (int c = 0; c < 4; ++c) EXPECT_TRUE(std::isfinite(points.lit[c][i])) << "point " << i;
  }
}

TEST(Illumination, RefusesImpossibleLights) {
  const auto refuses = [](const auto& change) {
    Lighting lighting;
    lighting.lights.emplace_back();
    change(lighting);
    EXPECT_THROW(compile_illumination(lighting, nullptr), std::invalid_argument);
  };
  refuses([](Lighting& l) { l.lights.resize(raster::kMaxLights + 1); });
  refuses([](Lighting& l) { l.lights[0].spot_cutoff_deg = 100.0f; });
  refuses([](Lighting& l) { l.lights[0].spot_exponent = -1.0f; });
  refuses([](Lighting& l) { l.front.shininess = -1.0f; });
  refuses([](Lighting& l) { l.front.shininess = std::numeric_limits<float>::quiet_NaN(); });
}

}  // namespace
}  // namespace barrido::pipeline
