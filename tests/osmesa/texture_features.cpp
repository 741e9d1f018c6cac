// Scenes of textures: wraps, filters, levels, cube maps, generated coordinates, matrices, environments.
#include "pipeline/matrix.h"
#include "tests/osmesa/parts.h"

namespace barrido::crosscheck {
namespace {

using pipeline::TexGenMode;
using raster::MagFilter;
using raster::MinFilter;
using raster::TextureEnvMode;

/// A textured plane or sphere, replaced colours; `scale` repeats of the texture.
DrawCall textured(RandomBits& random, ScenePair& pair, const raster::Texture* texture, float scale) {
  DrawCall draw = any_draw(random, pair);
  const float bump = random.chance(50) ? 0.0f : 0.4f;
  draw.mesh = random.chance(80) ? bent_plane(random, random.between(1, 3), bump, scale) : sphere(random, 10);
  raster::TextureUnit& unit = draw.state.texture_units[0];
  unit.texture = texture;
  unit.env_mode = TextureEnvMode::replace;
  return draw;
}

void unit_filters(DrawCall& draw, MinFilter min, MagFilter mag) {
  draw.state.texture_units[0].min_filter = min;
  draw.state.texture_units[0].mag_filter = mag;
}

void nearest_wraps(RandomBits& random, ScenePair& pair) {
  DrawCall draw =
      textured(random, pair, add_texture(random, pair, random_wraps(random)), random.number(1, 4));
  unit_filters(draw, MinFilter::nearest, MagFilter::nearest);
  pair.draws.push_back(std::move(draw));
}

void bilinear_wraps(RandomBits& random, ScenePair& pair) {
  DrawCall draw =
      textured(random, pair, add_texture(random, pair, random_wraps(random)), random.number(1, 4));
  unit_filters(draw, MinFilter::linear, MagFilter::linear);
  pair.draws.push_back(std::move(draw));
}

/// Wraps that the classifier can sample itself.
raster::TextureOptions plain_wraps(RandomBits& random) {
  raster::TextureOptions options;
  options.wrap_s = random.one_of_first<raster::Wrap>(3);
  options.wrap_t = random.one_of_first<raster::Wrap>(3);
  return options;
}

void levels(RandomBits& random, ScenePair& pair, bool linear_between) {
  const int side = random.pick({16, 32, 64, 0});
  const raster::Texture* texture = add_texture(random, pair, plain_wraps(random), side);
  DrawCall draw = textured(random, pair, texture, random.number(1, 8));
  const MinFilter filters[] = {MinFilter::nearest_mipmap_nearest, MinFilter::linear_mipmap_nearest,
                               MinFilter::nearest_mipmap_linear, MinFilter::linear_mipmap_linear};
  const MinFilter min = filters[random.between(0, 1) + (linear_between ? 2 : 0)];
  // With a linear magnification filter these two magnify up to a level of detail of 1/2 (OpenGL 1.3,
  // section 3.8.9); llvmpipe's limit is 0 always, so the case is left out.
  const bool half = min == MinFilter::nearest_mipmap_nearest || min == MinFilter::nearest_mipmap_linear;
  unit_filters(draw, min, half ? MagFilter::nearest : random.one_of_first<MagFilter>(2));
  if (random.chance(40)) draw.state.texture_units[0].lod_bias = random.number(-2, 3);
  pair.draws.push_back(std::move(draw));
}
void nearest_level(RandomBits& random, ScenePair& pair) { levels(random, pair, false); }
void trilinear(RandomBits& random, ScenePair& pair) { levels(random, pair, true); }

/// A cube map looked up by direction: the sphere's positions, or the plane's.
DrawCall cubed(RandomBits& random, ScenePair& pair, bool mipmaps) {
  DrawCall draw = textured(random, pair, add_cube(random, pair, mipmaps), 1.0f);
  if (random.chance(60)) draw.mesh = sphere(random, 10);
  const glm::mat4 turn = random_rotation(random);
  draw.mesh.texcoord_components[0] = 3;
  for (std::size_t i = 0; i < draw.mesh.position.size(); ++i) {
    draw.mesh.texcoord[0][i] =
        turn * glm::vec4(glm::vec3(draw.mesh.position[i]) + glm::vec3(0.01f, 0.02f, 0.3f), 0);
    draw.mesh.texcoord[0][i].w = 1.0f;
  }
  return draw;
}

void cube_nearest(RandomBits& random, ScenePair& pair) {
  DrawCall draw = cubed(random, pair, false);
  unit_filters(draw, MinFilter::nearest, MagFilter::nearest);
  pair.draws.push_back(std::move(draw));
}
void cube_linear(RandomBits& random, ScenePair& pair) {
  DrawCall draw = cubed(random, pair, false);
  unit_filters(draw, MinFilter::linear, MagFilter::linear);
  pair.draws.push_back(std::move(draw));
}
void cube_trilinear(RandomBits& random, ScenePair& pair) {
  DrawCall draw = cubed(random, pair, true);
  unit_filters(draw, MinFilter::linear_mipmap_linear, MagFilter::linear);
  draw.state.texture_units[0].lod_bias = random.number(-1, 2);
  pair.draws.push_back(std::move(draw));
}

void generate_linear(RandomBits& random, ScenePair& pair) {
  DrawCall draw = textured(random, pair, add_texture(random, pair, random_wraps(random)), 1.0f);
  unit_filters(draw, MinFilter::linear, MagFilter::linear);
  const int axes = random.chance(25) ? 4 : 2;
  for (int axis = 0; axis < axes; ++axis) {
    pipeline::TexGenCoordinate& rule =
        draw.state.texture_coordinates[0].generation[static_cast<std::size_t>(axis)];
    rule.enabled = axis < 2 ? random.chance(80) : axis == 3;
    rule.mode = random.one_of_first<TexGenMode>(2);
    rule.object_plane = random_color(random, -2, 2);
    rule.eye_plane = random_color(random, -1, 1);
    if (axis == 3) {  // q stays positive
      rule.mode = TexGenMode::object_linear;
      rule.object_plane = {0.2f, 0.1f, 0.1f, 1.0f};
    }
  }
  pair.draws.push_back(std::move(draw));
}

void generate(DrawCall& draw, TexGenMode mode, std::size_t axes) {
  for (std::size_t axis = 0; axis < axes; ++axis) {
    draw.state.texture_coordinates[0].generation[axis].enabled = true;
    draw.state.texture_coordinates[0].generation[axis].mode = mode;
  }
}

void sphere_map(RandomBits& random, ScenePair& pair) {
  DrawCall draw = textured(random, pair, add_texture(random, pair, random_wraps(random)), 1.0f);
  if (random.chance(50)) draw.mesh = sphere(random, 14);
  draw.state.cull_face = pipeline::CullFace::back;
  unit_filters(draw, MinFilter::linear, MagFilter::linear);
  generate(draw, TexGenMode::sphere_map, 2);
  pair.draws.push_back(std::move(draw));
}

void cube_generated(RandomBits& random, ScenePair& pair) {
  DrawCall draw = textured(random, pair, add_cube(random, pair, false), 1.0f);
  if (random.chance(60)) draw.mesh = sphere(random, 14);
  const bool nearest = random.chance(50);
  unit_filters(draw, nearest ? MinFilter::nearest : MinFilter::linear,
               nearest ? MagFilter::nearest : MagFilter::linear);
  generate(draw, random.chance(50) ? TexGenMode::reflection_map : TexGenMode::normal_map, 3);
  if (random.chance(50)) draw.state.texture_coordinates[0].matrix = random_rotation(random);
  pair.draws.push_back(std::move(draw));
}

void texture_matrix(RandomBits& random, ScenePair& pair) {
  DrawCall draw = textured(random, pair, add_texture(random, pair, random_wraps(random)), 1.5f);
  unit_filters(draw, MinFilter::linear, MagFilter::linear);
  glm::mat4& m = draw.state.texture_coordinates[0].matrix;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 2; ++row) m[column][row] = random.number(-2, 2);
  }
  if (random.chance(40)) {  // projective
    m[0][3] = random.number(-0.2f, 0.2f);
    m[1][3] = random.number(-0.1f, 0.1f);
  }
  if (random.chance(30)) {
    draw.mesh.texcoord_components[0] = 4;
    for (glm::vec4& t : draw.mesh.texcoord[0]) t.w = random.number(0.8f, 1.5f);
  }
  pair.draws.push_back(std::move(draw));
}

void environment(RandomBits& random, ScenePair& pair, DrawCall& draw, std::size_t number, int modes) {
  raster::TextureUnit& unit = draw.state.texture_units[number];
  unit.texture = add_texture(random, pair, {}, 0, true);
  const bool nearest = false;
  unit.min_filter = nearest ? MinFilter::nearest : MinFilter::linear;
  unit.env_mode = random.one_of_first<TextureEnvMode>(modes);
  unit.env_color = random.color(0, 1);
  generate_texture_env_combine(random, unit);
}

void one_environment(RandomBits& random, ScenePair& pair) {
  DrawCall draw = textured(random, pair, nullptr, 1.5f);
  environment(random, pair, draw, 0, 5);
  pair.draws.push_back(std::move(draw));
}

void two_units(RandomBits& random, ScenePair& pair) {
  DrawCall draw = textured(random, pair, nullptr, 1.5f);
  environment(random, pair, draw, 0, 5);
  environment(random, pair, draw, 1, 5);
  if (random.chance(10)) draw.state.texture_units[0].texture = nullptr;
  pair.draws.push_back(std::move(draw));
}

void combine(RandomBits& random, ScenePair& pair) {
  DrawCall draw = textured(random, pair, nullptr, 1.5f);
  environment(random, pair, draw, 0, 6);
  environment(random, pair, draw, 1, 6);
  draw.state.texture_units[random.chance(50) ? 1 : 0].env_mode = TextureEnvMode::combine;
  pair.draws.push_back(std::move(draw));
}

constexpr Feature kFeatures[] = {
    {"nearest, all wraps, any size", nearest_wraps, {.interior_ppm = 0}},
    {"bilinear, all wraps, any size", bilinear_wraps, {}},
    {"nearest level, lod bias", nearest_level, {.tie_ppm = 5000, .held_by_softpipe = false}},
    {"between levels, lod bias", trilinear, {.held_by_softpipe = false}},
    {"cube map, nearest", cube_nearest, {.interior_ppm = 0}},
    {"cube map, bilinear", cube_linear, {}},
    {"cube map, trilinear", cube_trilinear, {.held_by_softpipe = false}},
    {"texgen, object and eye linear", generate_linear, {}},
    {"texgen, sphere map", sphere_map, {}},
    {"texgen, reflection and normal map", cube_generated, {}},
    {"texture matrix, projective", texture_matrix, {}},
    {"texture environment, one unit", one_environment, {}},
    {"texture environment, two units", two_units, {}},
    {"combine, two units", combine, {}},
};

}  // namespace

void generate_texture_env_combine(RandomBits& random, raster::TextureUnit& unit) {
  for (raster::CombineChannel* channel : {&unit.combine.rgb, &unit.combine.alpha}) {
    const bool alpha = channel == &unit.combine.alpha;
    channel->function = random.one_of_first<raster::CombineFunction>(6);
    channel->scale = random.pick({1.0f, 1.0f, 2.0f, 4.0f});
    for (std::size_t i = 0; i < 3; ++i) {
      channel->source[i] = random.one_of_first<raster::CombineSource>(4);
      channel->operand[i] = static_cast<raster::CombineOperand>(random.between(alpha ? 2 : 0, 3));
    }
  }
}

std::span<const Feature> texture_features() { return kFeatures; }

}  // namespace barrido::crosscheck
