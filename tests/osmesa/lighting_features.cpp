// Scenes of lights, materials and the shading modes.
#include "tests/osmesa/parts.h"

namespace barrido::crosscheck {
namespace {

using pipeline::ShadeModel;

/// A lit surface under `count` lights of one kind, or of all kinds.
DrawCall lit(RandomBits& random, const ScenePair& pair, int count, const LightKind* kind) {
  DrawCall draw = any_draw(random, pair);
  draw.mesh = random.chance(60) ? sphere(random, random.between(8, 14))
                                : bent_plane(random, random.between(2, 5), 0.5f, 1.0f);
  pipeline::Lighting& lighting = draw.state.lighting;
  lighting.enabled = true;
  for (int i = 0; i < count; ++i)
    lighting.lights.push_back(random_light(random, kind != nullptr ? *kind : any_kind(random)));
  lighting.ambient = random_color(random, 0.0f, 0.4f);
  lighting.local_viewer = random.chance(50);
  lighting.front = random_material(random);
  lighting.back = lighting.front;
  return draw;
}

void one_kind(RandomBits& random, ScenePair& pair, LightKind kind) {
  pair.draws.push_back(lit(random, pair, 1, &kind));
  if (random.chance(20)) pair.draws.back().state.shade_model = ShadeModel::flat;
}
void directional(RandomBits& random, ScenePair& pair) { one_kind(random, pair, LightKind::directional); }
void point(RandomBits& random, ScenePair& pair) { one_kind(random, pair, LightKind::point); }
void spot(RandomBits& random, ScenePair& pair) {
  one_kind(random, pair, LightKind::spot);
  if (random.chance(20)) pair.draws.back().state.lighting.lights[0].position.w = 0.0f;
}

void several(RandomBits& random, ScenePair& pair) {
  pair.draws.push_back(lit(random, pair, random.between(2, 8), nullptr));
}

void materials(RandomBits& random, ScenePair& pair) {
  pair.draws.push_back(lit(random, pair, random.between(0, 2), nullptr));
  pair.draws.back().state.lighting.color_material = random.one_of_first<pipeline::ColorMaterial>(6);
  if (random.chance(20)) pair.draws.back().mesh.color.clear();
}

void two_sided(RandomBits& random, ScenePair& pair) {
  DrawCall draw = lit(random, pair, random.between(1, 3), nullptr);
  if (random.chance(50)) draw.mesh = soup(random, random.between(3, 8), 1.0f);
  draw.state.lighting.two_sided = true;
  draw.state.lighting.back = random_material(random);
  draw.state.front_face = random.one_of_first<pipeline::FrontFace>(2);
  if (random.chance(30)) draw.state.cull_face = random.one_of_first<pipeline::CullFace>(3);
  if (random.chance(30)) draw.state.shade_model = ShadeModel::flat;
  if (random.chance(30)) draw.state.lighting.color_material = random.one_of_first<pipeline::ColorMaterial>(6);
  pair.draws.push_back(std::move(draw));
}

void separate_specular(RandomBits& random, ScenePair& pair) {
  DrawCall draw = lit(random, pair, random.between(1, 3), nullptr);
  draw.state.lighting.separate_specular = random.chance(80);
  draw.state.lighting.two_sided = random.chance(30);
  raster::TextureUnit& unit = draw.state.texture_units[0];
  unit.texture = add_texture(random, pair, {}, 16, true);
  unit.min_filter = raster::MinFilter::linear;
  if (random.chance(30)) draw.state.shade_model = ShadeModel::flat;
  pair.draws.push_back(std::move(draw));
}

void normal_scaling(RandomBits& random, ScenePair& pair) {
  DrawCall draw = lit(random, pair, 2, nullptr);
  glm::mat4 scale(1.0f);
  const bool uniform = random.chance(50);
  for (int i = 0; i < 3; ++i) scale[i][i] = uniform && i > 0 ? scale[0][0] : random.number(0.6f, 1.4f);
  if (random.chance(20)) scale[1][0] = 0.4f;  // sheared
  draw.state.eye_from_object = draw.state.eye_from_object * scale;
  draw.state.normalize = random.chance(60);
  draw.state.rescale_normal = random.chance(40);
  pair.draws.push_back(std::move(draw));
}

void per_pixel(RandomBits& random, ScenePair& pair, ShadeModel model, pipeline::CheapPhongPower power) {
  DrawCall draw = lit(random, pair, random.between(1, 3), nullptr);
  pipeline::Lighting& lighting = draw.state.lighting;
  draw.state.shade_model = model;
  draw.state.cheap_phong_power = power;
  lighting.specular_model = random.one_of_first<pipeline::SpecularModel>(2);
  lighting.color_material =
      random.chance(30) ? random.one_of_first<pipeline::ColorMaterial>(6) : pipeline::ColorMaterial::none;
  lighting.two_sided = random.chance(40);
  if (lighting.two_sided) lighting.back = random_material(random);
  draw.state.normalize = random.chance(50);
  pair.draws.push_back(std::move(draw));
}
void phong(RandomBits& random, ScenePair& pair) { per_pixel(random, pair, ShadeModel::phong, {}); }
void cheap_phong_pixel(RandomBits& random, ScenePair& pair) {
  per_pixel(random, pair, ShadeModel::cheap_phong, pipeline::CheapPhongPower::pixel);
}
void cheap_phong_vertex(RandomBits& random, ScenePair& pair) {
  per_pixel(random, pair, ShadeModel::cheap_phong, pipeline::CheapPhongPower::vertex);
}

constexpr Feature kFeatures[] = {
    {"directional light", directional, {}},
    {"point light, attenuation", point, {}},
    {"spot light", spot, {}},
    {"several lights", several, {}},
    {"materials, colour material", materials, {}},
    {"two-sided lighting", two_sided, {}},
    {"separate specular", separate_specular, {}},
    {"normalize, rescale", normal_scaling, {}},
    {"Phong (GLSL)", phong, {}},
    {"cheap Phong, power per pixel (GLSL)", cheap_phong_pixel, {}},
    {"cheap Phong, power at vertex (GLSL)", cheap_phong_vertex, {}},
};

}  // namespace

std::span<const Feature> lighting_features() { return kFeatures; }

}  // namespace barrido::crosscheck
