// The vertex stage compared with the formulas of the specification in double precision.
#include "pipeline/vertex_stage.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "drawn.h"
#include "pipeline/bounded.h"
#include "pipeline/matrix.h"
#include "random.h"

namespace barrido::pipeline {
namespace {

constexpr int kVertices = 301;  // three batches, the last one ragged

/// Vertices with all attributes in arrays, in one of several arrangements of memory.
struct Vertices {
  std::vector<float> positions, normals, colors, texcoords;
  Geometry geometry;

  explicit Vertices(Random& random, int position_components = 3) {
    const int stride = position_components + (random.chance(0.5) ? 2 : 0);  // packed or not
    for (int i = 0; i < kVertices; ++i) {
      for (int k = 0; k < stride; ++k) positions.push_back(k < 3 ? random.in(-1, 1) : random.in(0.5, 2));
      const glm::vec3 n = random.vec3(-1, 1);
      normals.insert(normals.end(), {n.x, n.y, n.z});
      const glm::vec4 c = random.vec4(0, 1), t = random.vec4(0.5, 2);
      colors.insert(colors.end(), {c.x, c.y, c.z, c.w});
      texcoords.insert(texcoords.end(), {t.x, t.y, t.z, t.w});
    }
    geometry.vertex_count = kVertices;
    geometry.position = {positions.data(), position_components, stride};
    geometry.normal = {normals.data(), 3, 3};
    geometry.color = {colors.data(), 4, 4};
    geometry.texcoord[0] = {texcoords.data(), 4, 4};
  }

  glm::dvec4 position(int i) const {
    glm::dvec4 p{0, 0, 0, 1};
    for (int k = 0; k < geometry.position.components; ++k) {
      p[k] = positions[static_cast<std::size_t>(i * geometry.position.stride + k)];
    }
    return p;
  }
  glm::dvec3 normal(int i) const {
    const auto at = static_cast<std::size_t>(3 * i);
    return {normals[at], normals[at + 1], normals[at + 2]};
  }
  glm::dvec4 texcoord(int i) const { return four(texcoords, i); }
  glm::dvec4 color(int i) const { return four(colors, i); }

 private:
  static glm::dvec4 four(const std::vector<float>& values, int i) {
    const auto at = static_cast<std::size_t>(4 * i);
    return {values[at], values[at + 1], values[at + 2], values[at + 3]};
  }
};

State random_view(Random& random) {
  State state;
  state.eye_from_object = product(look_at({0, 0, 4}, glm::dvec3(random.vec3(-0.2, 0.2)), {0, 1, 0}),
                                  rotation(random.in(-3, 3), glm::dvec3(random.vec3(-1, 1))));
  state.eye_from_object[0] *= random.in(0.5, 1.5);  // normals must notice
  state.clip_from_eye = perspective(1.0, 2.0, 0.5, 20.0);
  return state;
}

glm::dvec3 eye_point(const State& state, const Vertices& v, int i) {
  const glm::dvec4 eye = glm::dmat4(state.eye_from_object) * v.position(i);
  return glm::dvec3(eye) / eye.w;
}

glm::dvec3 eye_normal(const State& state, const Vertices& v, int i) {
  return glm::transpose(glm::inverse(glm::dmat3(state.eye_from_object))) * v.normal(i);
}

TEST(VertexStage, ProjectsIntoTheWindow) {
  Random random(11);
  for (int round = 0; round < 20; ++round) {
    const Vertices v(random, 2 + round % 3);
    State state = random_view(random);
    state.viewport = {10, 20, 200, 90, 0.25f, 0.75f};
    const Drawn drawn(state, v.geometry);
    for (int i = 0; i < kVertices; ++i) {
      const glm::dvec4 clip =
          glm::dmat4(state.clip_from_eye) * glm::dmat4(state.eye_from_object) * v.position(i);
      const PackedPosition p = drawn.vertices.positions[i];
      const bool outside =
          std::abs(clip.x) > clip.w || std::abs(clip.y) > clip.w || std::abs(clip.z) > clip.w;
      const double margin =
          std::min({std::abs(std::abs(clip.x) - clip.w), std::abs(std::abs(clip.y) - clip.w),
                    std::abs(std::abs(clip.z) - clip.w)});
      if (margin > 1e-5) {
        ASSERT_EQ((outcode(p) & kOutsideVolume) != 0, outside) << "vertex " << i;
      }
      ASSERT_NEAR(window_coordinate(p.x) / 256.0, (clip.x / clip.w * 0.5 + 0.5) * 200 + 10, 3e-3);
      ASSERT_NEAR(window_coordinate(p.y) / 256.0, (clip.y / clip.w * 0.5 + 0.5) * 90 + 20, 3e-3);
      const float* record = drawn.record(static_cast<std::uint32_t>(i));
      ASSERT_NEAR(record[raster::kRecordQ], 1.0 / clip.w, 1e-5);
      if (!outside) {
        ASSERT_NEAR(record[raster::kRecordDepth], clip.z / clip.w * 0.25 + 0.5, 1e-5);
      }
    }
  }
}

TEST(VertexStage, SnapsToTheNearestSubpixel) {
  // Window coordinates that a float holds exactly: n + ½ of 1/256 pixel rounds up.
  const std::vector<float> positions{-1, -1, 0, 1, 1, 0, 1.0f / 65536.0f, -1.0f / 65536.0f, 0};
  const Drawn drawn(State{}, geometry_of(positions), {256, 256, {}});
  const auto x = [&](int i) { return window_coordinate(drawn.vertices.positions[i].x); };
  const auto y = [&](int i) { return window_coordinate(drawn.vertices.positions[i].y); };
  EXPECT_EQ(x(0), 0);
  EXPECT_EQ(x(1), 256 * 256);
  EXPECT_EQ(x(2), 128 * 256 + 1);
  EXPECT_EQ(y(2), 128 * 256);
}

TEST(VertexStage, NormalsAndPositionsForPhong) {
  Random random(12);
  for (int round = 0; round < 12; ++round) {
    const Vertices v(random, 3 + round % 2);
    State state = random_view(random);
    state.lighting.enabled = true;
    state.lighting.lights.emplace_back().position = {1, 2, 3, 1};
    state.lighting.color_material = ColorMaterial::diffuse;
    state.shade_model = ShadeModel::phong;
    state.normalize = round % 3 == 1;
    state.rescale_normal = round % 3 == 2;
    const Drawn drawn(state, v.geometry);
    const raster::VaryingList& varyings = drawn.plan->fragment.varyings;
    const glm::dmat3 inverse = glm::inverse(glm::dmat3(state.eye_from_object));
    const double rescale = 1.0 / glm::length(glm::dvec3(inverse[0].z, inverse[1].z, inverse[2].z));
    for (std::uint32_t i = 0; i < kVertices; ++i) {
      glm::dvec3 n = eye_normal(state, v, static_cast<int>(i));
      if (state.normalize) n = glm::normalize(n);
      if (state.rescale_normal) n *= rescale;
      const glm::dvec3 p = eye_point(state, v, static_cast<int>(i));
      for (int k = 0; k < 3; ++k) {
        ASSERT_NEAR(drawn.varying(i, varyings.at(raster::Meaning::normal) + k), n[k], 1e-5);
        ASSERT_NEAR(drawn.varying(i, varyings.at(raster::Meaning::eye_position) + k), p[k], 1e-5);
      }
      for (int k = 0; k < 4; ++k) {
        ASSERT_NEAR(drawn.varying(i, varyings.at(raster::Meaning::color) + k),
                    v.color(static_cast<int>(i))[k], 1e-6);
      }
    }
  }
}

const raster::Texture& texture() {
  static const std::vector<std::uint8_t> pixels(4, 255);
  static const raster::Texture one = raster::Texture::make_2d({1, 1, pixels}, {});
  return one;
}

/// OpenGL 1.3, section 2.10.4, plainly.
double generated(const TexGenCoordinate& rule, int axis, const State& state, const Vertices& v, int i) {
  const glm::dvec3 u = glm::normalize(eye_point(state, v, i));
  const glm::dvec3 n = eye_normal(state, v, i);
  const glm::dvec3 r = u - 2.0 * n * glm::dot(n, u);
  switch (rule.mode) {
    case TexGenMode::object_linear:
      return glm::dot(glm::dvec4(rule.object_plane), v.position(i));
    case TexGenMode::eye_linear:
      return glm::dot(glm::dvec4(rule.eye_plane), glm::dmat4(state.eye_from_object) * v.position(i));
    case TexGenMode::sphere_map:
      return r[axis] / (2.0 * glm::length(glm::dvec3(r.x, r.y, r.z + 1.0))) + 0.5;
    case TexGenMode::reflection_map:
      return r[axis];
    case TexGenMode::normal_map:
      break;
  }
  return n[axis];
}

TEST(VertexStage, GeneratesAndTransformsTextureCoordinates) {
  Random random(13);
  for (int round = 0; round < 60; ++round) {
    const Vertices v(random, 3 + round % 2);
    State state = random_view(random);
    state.texture_units[0].texture = &texture();
    TextureCoordinates& rules = state.texture_coordinates[0];
    for (int axis = 0; axis < 4; ++axis) {
      TexGenCoordinate& rule = rules.generation[static_cast<std::size_t>(axis)];
      rule.enabled = random.chance(0.7);
      rule.mode = static_cast<TexGenMode>(random.below(axis == 3 ? 2 : 5));
      if (axis == 2 && rule.mode == TexGenMode::sphere_map) rule.mode = TexGenMode::normal_map;
      rule.object_plane = random.vec4(-1, 1);
      rule.eye_plane = random.vec4(-1, 1);
    }
    rules.generation[3].enabled = true;  // projective
    if (random.chance(0.5)) {
      for (int c = 0; c < 4; ++c) rules.matrix[c] = random.vec4(-1, 1);
    }
    const Drawn drawn(state, v.geometry);
    const int offset = drawn.plan->fragment.varyings.at(raster::Meaning::texcoord);
    for (std::uint32_t i = 0; i < kVertices; ++i) {
      glm::dvec4 expected = v.texcoord(static_cast<int>(i));
      for (int axis = 0; axis < 4; ++axis) {
        const TexGenCoordinate& rule = rules.generation[static_cast<std::size_t>(axis)];
        if (rule.enabled) expected[axis] = generated(rule, axis, state, v, static_cast<int>(i));
      }
      expected = glm::dmat4(rules.matrix) * expected;
      ASSERT_NEAR(drawn.varying(i, offset), expected.x, 2e-4) << "vertex " << i;
      ASSERT_NEAR(drawn.varying(i, offset + 1), expected.y, 2e-4);
      ASSERT_NEAR(drawn.varying(i, offset + 2), expected.w, 2e-4);
    }
  }
}

TEST(VertexStage, FogIsTheDistanceAlongTheLineOfSight) {
  Random random(14);
  const Vertices v(random);
  State state = random_view(random);
  state.fog.enabled = true;
  const Drawn drawn(state, v.geometry);
  for (std::uint32_t i = 0; i < kVertices; ++i) {
    EXPECT_NEAR(drawn.varying(i, drawn.plan->fragment.varyings.at(raster::Meaning::fog)),
                eye_point(state, v, static_cast<int>(i)).z, 1e-5);
  }
}

TEST(VertexStage, AbsentArraysGiveTheConstants) {
  const std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 1, 0};
  Geometry geometry = geometry_of(positions);
  geometry.constant_texcoord[0] = {0.25f, 0.5f, 0.75f, 1.0f};
  State state;
  state.texture_units[0].texture = &texture();
  const Drawn drawn(state, geometry);
  EXPECT_TRUE(drawn.plan->has_constant_color());
  const int offset = drawn.plan->fragment.varyings.at(raster::Meaning::texcoord);
  EXPECT_EQ(drawn.varying(2, offset), 0.25f);
  EXPECT_EQ(drawn.varying(2, offset + 1), 0.5f);
}

TEST(VertexStage, NoNumberThatIsNotFiniteLeaves) {
  Random random(15);
  const float values[] = {std::numeric_limits<float>::quiet_NaN(),
                          std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity(),
                          std::numeric_limits<float>::max(),
                          1e11f,
                          0.0f,
                          1e-40f,
                          1.0f};
  const auto spoil = [&](std::vector<float>& numbers) {
    for (float& number : numbers) {
      if (random.chance(0.3)) number = values[random.below(8)];
    }
  };
  for (int round = 0; round < 200; ++round) {
    Vertices v(random, 3 + round % 2);
    spoil(v.positions);
    spoil(v.normals);
    spoil(v.colors);
    spoil(v.texcoords);
    State state = random_view(random);
    for (int c = 0; c < 4 && round % 4 == 0; ++c) {
      state.eye_from_object[c][random.below(4)] = values[random.below(8)];
      state.clip_from_eye[c][random.below(4)] = values[random.below(8)];
      state.texture_coordinates[0].matrix[c][random.below(4)] = values[random.below(8)];
    }
    state.lighting.enabled = true;
    state.lighting.lights.emplace_back().position = {1, 2, 3, 1};
    state.lighting.lights[0].quadratic_attenuation = 1.0f;
    state.lighting.front.specular = {1, 1, 1, 1};
    state.lighting.front.shininess = 50.0f;
    state.lighting.color_material = ColorMaterial::ambient_and_diffuse;
    state.shade_model = static_cast<ShadeModel>(round % static_cast<int>(kShadingModeCount));
    state.clamp_colors = random.chance(0.5);
    state.fog.enabled = true;
    state.normalize = random.chance(0.5);
    state.depth_clamp = random.chance(0.3);
    state.texture_units[0].texture = &texture();
    for (auto& rule : state.texture_coordinates[0].generation) rule.enabled = random.chance(0.5);
    const Drawn drawn(state, v.geometry);
    for (const raster::PrimitiveChunk& chunk : drawn.chunks) {
      for (const raster::PrimitiveRecord& p : chunk.primitives) {
        for (int k = 0; k < 3; ++k) {
          ASSERT_LT(std::abs(p.x[k]), raster::kGuardBandPixels * raster::kSubpixelUnits);
          ASSERT_LT(std::abs(p.y[k]), raster::kGuardBandPixels * raster::kSubpixelUnits);
          const float* record = chunk.record(p.vertex[k], drawn.vertices.stride);
          for (int f = 0; f < drawn.vertices.stride; ++f) {
            ASSERT_LE(std::abs(record[f]), raster::kMaxRecordValue);
          }
        }
      }
      for (const raster::FlatColors& flat : chunk.flat) {
        for (const float c : flat.color) ASSERT_TRUE(std::isfinite(c));
      }
    }
  }
}

}  // namespace
}  // namespace barrido::pipeline
