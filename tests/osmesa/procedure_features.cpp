// Scenes of textures that are computed, beside the same written in GLSL: noise, wood and marble, stripes and
// checkers, and coordinates by two-part mapping.
#include <glm/matrix.hpp>

#include "pipeline/matrix.h"
#include "tests/osmesa/parts.h"

namespace barrido::crosscheck {
namespace {

using raster::MappingRay;
using raster::MappingSurface;
using raster::PatternKind;

/// A surface lit by Phong's model, whose coordinates are its positions: GLSL stands in for all of it.
DrawCall lit_by_phong(RandomBits& random, ScenePair& pair) {
  DrawCall draw = any_draw(random, pair);
  draw.mesh = random.chance(50) ? bent_plane(random, random.between(1, 3), 0.3f, 1.0f) : sphere(random, 12);
  draw.mesh.texcoord_components[0] = 3;
  for (std::size_t i = 0; i < draw.mesh.position.size(); ++i) {
    draw.mesh.texcoord[0][i] = glm::vec4(glm::vec3(draw.mesh.position[i]), 1.0f);
  }
  draw.state.shade_model = pipeline::ShadeModel::phong;
  draw.state.normalize = true;
  pipeline::Lighting& lighting = draw.state.lighting;
  lighting.enabled = true;
  lighting.lights = {random_light(random, LightKind::directional)};
  lighting.lights[0].ambient = {0.4f, 0.4f, 0.4f, 1};
  lighting.front = random_material(random);
  avoid_zero_power(draw);
  return draw;
}

void patterned(RandomBits& random, ScenePair& pair, PatternKind kind) {
  DrawCall draw = lit_by_phong(random, pair);
  raster::TextureUnit& unit = draw.state.texture_units[0];
  unit.procedure = &raster::kSolidPattern;
  raster::Pattern& pattern = unit.pattern;
  pattern.kind = kind;
  pattern.octaves = random.between(1, 6);
  pattern.gain = random.pick({0.5f, 0.6f});
  pattern.turbulence = kind >= PatternKind::wood ? random.number(0.0f, 1.5f) : 0.0f;
  pattern.colors = {random.color(0, 1), random.color(0, 1)};
  glm::mat4& matrix = draw.state.texture_coordinates[0].matrix;
  matrix = random_rotation(random);
  const float scale = random.number(0.5f, 3.0f);
  for (int column = 0; column < 3; ++column) matrix[column] *= scale;
  matrix[3] = {random.number(-3, 3), random.number(-3, 3), random.number(-3, 3), 1};
  pair.draws.push_back(std::move(draw));
}
void noise(RandomBits& random, ScenePair& pair) { patterned(random, pair, PatternKind::noise); }
void wood(RandomBits& random, ScenePair& pair) { patterned(random, pair, PatternKind::wood); }
void marble(RandomBits& random, ScenePair& pair) { patterned(random, pair, PatternKind::marble); }
void stripes_and_checkers(RandomBits& random, ScenePair& pair) {
  patterned(random, pair, random.chance(50) ? PatternKind::stripes : PatternKind::checker);
}

void mapped(RandomBits& random, ScenePair& pair) {
  DrawCall draw = lit_by_phong(random, pair);
  raster::TextureUnit& unit = draw.state.texture_units[0];
  unit.texture = add_texture(random, pair, {}, 16, true);
  unit.min_filter = raster::MinFilter::linear;
  raster::Mapping& mapping = unit.mapping;
  mapping.surface = random.pick(
      {MappingSurface::planar, MappingSurface::cylinder, MappingSurface::sphere, MappingSurface::box});
  mapping.ray = random.one_of_first<MappingRay>(4);
  mapping.repeats = {static_cast<float>(random.between(1, 2)), static_cast<float>(random.between(1, 2))};
  const glm::mat4 turn = draw.state.texture_coordinates[0].matrix = random_rotation(random);
  const glm::dmat4 eye = glm::dmat4(draw.state.eye_from_object) * glm::inverse(glm::dmat4(turn));
  const glm::dmat3 back = glm::inverse(glm::dmat3(eye));
  for (std::size_t r = 0; r < 3; ++r) {
    const int row = static_cast<int>(r);
    for (std::size_t c = 0; c < 4; ++c) {
      mapping.eye_from_mapping[r][c] = static_cast<float>(eye[static_cast<int>(c)][row]);
    }
    for (std::size_t c = 0; c < 3; ++c) {
      mapping.mapping_from_eye[r][c] = static_cast<float>(back[static_cast<int>(c)][row]);
    }
  }
  pair.draws.push_back(std::move(draw));
}

// Reported, not held: footprints are those of four pixels in a row here and of 2 x 2 there, so what is
// filtered by them differs by a few steps in a few pixels; and the classifier does not know the edges of a
// box, the horizon of a plane's rays and the poles of a sphere, where coordinates jump.
constexpr Gate kReported{.interior = 2, .interior_ppm = 60000, .tie_ppm = 1e6, .held = false};

constexpr Feature kFeatures[] = {
    {"noise (GLSL)", noise, kReported},
    {"wood (GLSL)", wood, kReported},
    {"marble (GLSL)", marble, kReported},
    {"stripes and checkers (GLSL)", stripes_and_checkers, kReported},
    {"two-part mapping (GLSL)", mapped, kReported},
};

}  // namespace

std::span<const Feature> procedure_features() { return kFeatures; }

}  // namespace barrido::crosscheck
