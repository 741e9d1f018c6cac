// Bumps: heights in both forms, the normal map made of them, and normals lit by the texture environment.
#include <cmath>

#include <glm/geometric.hpp>

#include "tests/golden/stage.h"

namespace barrido::golden {
namespace {

constexpr int kSide = 64;

/// Domes of four to a side, 0 to 1.
float height(int x, int y) {
  const auto part = [](int i) { return static_cast<float>((i % 16 + 16) % 16) / 8.0f - 15.0f / 16.0f; };
  const float square = part(x) * part(x) + part(y) * part(y);
  return square < 0.8f ? std::sqrt(0.8f - square) : 0.0f;
}

raster::Texture heights() {
  return texture_of(kSide, {}, [](int x, int y) {
    const float h = height(x, y);
    return glm::vec4(h, h, h, 1);
  });
}

raster::Texture normals(float scale) {
  return texture_of(kSide, {}, [scale](int x, int y) {
    const float u = (height(x + 1, y) - height(x - 1, y)) * 0.5f * kSide * scale;
    const float v = (height(x, y + 1) - height(x, y - 1)) * 0.5f * kSide * scale;
    return glm::vec4(glm::normalize(glm::vec3(-u, -v, 1)) * 0.5f + 0.5f, 1);
  });
}

/// Under one lamp from the upper left, and a faint ambient light.
State lit(State state, const raster::Texture* map, raster::TextureRole role) {
  state.shade_model = pipeline::ShadeModel::phong;
  state.normalize = true;
  pipeline::Lighting& lighting = state.lighting;
  lighting.enabled = true;
  lighting.lights.resize(1);
  lighting.lights[0].position = {-1, 1, 1, 0};
  lighting.front.diffuse = {0.75f, 0.7f, 0.6f, 1};
  lighting.front.specular = {0.4f, 0.4f, 0.4f, 1};
  lighting.front.shininess = 20;
  state.texture_units[0].texture = map;
  state.texture_units[0].role = role;
  state.texture_units[0].min_filter = raster::MinFilter::linear;
  return state;
}

/// The plane with P_u and P_v, which the object's size scales.
Shape bumpy_plane() {
  Shape shape = plane(1);
  shape.tangent.assign(shape.position.size(), {2, 0, 0});
  shape.bitangent.assign(shape.position.size(), {0, 2, 0});
  return shape;
}

/// Heights on a plane, and on one of a third of the size that is seen as large: D' above, the same twice; D
/// below, steeper on the smaller one.
void bump_forms(Stage& stage) {
  const raster::Texture* map = stage.keep(heights());
  for (int cell = 0; cell < 4; ++cell) {
    const float size = cell % 2 == 0 ? 1.0f : 1.0f / 3.0f;
    State state = placed(in_cell(view_from(2.6f * size), cell, 2, 2), scaling(size, size, size));
    state = lit(state, map, raster::TextureRole::bump);
    state.texture_units[0].strength = cell < 2 ? 0.06f : 0.12f;
    state.texture_units[0].bump_form = cell < 2 ? raster::BumpForm::invariant : raster::BumpForm::blinn;
    stage.draw(state, bumpy_plane());
  }
}

/// Heights, and the normal map made of them.
void bump_and_normal_map(Stage& stage) {
  for (int cell = 0; cell < 2; ++cell) {
    const raster::Texture* map = stage.keep(cell == 0 ? heights() : normals(0.06f));
    State state = placed(in_cell(view_from(2.6f), cell, 2, 1), turned(-30, {1, 0, 0}));
    state = lit(state, map, cell == 0 ? raster::TextureRole::bump : raster::TextureRole::normal);
    if (cell == 0) state.texture_units[0].strength = 0.06f;
    stage.draw(state, bumpy_plane());
  }
}

/// Normals times the direction of a light, which is the environment's constant: from four sides; a second
/// unit puts its picture on them.
void dot3(Stage& stage) {
  const raster::Texture* map = stage.keep(normals(0.06f));
  const raster::Texture* picture = stage.keep(checker(8));
  for (int cell = 0; cell < 4; ++cell) {
    State state = in_cell(flat_view(), cell, 2, 2);
    const glm::vec3 light =
        glm::normalize(glm::vec3(cell % 2 == 0 ? -1 : 1, cell < 2 ? 1 : -1, 1)) * 0.5f + 0.5f;
    raster::TextureUnit& unit = state.texture_units[0];
    unit.texture = map;
    unit.min_filter = raster::MinFilter::linear;
    unit.env_mode = raster::TextureEnvMode::combine;
    unit.combine.rgb.function = raster::CombineFunction::dot3_rgb;
    unit.combine.rgb.source = {raster::CombineSource::texture, raster::CombineSource::constant,
                               raster::CombineSource::constant};
    unit.env_color = {light.x, light.y, light.z, 1};
    state.texture_units[1].texture = picture;
    state.texture_units[1].min_filter = raster::MinFilter::nearest;
    state.texture_units[1].mag_filter = raster::MagFilter::nearest;
    stage.draw(state, rectangle(-0.95f, -0.95f, 0.95f, 0.95f));
  }
}

}  // namespace

std::vector<Scene> map_scenes() {
  return {{"bump_forms", bump_forms}, {"bump_and_normal_map", bump_and_normal_map}, {"dot3", dot3}};
}

}  // namespace barrido::golden
