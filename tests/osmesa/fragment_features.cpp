// Scenes of what happens to fragments, of points and lines, and of everything mixed.
#include "tests/osmesa/parts.h"

namespace barrido::crosscheck {
namespace {

using pipeline::PrimitiveMode;

void alpha_test(RandomBits& random, ScenePair& pair) {
  DrawCall draw = any_draw(random, pair);
  draw.mesh = soup(random, random.between(3, 9), 1.1f);
  draw.state.shade_model = pipeline::ShadeModel::flat;  // alpha from a few values, so that no test is a tie
  for (glm::vec4& c : draw.mesh.color) c.a = random.pick({0.0f, 0.25f, 0.5f, 0.75f, 1.0f});
  draw.state.alpha_test = {true, random.one_of_first<raster::Compare>(8),
                           random.pick({0.0f, 0.3f, 0.6f, 1.0f})};
  pair.draws.push_back(std::move(draw));
}

enum class Factors { usual, all };

void choose_factors(RandomBits& random, Factors which, raster::BlendState& b) {
  using raster::BlendFactor;
  if (which == Factors::usual) {
    const auto over = std::array{BlendFactor::src_alpha, BlendFactor::one_minus_src_alpha};
    const auto premultiplied = std::array{BlendFactor::one, BlendFactor::one_minus_src_alpha};
    const auto additive = std::array{BlendFactor::one, BlendFactor::one};
    const auto filter = std::array{BlendFactor::zero, BlendFactor::src_color};
    const auto chosen = random.pick({over, premultiplied, additive, filter});
    b.src_rgb = b.src_alpha = chosen[0];
    b.dst_rgb = b.dst_alpha = chosen[1];
    return;
  }
  b.src_rgb = random.one_of_first<BlendFactor>(15);
  b.src_alpha = random.one_of_first<BlendFactor>(15);
  b.dst_rgb = random.one_of_first<BlendFactor>(14);
  b.dst_alpha = random.one_of_first<BlendFactor>(14);
  b.equation = random.chance(60) ? raster::BlendEquation::add : random.one_of_first<raster::BlendEquation>(5);
  b.constant = random.color(0, 1);
}

void blending(RandomBits& random, ScenePair& pair, Factors factors) {
  pair.height = 64;
  pair.clear.color = random.color(0, 1);
  for (int i = random.between(1, 2); i > 0; --i) {
    // In the window on the grid: blending adds colours up, and with them what snapping vertices changes.
    DrawCall draw;
    draw.mesh = soup(random, random.between(2, 5), 1.2f);
    for (glm::vec4& p : draw.mesh.position) {
      for (int axis = 0; axis < 3; ++axis) p[axis] = static_cast<float>(random.between(-63, 63)) / 64.0f;
    }
    draw.state.depth.test = random.chance(30);
    draw.state.blend.enabled = true;
    choose_factors(random, factors, draw.state.blend);
    pair.draws.push_back(std::move(draw));
  }
}

void usual_blending(RandomBits& random, ScenePair& pair) { blending(random, pair, Factors::usual); }
void all_blending(RandomBits& random, ScenePair& pair) { blending(random, pair, Factors::all); }

void scissor_and_masks(RandomBits& random, ScenePair& pair) {
  pair.clear.color = random.color(0, 1);
  DrawCall draw = any_draw(random, pair);
  draw.mesh = soup(random, random.between(3, 8), 1.3f);
  const int x = random.between(-20, 100);
  const int y = random.between(-20, 80);
  draw.state.scissor = {random.chance(70), x, y, random.between(0, 100), random.between(0, 80)};
  if (random.chance(50)) {
    for (bool& channel : draw.state.color_mask) channel = random.chance(60);
  }
  if (random.chance(50)) {
    draw.state.viewport.x = random.between(-40, 60);
    draw.state.viewport.y = random.between(-40, 60);
    draw.state.viewport.width = random.between(10, 150);
    draw.state.viewport.height = random.between(10, 150);
  }
  pair.draws.push_back(std::move(draw));
}

/// The same surface twice, the second time moved by the offset.
void polygon_offset(RandomBits& random, ScenePair& pair) {
  DrawCall draw = any_draw(random, pair);
  draw.mesh = soup(random, random.between(2, 6), 1.2f);
  pair.draws.push_back(draw);
  for (glm::vec4& c : draw.mesh.color) c = random_color(random);
  const float sign = random.chance(50) ? 1.0f : -1.0f;
  draw.state.polygon_offset = {true, sign * random.number(0, 3),
                               sign * static_cast<float>(random.between(16, 4000))};
  draw.state.depth.compare =
      random.pick({raster::Compare::less, raster::Compare::greater, raster::Compare::less_equal});
  pair.draws.push_back(std::move(draw));
}

void fog(RandomBits& random, ScenePair& pair) {
  DrawCall draw = any_draw(random, pair);
  draw.mesh =
      random.chance(50) ? soup(random, random.between(2, 8), 1.2f) : bent_plane(random, 3, 0.5f, 1.0f);
  raster::FogState& f = draw.state.fog;
  f.enabled = true;
  f.mode = random.one_of_first<raster::FogMode>(3);
  f.density = random.number(0.05f, 0.6f);
  f.start = random.number(1, 4);
  f.end = f.start + random.number(0.5f, 5);
  if (random.chance(15)) std::swap(f.start, f.end);
  f.color = random.color(0, 1);
  pair.draws.push_back(std::move(draw));
}

void points(RandomBits& random, ScenePair& pair) {
  DrawCall draw = any_draw(random, pair);
  draw.mesh = scattered(random, PrimitiveMode::points, random.between(5, 40));
  draw.state.point_size = random.pick({1.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 1.4f, 2.6f, 9.0f});
  pair.draws.push_back(std::move(draw));
}

void lines(RandomBits& random, ScenePair& pair) {
  DrawCall draw = any_draw(random, pair);
  draw.mesh = scattered(random, static_cast<PrimitiveMode>(random.between(1, 3)), random.between(4, 16));
  draw.state.line_width = random.pick({1.0f, 1.0f, 1.0f, 2.0f, 3.0f, 5.0f, 1.4f});
  if (random.chance(40)) draw.state.shade_model = pipeline::ShadeModel::flat;
  pair.draws.push_back(std::move(draw));
}

/// Within the frame, cut by planes of the user: along the sides of the view volume Mesa does not close
/// outlines (as another maker's hardware, say its sources), which OpenGL 1.3, section 2.11, asks for.
void polygon_modes(RandomBits& random, ScenePair& pair) {
  DrawCall draw = any_draw(random, pair);
  draw.mesh = in_mode(random, static_cast<PrimitiveMode>(random.between(4, 9)));
  draw.state.eye_from_object = translation(0, 0, -6) * random_rotation(random);
  for (glm::vec4& p : draw.mesh.position) p = glm::vec4(0.7f * glm::vec3(p), 1.0f);
  draw.state.polygon_mode = random.chance(60) ? pipeline::PolygonMode::line : pipeline::PolygonMode::point;
  const bool clips =
      draw.state.polygon_mode == pipeline::PolygonMode::line || draw.mesh.mode <= PrimitiveMode::triangle_fan;
  for (int i = clips && random.chance(50) ? random.between(1, 2) : 0; i > 0; --i) {
    glm::vec4 plane = random_color(random, -1, 1);
    plane.w = 6.0f * plane.z + random.number(-0.3f, 0.3f);
    draw.state.clip_planes.push_back(plane);
  }
  draw.state.cull_face = random.one_of_first<pipeline::CullFace>(3);
  draw.state.point_size = random.pick({1.0f, 3.0f, 4.0f});
  pair.draws.push_back(std::move(draw));
}

/// Lights, a texture, fog, blending and clip planes at once.
void mixed(RandomBits& random, ScenePair& pair) {
  pair.clear.color = random.color(0, 1);
  for (int i = random.between(1, 2); i > 0; --i) {
    DrawCall draw = any_draw(random, pair);
    draw.mesh = random.chance(50) ? sphere(random, 12) : bent_plane(random, 3, 0.4f, 1.5f);
    pipeline::Lighting& lighting = draw.state.lighting;
    lighting.enabled = random.chance(70);
    lighting.lights = {random_light(random, any_kind(random)), random_light(random, any_kind(random))};
    lighting.front = random_material(random);
    lighting.back = random_material(random);
    lighting.two_sided = random.chance(40);
    lighting.separate_specular = random.chance(40);
    lighting.local_viewer = random.chance(50);
    raster::TextureUnit& unit = draw.state.texture_units[0];
    if (random.chance(70)) unit.texture = add_texture(random, pair, random_wraps(random), 16, true);
    unit.min_filter = raster::MinFilter::linear;
    unit.env_mode = random.one_of_first<raster::TextureEnvMode>(5);
    unit.env_color = random.color(0, 1);
    // Mesa does not clamp the sum with the secondary colour before fog (OpenGL 1.3, section 3.9, does).
    draw.state.fog.enabled = random.chance(50) && !lighting.separate_specular;
    draw.state.fog.density = 0.2f;
    draw.state.fog.color = random.color(0, 1);
    draw.state.blend = {random.chance(40), raster::BlendFactor::src_alpha,
                        raster::BlendFactor::one_minus_src_alpha, raster::BlendFactor::one,
                        raster::BlendFactor::one_minus_src_alpha};
    draw.state.cull_face = random.one_of_first<pipeline::CullFace>(3);
    if (random.chance(30)) draw.state.clip_planes = {glm::vec4(0.3f, 0.6f, 0.2f, 0.8f)};
    pair.draws.push_back(std::move(draw));
  }
}

constexpr Feature kFeatures[] = {
    {"alpha test", alpha_test, {}},
    {"blending, over, additive, filter", usual_blending, {}},
    {"blending, all factors and equations", all_blending, {}},
    {"scissor, colour mask, viewport", scissor_and_masks, {}},
    {"polygon offset", polygon_offset, {}},
    {"fog", fog, {}},
    {"points", points, {.edge_ppm = 0, .held_by_softpipe = false}},
    // Ends: OpenGL allows a fragment to be one unit off, and one more or less (1.3, section 3.4.1).
    {"lines", lines, {.edge_ppm = 1000, .held_by_softpipe = false}},
    {"polygon mode line and point", polygon_modes, {.edge_ppm = 300, .held_by_softpipe = false}},
    // softpipe blends over sums above 1 that it has not clamped when it stored them.
    {"everything mixed", mixed, {.held_by_softpipe = false}},
};

}  // namespace

std::span<const Feature> fragment_features() { return kFeatures; }

}  // namespace barrido::crosscheck
