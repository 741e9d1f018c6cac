// Maps that are read before light: closed forms, and vectors against plain floats.
#include "pipeline/map_stages.h"

#include <array>
#include <bit>
#include <cmath>
#include <memory>
#include <stdexcept>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "drawn.h"
#include "pipeline/reference/illumination.h"
#include "pipeline/reference/map_stages.h"
#include "pipeline/reference/vertices.h"
#include "random.h"
#include "raster/base/simd_target.h"
#include "raster/reference/fragment.h"
#include "raster/reference/shading.h"
#include "raster/tiles/tile.h"

namespace barrido::pipeline {
namespace {

using raster::BumpForm;
using raster::Meaning;
using raster::TextureRole;
using reference::mapped_normal;
using reference::MappedSurface;
using reference::tilted_normal;

void expect_near(const glm::vec3& a, const glm::vec3& b, float tolerance = 1e-6f) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], tolerance) << axis;
}

TEST(BumpMap, OfThePlaneIsTheNormalOfItsHeights) {  // T14: r = (u, v, 0), N' = (−F_u, −F_v, 1)
  const MappedSurface plane;
  for (const BumpForm form : {BumpForm::blinn, BumpForm::invariant}) {
    expect_near(tilted_normal(plane, form, 0.25f, -0.5f), {-0.25f, 0.5f, 1.0f});
    expect_near(tilted_normal(plane, form, 0.0f, 0.0f), {0, 0, 1});
  }
}

TEST(BumpMap, LooksTheSameAtEverySizeInTheInvariantFormAlone) {
  const MappedSurface plane{{0, 0, 1}, {1, 0, 0}, {0.25f, 1, 0}};
  for (const float size : {1e-3f, 0.5f, 20.0f, 1e4f}) {
    const MappedSurface scaled{plane.normal, plane.tangent * size, plane.bitangent * size};
    const auto unit = [&](const MappedSurface& surface, BumpForm form) {
      return glm::normalize(tilted_normal(surface, form, 0.3f, 0.2f));
    };
    expect_near(unit(scaled, BumpForm::invariant), unit(plane, BumpForm::invariant));
    EXPECT_GT(glm::distance(unit(scaled, BumpForm::blinn), unit(plane, BumpForm::blinn)), 0.1f) << size;
  }
}

TEST(BumpMap, HeightsRiseOutwardsWhicheverWayTheCoordinatesRun) {
  // The same slope, with v upwards and downwards.
  const MappedSurface up{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}, down{{0, 0, 1}, {1, 0, 0}, {0, -1, 0}};
  for (const BumpForm form : {BumpForm::blinn, BumpForm::invariant}) {
    expect_near(tilted_normal(down, form, 0.25f, 0.5f), tilted_normal(up, form, 0.25f, -0.5f));
  }
}

TEST(BumpMap, AndTheNormalMapOfItsHeightsAreOne) {
  const MappedSurface surface{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}};
  for (const glm::vec2 slope : {glm::vec2(0.5f, 0.25f), glm::vec2(-2.0f, 0.1f), glm::vec2(0.0f)}) {
    const glm::vec3 n = glm::normalize(glm::vec3(-slope.x, -slope.y, 1.0f));
    const glm::vec3 mapped = mapped_normal(surface, n * 0.5f + 0.5f, 1.0f);
    expect_near(glm::normalize(tilted_normal(surface, BumpForm::invariant, slope.x, slope.y)),
                glm::normalize(mapped));
  }
}

TEST(NormalMap, ScalesXAndYAlone) {  // glTF: (2t − 1)·(scale, scale, 1)
  expect_near(mapped_normal({}, {0.75f, 0.25f, 1.0f}, 2.0f), {1.0f, -1.0f, 1.0f});
  expect_near(mapped_normal({}, {0.5f, 0.5f, 1.0f}, 2.0f), {0, 0, 1});
}

TEST(BumpMap, OfASolidIsTheGradientWithoutItsPartAlongTheNormal) {
  const glm::vec3 n(0, 0, 2), slopes(0.5f, -0.25f, 7.0f);
  for (const float size : {0.5f, 1.0f, 8.0f}) {
    const glm::mat3 gradient = glm::mat3(1.0f / size);  // of an object `size` times as large
    expect_near(tilted_normal(n, BumpForm::invariant, gradient, slopes), {-0.5f, 0.25f, 1.0f}, 1e-5f);
    expect_near(tilted_normal(n, BumpForm::blinn, gradient, slopes), {-0.5f / size, 0.25f / size, 1.0f},
                1e-5f);
  }
}

TEST(BumpMap, GradientsOfASolidGoThroughMatricesAsNormalsDo) {
  State state;
  state.eye_from_object = glm::scale(glm::mat4(1.0f), glm::vec3(2.0f, 4.0f, 8.0f));
  TextureCoordinates& rules = state.texture_coordinates[0];
  expect_near(solid_gradient(state, 0) * glm::vec3(1, 1, 1), {0.5f, 0.25f, 0.125f});
  rules.matrix = glm::scale(glm::mat4(1.0f), glm::vec3(3.0f));  // three repeats of what was one
  expect_near(solid_gradient(state, 0) * glm::vec3(1, 0, 0), {1.5f, 0, 0});
  rules.generation[0] = {true, TexGenMode::object_linear, {0, 1, 0, 5}, {}};
  expect_near(solid_gradient(state, 0) * glm::vec3(1, 0, 0), {0, 0.75f, 0});
  rules.generation[0] = {true, TexGenMode::eye_linear, {}, {0, 0, 1, 0}};
  expect_near(solid_gradient(state, 0) * glm::vec3(1, 0, 0), {0, 0, 3});
}

/// Waves along two or three coordinates.
std::array<float, 4> wave(float s, float t, float r) {
  return {0.5f + 0.25f * s * t, 0.5f - 0.125f * t * t, 0.25f * r * s, 1.0f};
}
std::uint64_t waves(const raster::TextureUnit&, const raster::ProcedurePoints& points,
                    float (*texel)[raster::kBatchStride]) {
  for (int i = 0; i < points.count; ++i) {
    const float third = points.at[2] != nullptr ? points.at[2][i] : 0.5f;
    const auto color = wave(points.at[0][i], points.at[1][i], third);
    for (std::size_t c = 0; c < 4; ++c) texel[c][i] = color[c];
  }
  return 0;
}
std::array<float, 4> wave_at(const raster::TextureUnit&, const float (&at)[3], const float (&)[3],
                             raster::reference::UnitTrace*) {
  return wave(at[0], at[1], at[2]);
}
constinit const raster::TextureProcedure kWaves2{"waves", 2, waves, wave_at, "waves"};
constinit const raster::TextureProcedure kWaves3{"waves", 3, waves, wave_at, "waves"};

raster::Texture random_picture(Random& random) {
  std::vector<std::uint8_t> rgba(16 * 8 * 4);
  for (std::uint8_t& byte : rgba) byte = static_cast<std::uint8_t>(random.below(256));
  return raster::Texture::make_2d({16, 8, rgba}, {});
}

const std::vector<float> kTriangle{0, 0, 0, 1, 0, 0, 0, 1, 0};
const std::vector<float> kTangents{1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, -1};

State lit_state() {
  State state;
  state.shade_model = ShadeModel::phong;
  state.lighting.enabled = true;
  state.lighting.lights.resize(1);
  return state;
}

Geometry geometry_with_tangents() {
  Geometry geometry = geometry_of(kTriangle);
  geometry.tangent = {kTangents.data(), 4, 4};
  return geometry;
}

TEST(MapStages, VectorsAndPlainFloatsAreTheSameBits) {
  std::array<int, 3> drawn{};
  for (const raster::SimdTarget target : raster::available_simd_targets()) {
    ASSERT_TRUE(raster::set_simd_target(target));
    Random random(7);
    for (int round = 0; round < 300; ++round) {
      SCOPED_TRACE("round " + std::to_string(round));
      const raster::Texture picture = random_picture(random);
      State state = lit_state();
      raster::TextureUnit& unit = state.texture_units[5];
      constexpr TextureRole kRoles[] = {TextureRole::normal, TextureRole::bump, TextureRole::occlusion};
      const std::size_t which = static_cast<std::size_t>(random.below(3));
      unit.role = kRoles[which];
      unit.texture = &picture;
      if (random.chance(0.4)) unit.procedure = &kWaves2;
      if (unit.role == TextureRole::bump && random.chance(0.3)) unit.procedure = &kWaves3;
      unit.min_filter = raster::MinFilter::linear;
      unit.strength = random.in(-3, 3);
      unit.bump_form = random.chance(0.5) ? BumpForm::blinn : BumpForm::invariant;
      if (random.chance(0.3)) state.texture_coordinates[5].matrix[0][3] = 0.5f;  // divided by q
      state.eye_from_object = glm::scale(glm::mat4(1.0f), random.vec3(0.1, 3));
      const Drawn plan(state, geometry_with_tangents());
      const raster::FragmentStage& stage = plan.plan->fragment.stages.front();
      auto workspace = std::make_unique<raster::TileWorkspace>();
      workspace->batch.state = &plan.plan->fragment;
      workspace->batch.count = 37;
      const bool zero = random.chance(0.05);
      for (auto& column : workspace->batch.varying) {
        for (float& value : column) value = zero ? 0.0f : random.in(-2, 2);
      }
      std::vector<raster::reference::Fragment> alone(37);
      for (std::size_t i = 0; i < alone.size(); ++i) {
        alone[i].state = &plan.plan->fragment;
        for (int v = 0; v < raster::kMaxVaryings; ++v) alone[i].varying[v] = workspace->batch.varying[v][i];
      }
      stage.kind->vector(stage, *workspace);
      ++drawn[which];
      for (std::size_t i = 0; i < alone.size(); ++i) {
        stage.kind->scalar(stage, alone[i], nullptr);
        for (int v = 0; v < raster::kMaxVaryings; ++v) {
          ASSERT_EQ(std::bit_cast<std::uint32_t>(workspace->batch.varying[v][i]),
                    std::bit_cast<std::uint32_t>(alone[i].varying[v]))
              << stage.kind->name << ", fragment " << i << ", varying " << v;
        }
      }
    }
  }
  raster::set_simd_target(raster::SimdTarget::automatic);
  for (const int count : drawn) EXPECT_GT(count, 50);
}

TEST(MapStages, StandBeforeLightAndOnlyWhereThereIsSuchANormalOrAmbientLight) {
  Random random(3);
  const raster::Texture picture = random_picture(random);
  for (const ShadingMode& mode : kShadingModes) {
    SCOPED_TRACE(mode.name);
    State state = lit_state();
    state.shade_model = mode.model;
    for (std::size_t unit : {2, 3}) state.texture_units[unit].texture = &picture;
    state.texture_units[2].role = TextureRole::normal;
    state.texture_units[3].role = TextureRole::occlusion;
    const Drawn drawn(state, geometry_with_tangents());
    std::vector<std::string_view> names;
    for (const raster::FragmentStage& stage : drawn.plan->fragment.stages) names.push_back(stage.kind->name);
    std::vector<std::string_view> expected;
    if (mode.model == ShadeModel::phong) expected = {"normal map", "occlusion map", "Phong light"};
    if (mode.model == ShadeModel::cheap_phong) expected = {"occlusion map", "cheap Phong light"};
    expected.emplace_back("colours");
    EXPECT_EQ(names, expected);
  }
}

TEST(MapStages, NormalsCannotBeChangedWithoutTangents) {
  Random random(3);
  const raster::Texture picture = random_picture(random);
  State state = lit_state();
  state.texture_units[0].role = TextureRole::normal;
  state.texture_units[0].texture = &picture;
  EXPECT_THROW(Drawn(state, geometry_of(kTriangle)), std::invalid_argument);
  state.shade_model = ShadeModel::gouraud;  // which has no use for them
  EXPECT_NO_THROW(Drawn(state, geometry_of(kTriangle)));
}

TEST(MapStages, NormalsComeFromPicturesAlone) {
  Random random(3);
  const raster::Texture picture = random_picture(random);
  State state = lit_state();
  state.texture_units[0].role = TextureRole::normal;
  state.texture_units[0].texture = &picture;
  state.texture_units[0].procedure = &kWaves3;
  EXPECT_THROW(Drawn(state, geometry_with_tangents()), std::invalid_argument);
  state.texture_units[0].procedure = &kWaves2;
  EXPECT_NO_THROW(Drawn(state, geometry_with_tangents()));
}

TEST(MapStages, VerticesBringTangentsToTheEye) {
  const raster::SimdTarget before = raster::simd_target();
  for (const raster::SimdTarget target : raster::available_simd_targets()) {
    ASSERT_TRUE(raster::set_simd_target(target));
    Random random(11);
    for (int round = 0; round < 100; ++round) {
      VertexTransform t;
      for (int c = 0; c < 4; ++c) t.eye_from_object[c] = random.vec4(-1, 1);
      const bool has_bitangent = random.chance(0.5), to_unit = random.chance(0.5);
      const auto batch = std::make_unique<VertexBatch>();
      batch->count = 37;
      std::vector<reference::TangentVertex> vertices;
      for (int i = 0; i < kVertexBatch; ++i) {
        vertices.push_back({random.vec4(-2, 2), random.vec3(-2, 2), random.vec3(-1, 1)});
        if (random.chance(0.1)) vertices.back().tangent *= 1e11f;
        for (int c = 0; c < 3; ++c) {
          batch->normal[c][i] = vertices.back().normal[c];
          batch->tangents[c][i] = vertices.back().tangent[c];
          batch->tangents[3 + c][i] = has_bitangent ? vertices.back().bitangent[c] : 0.0f;
        }
        if (!has_bitangent) batch->tangents[3][i] = vertices.back().tangent.w;
      }
      transform_tangents(t, has_bitangent, to_unit, *batch);
      for (int i = 0; i < batch->count; ++i) {
        const auto eye =
            reference::eye_tangents(t, vertices[static_cast<std::size_t>(i)], has_bitangent, to_unit);
        for (int c = 0; c < 3; ++c) {
          ASSERT_EQ(std::bit_cast<std::uint32_t>(batch->tangents[c][i]),
                    std::bit_cast<std::uint32_t>(eye.tangent[c]));
          ASSERT_EQ(std::bit_cast<std::uint32_t>(batch->tangents[3 + c][i]),
                    std::bit_cast<std::uint32_t>(eye.bitangent[c]));
        }
      }
    }
  }
  raster::set_simd_target(before);
}

TEST(Occlusion, WeakensAmbientLightAndNothingElse) {
  Lighting lighting;
  lighting.lights.resize(2);
  lighting.lights[0].ambient = {0.5f, 0, 0, 1};
  lighting.lights[1].position = {0, 0, 2, 1};  // weakens
  lighting.lights[1].ambient = {0, 0.5f, 0, 1};
  lighting.lights[1].linear_attenuation = 0.5f;
  lighting.front.ambient = {1, 1, 1, 1};
  lighting.front.emission = {0, 0, 0.125f, 1};
  const Illumination model = compile_illumination(lighting, nullptr);
  reference::SurfacePoint point;
  const auto color = [&](float share) {
    point.occlusion = {&share, 1};
    return reference::illuminate(model, point).primary;
  };
  point.occlusion = {};
  const auto whole = reference::illuminate(model, point).primary;
  const auto full = color(1.0f), half = color(0.5f), none = color(0.0f);
  const float ambient[3] = {0.5f + 0.2f, 0.5f / 2.0f + 0.2f, 0.2f};
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(full[c], whole[c]);  // to the bit
    EXPECT_NEAR(whole[c] - none[c], ambient[c], 1e-6f) << c;
    EXPECT_NEAR(half[c], 0.5f * (whole[c] + none[c]), 1e-6f);
  }
}

}  // namespace
}  // namespace barrido::pipeline
