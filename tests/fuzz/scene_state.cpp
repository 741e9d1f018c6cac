// The state of a draw out of bytes. Every field takes every value it can; a group of fields that most draws
// leave alone costs one byte.
#include <algorithm>

#include "random_textures.h"
#include "scene_choices.h"

namespace barrido::fuzz {
namespace {

using raster::testing::RandomBits;
using raster::testing::TexturePool;

glm::vec3 any_vec3(Input& input) {
  const float x = input.number(), y = input.number(), z = input.number();
  return {x, y, z};
}

glm::vec4 any_vec4(Input& input) {
  const glm::vec3 xyz = any_vec3(input);
  return {xyz, input.number()};
}

std::array<float, 4> any_color(Input& input) {
  const glm::vec4 color = any_vec4(input);
  return {color.x, color.y, color.z, color.w};
}

/// The identity, a projection in perspective, or any numbers.
glm::mat4 any_matrix(Input& input) {
  glm::mat4 matrix{1.0f};
  const int kind = input.between(0, 7);
  if (kind == 1) {
    matrix[2] = {0, 0, -1, -1};
    matrix[3] = {0, 0, -1, 0};
  }
  if (kind == 2) matrix[3] = any_vec4(input);
  if (kind == 3) {
    for (int c = 0; c < 4; ++c) matrix[c] = any_vec4(input);
  }
  return matrix;
}

pipeline::Viewport any_viewport(Input& input) {
  pipeline::Viewport viewport;
  if (input.byte() >= 64) return viewport;
  viewport.x = input.between(-300, 300);
  viewport.y = input.between(-300, 300);
  viewport.width = input.between(0, 400);
  viewport.height = input.flag() ? input.between(-1, 17000) : input.between(0, 400);
  viewport.depth_near = input.fraction();
  viewport.depth_far = input.flag() ? input.fraction() : input.number();
  return viewport;
}

pipeline::Light any_light(Input& input) {
  pipeline::Light light;
  light.position = any_vec4(input);
  if (input.flag()) light.position.w = input.pick({0.0f, 1.0f});
  if (input.flag()) light.diffuse = any_vec4(input);
  if (input.flag()) {
    light.ambient = any_vec4(input);
    light.specular = any_vec4(input);
  }
  if (input.flag()) {
    light.constant_attenuation = input.number();
    light.linear_attenuation = input.number();
    light.quadratic_attenuation = input.number();
    light.range = input.number();
  }
  if (input.flag()) {
    light.spot_direction = any_vec3(input);
    light.spot_cutoff_deg = input.flag() ? static_cast<float>(input.between(0, 90)) : input.number();
    light.spot_exponent = input.number();
    light.spot_inner_cos = input.number();
    light.spot_outer_cos = input.number();
  }
  return light;
}

pipeline::Material any_material(Input& input) {
  pipeline::Material material;
  material.shininess = input.flag() ? static_cast<float>(input.byte()) : input.number();
  if (input.flag()) material.specular = any_vec4(input);
  if (input.flag()) material.diffuse = any_vec4(input);
  if (input.flag()) {
    material.ambient = any_vec4(input);
    material.emission = any_vec4(input);
  }
  return material;
}

void any_lighting(Input& input, pipeline::Lighting& lighting) {
  lighting.enabled = true;
  for (int i = input.between(0, 3); i > 0; --i) lighting.lights.push_back(any_light(input));
  if (input.byte() == 255) lighting.lights.resize(static_cast<std::size_t>(input.between(60, 70)));
  if (input.flag()) lighting.ambient = any_vec4(input);
  lighting.local_viewer = input.flag();
  lighting.two_sided = input.flag();
  lighting.separate_specular = input.flag();
  lighting.specular_model = input.one_of_first<pipeline::SpecularModel>(2);
  lighting.color_material = input.one_of_first<pipeline::ColorMaterial>(6);
  lighting.front = any_material(input);
  if (lighting.two_sided) lighting.back = any_material(input);
}

void any_combine(Input& input, raster::CombineState& combine) {
  for (raster::CombineChannel* channel : {&combine.rgb, &combine.alpha}) {
    channel->function = input.one_of_first<raster::CombineFunction>(8);
    for (std::size_t k = 0; k < 3; ++k) {
      channel->source[k] = input.one_of_first<raster::CombineSource>(4);
      channel->operand[k] = input.one_of_first<raster::CombineOperand>(4);
    }
    channel->scale = input.pick({1.0f, 2.0f, 4.0f});
  }
}

void any_texture_unit(Input& input, raster::TextureUnit& unit) {
  static const TexturePool pool(2024);
  RandomBits which(input.byte());
  unit.texture = input.byte() < 80 ? &pool.cube(which) : &pool.flat(which);
  unit.min_filter = input.one_of_first<raster::MinFilter>(8);
  unit.mag_filter = input.one_of_first<raster::MagFilter>(2);
  if (input.byte() < 64) unit.lod_bias = input.number();
  unit.env_mode = input.one_of_first<raster::TextureEnvMode>(6);
  if (unit.env_mode == raster::TextureEnvMode::combine) any_combine(input, unit.combine);
  if (input.flag()) unit.env_color = any_color(input);
  if (input.byte() < 48) unit.max_anisotropy = 1 + input.byte() % raster::kMaxAnisotropy;
  if (input.byte() >= 64) return;
  unit.role = input.one_of_first<raster::TextureRole>(5);
  unit.strength = input.number();
  unit.bump_form = input.one_of_first<raster::BumpForm>(2);
}

/// A pattern in place of the unit's picture, its point mapped, its tiles changed; or none of it.
void any_procedure(Input& input, raster::TextureUnit& unit) {
  if (input.flag()) {
    unit.procedure = input.flag() ? &raster::kSolidPattern : &raster::kSurfacePattern;
    raster::Pattern& pattern = unit.pattern;
    pattern.kind = input.one_of_first<raster::PatternKind>(5);
    pattern.octaves = input.between(1, raster::kMaxOctaves);
    pattern.gain = input.number();
    pattern.turbulence = input.number();
    pattern.has_threshold = input.flag();
    pattern.threshold = input.number();
    for (std::array<float, 4>& color : pattern.colors) color = any_color(input);
  }
  unit.tiles = input.one_of_first<raster::TileChange>(4);
  if (input.flag() || (unit.procedure == nullptr && unit.texture->is_cube())) return;
  raster::Mapping& mapping = unit.mapping;
  mapping.surface = input.one_of_first<raster::MappingSurface>(5);
  mapping.ray = input.one_of_first<raster::MappingRay>(4);
  for (std::size_t i = 0; i < 2; ++i) {
    mapping.repeats[i] = input.number();
    mapping.offset[i] = input.number();
  }
  for (std::size_t r = 0; r < 3; ++r) {
    for (float& element : mapping.eye_from_mapping[r]) element = input.number();
    for (float& element : mapping.mapping_from_eye[r]) element = input.number();
  }
}

void any_texture_coordinates(Input& input, pipeline::TextureCoordinates& coordinates) {
  if (input.byte() < 64) coordinates.matrix = any_matrix(input);
  if (input.byte() >= 96) return;
  const auto mode = input.one_of_first<pipeline::TexGenMode>(5);
  for (pipeline::TexGenCoordinate& coordinate : coordinates.generation) {
    coordinate.enabled = input.byte() < 192;
    coordinate.mode = input.byte() < 224 ? mode : input.one_of_first<pipeline::TexGenMode>(5);
    if (input.byte() >= 96) continue;
    coordinate.object_plane = any_vec4(input);
    coordinate.eye_plane = any_vec4(input);
  }
}

void any_textures(Input& input, pipeline::State& state) {
  const int units = input.between(0, raster::kMaxTextureUnits);
  for (int unit = 0; unit < units; ++unit) {
    const auto slot = static_cast<std::size_t>(unit);
    if (input.byte() < 224) any_texture_unit(input, state.texture_units[slot]);
    any_texture_coordinates(input, state.texture_coordinates[slot]);
  }
}

void any_tests(Input& input, pipeline::State& state) {
  state.depth = {input.flag(), input.flag(), input.one_of_first<raster::Compare>(8)};
  if (input.byte() < 64) state.polygon_offset = {true, input.number(), input.number()};
  if (input.byte() < 64) {
    state.alpha_test = {true, input.one_of_first<raster::Compare>(8), input.number()};
  }
  if (input.byte() < 48) {
    const int x = input.between(-70000, 70000), y = input.between(-20, 60);
    state.scissor = {true, x, y, input.between(-1, 300), input.between(0, 2147483647)};
  }
}

void any_output(Input& input, pipeline::State& state) {
  state.clamp_colors = input.flag();
  if (input.byte() < 64) {
    state.fog = {true,           input.one_of_first<raster::FogMode>(3),
                 input.number(), input.number(),
                 input.number(), any_color(input)};
  }
  if (input.byte() < 96) {
    raster::BlendState& blend = state.blend;
    blend.enabled = true;
    for (raster::BlendFactor* factor : {&blend.src_rgb, &blend.dst_rgb, &blend.src_alpha, &blend.dst_alpha}) {
      *factor = input.one_of_first<raster::BlendFactor>(15);
    }
    blend.equation = input.one_of_first<raster::BlendEquation>(5);
    if (input.flag()) blend.constant = any_color(input);
  }
  state.sorted = input.byte() < 48;
  if (input.byte() < 32) {
    for (bool& channel : state.color_mask) channel = input.flag();
  }
}

}  // namespace

pipeline::State any_state(Input& input) {
  pipeline::State state;
  state.eye_from_object = any_matrix(input);
  state.clip_from_eye = any_matrix(input);
  state.viewport = any_viewport(input);
  state.normalize = input.flag();
  state.rescale_normal = input.flag();
  if (input.byte() < 48) {
    for (int i = input.between(1, 9); i > 0; --i) state.clip_planes.push_back(any_vec4(input));
  }
  state.depth_clamp = input.byte() < 64;
  state.shade_model = input.one_of_first<pipeline::ShadeModel>(4);
  state.flat_at = input.one_of_first<pipeline::FlatAt>(2);
  state.cheap_phong_power = input.one_of_first<pipeline::CheapPhongPower>(2);
  state.color_interpolation = input.one_of_first<pipeline::ColorInterpolation>(2);
  state.texture_interpolation = input.one_of_first<pipeline::TextureInterpolation>(2);
  if (input.byte() < 144) any_lighting(input, state.lighting);
  any_textures(input, state);
  state.cull_face = input.one_of_first<pipeline::CullFace>(4);
  state.front_face = input.one_of_first<pipeline::FrontFace>(2);
  state.polygon_mode = input.one_of_first<pipeline::PolygonMode>(3);
  if (input.byte() < 64) {
    // Wider ones take the reference a minute, and are clamped to the frame's largest side anyway.
    state.point_size = std::min(input.number(), 60.0f);
    state.line_width = std::min(input.number(), 60.0f);
  }
  any_tests(input, state);
  any_output(input, state);
  for (raster::TextureUnit& unit : state.texture_units) {
    if (unit.texture != nullptr && input.byte() >= 160) any_procedure(input, unit);
  }
  return state;
}

}  // namespace barrido::fuzz
