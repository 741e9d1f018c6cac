// Which varyings are recorded for which state, and where.
#include "pipeline/layout.h"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/draw_plan.h"

namespace barrido::pipeline {
namespace {

using raster::kAbsent;
using raster::Meaning;
using raster::TexcoordKind;

const raster::Texture& flat_texture() {
  static const std::vector<std::uint8_t> pixels(4, 255);
  static const raster::Texture texture = raster::Texture::make_2d({1, 1, pixels}, {});
  return texture;
}

const raster::Texture& cube_texture() {
  static const std::vector<std::uint8_t> pixels(4, 255);
  static const raster::Pixels8 face{1, 1, pixels};
  static const std::array<raster::Pixels8, 6> faces{face, face, face, face, face, face};
  static const raster::Texture texture = raster::Texture::make_cube(faces, {});
  return texture;
}

constexpr float kValues[4] = {};

struct Case {
  State state;
  Geometry geometry;

  Case() {
    geometry.position = {kValues, 3, 3};
    state.clip_from_eye[2][3] = -1.0f;  // perspective
  }
  raster::VaryingList layout() const {
    FragmentCounters counters;
    return DrawPlan(state, geometry, {64, 64, {}}, counters).fragment.varyings;
  }
  void light(const glm::vec4& position) {
    state.lighting.enabled = true;
    Light light;
    light.position = position;
    state.lighting.lights.push_back(light);
  }
};

TEST(Layout, ConstantColorNeedsNothing) { EXPECT_EQ(Case().layout().count, 0); }

TEST(Layout, GouraudCarriesOneColorOrTwo) {
  Case c;
  c.light({0, 0, 1, 0});
  EXPECT_EQ(c.layout().count, 4);
  c.state.lighting.separate_specular = true;
  const raster::VaryingList layout = c.layout();
  EXPECT_EQ(layout.count, 7);
  EXPECT_EQ(layout.at(Meaning::specular), 4);
  EXPECT_EQ(layout.affine_count, 0);
}

TEST(Layout, FlatColorsAreNotInterpolated) {
  Case c;
  c.light({0, 0, 1, 0});
  c.state.shade_model = ShadeModel::flat;
  EXPECT_EQ(c.layout().count, 0);
}

TEST(Layout, PhongCarriesPositionsOnlyForNearLightsOrViewers) {
  Case c;
  c.state.shade_model = ShadeModel::phong;
  c.light({0, 0, 1, 0});
  EXPECT_EQ(c.layout().count, 3);
  c.state.lighting.local_viewer = true;
  EXPECT_EQ(c.layout().count, 3) << "nothing shines, so the viewer does not matter";
  c.state.lighting.front.specular = {1, 1, 1, 1};
  EXPECT_EQ(c.layout().count, 6);
  c.state.lighting.local_viewer = false;
  c.light({0, 0, 1, 1});
  EXPECT_EQ(c.layout().count, 6);
  c.state.lighting.color_material = ColorMaterial::diffuse;
  EXPECT_EQ(c.layout().count, 6) << "all vertices have one colour";
  c.geometry.color = {kValues, 4, 4};
  EXPECT_EQ(c.layout().count, 10);
}

TEST(Layout, CheapPhongCarriesTwoDotsALight) {
  Case c;
  c.state.shade_model = ShadeModel::cheap_phong;
  c.light({0, 0, 1, 0});
  c.light({0, 0, 1, 1});
  EXPECT_EQ(c.layout().count, 4);
  c.state.lighting.lights[1].linear_attenuation = 1.0f;
  EXPECT_EQ(c.layout().count, 4) << "its ambient colour is black";
  c.state.lighting.lights[1].ambient = {1, 1, 1, 1};
  EXPECT_EQ(c.layout().count, 7);
}

TEST(Layout, MostLightsFitWithEverythingElse) {
  Case c;
  c.state.shade_model = ShadeModel::cheap_phong;
  for (int i = 0; i < raster::kMaxLights; ++i) {
    c.light({0, 0, 1, 1});
    c.state.lighting.lights.back().quadratic_attenuation = 1.0f;
    c.state.lighting.lights.back().ambient = {1, 1, 1, 1};
  }
  c.state.lighting.color_material = ColorMaterial::diffuse;
  c.geometry.color = {kValues, 4, 4};
  c.state.fog.enabled = true;
  for (auto& unit : c.state.texture_units) unit.texture = &cube_texture();
  EXPECT_LE(c.layout().count, raster::kMaxVaryings);
}

TEST(Layout, KindsOfTextureCoordinates) {
  Case c;
  c.state.texture_units[0].texture = &flat_texture();
  c.state.texture_units[2].texture = &cube_texture();
  raster::VaryingList layout = c.layout();
  EXPECT_EQ(layout.floats(Meaning::texcoord, 0), 2);
  EXPECT_EQ(layout.at(Meaning::texcoord, 0), 0);
  EXPECT_EQ(layout.at(Meaning::texcoord, 1), kAbsent);
  EXPECT_EQ(layout.floats(Meaning::texcoord, 2), 3);
  EXPECT_EQ(layout.at(Meaning::texcoord, 2), 2);
  EXPECT_EQ(layout.count, 5);
  const auto kind = [&c] { return texcoord_kind(c.state, c.geometry, 0); };
  c.geometry.constant_texcoord[0].w = 2.0f;
  EXPECT_EQ(kind(), TexcoordKind::projective);
  c.geometry.texcoord[0] = {kValues, 2, 2};
  EXPECT_EQ(kind(), TexcoordKind::plain);
  c.geometry.texcoord[0] = {kValues, 4, 4};
  EXPECT_EQ(kind(), TexcoordKind::projective);
  c.geometry.texcoord[0] = {kValues, 2, 2};
  c.state.texture_coordinates[0].generation[3].enabled = true;
  EXPECT_EQ(kind(), TexcoordKind::projective);
  c.state.texture_coordinates[0].generation[3].enabled = false;
  c.state.texture_coordinates[0].matrix[1][3] = 0.5f;
  EXPECT_EQ(kind(), TexcoordKind::projective);
}

TEST(Layout, WhatIsLinearOnTheScreenComesFirst) {
  Case c;
  c.geometry.color = {kValues, 4, 4};
  c.state.fog.enabled = true;
  c.state.texture_units[0].texture = &flat_texture();
  raster::VaryingList layout = c.layout();
  EXPECT_EQ(layout.affine_count, 0);
  EXPECT_EQ(layout.count, 7);
  c.state.texture_interpolation = TextureInterpolation::affine;
  layout = c.layout();
  EXPECT_EQ(layout.at(Meaning::texcoord, 0), 0);
  EXPECT_EQ(layout.at(Meaning::color), 2);
  EXPECT_EQ(layout.affine_count, 2);
  c.state.color_interpolation = ColorInterpolation::screen;
  layout = c.layout();
  EXPECT_EQ(layout.affine_count, 6);
  EXPECT_EQ(layout.at(Meaning::fog), 6);
  c.state.clip_from_eye = glm::mat4(1.0f);
  EXPECT_EQ(c.layout().affine_count, 7) << "without perspective everything is";
}

}  // namespace
}  // namespace barrido::pipeline
