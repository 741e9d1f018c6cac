// Scenes of primitives, facing, depth, interpolation and clipping.
#include "pipeline/matrix.h"
#include "tests/osmesa/parts.h"

namespace barrido::crosscheck {
namespace {

using pipeline::PrimitiveMode;
using pipeline::ShadeModel;

/// Window coordinates as object coordinates; the frame's sides are powers of two, so the transform is exact.
DrawCall window_draw(ScenePair& pair) {
  pair.width = 128;
  pair.height = 64;
  DrawCall draw;
  draw.state.clip_from_eye = pipeline::orthographic(0, pair.width, 0, pair.height, -1, 1);
  return draw;
}

enum class Reach { inside, beyond };

/// Corners on the grid of 1/256 pixel or anywhere, within the frame or beyond it.
void place_in_window(RandomBits& random, Mesh& mesh, bool shared, bool on_grid, Reach reach) {
  const float beyond = reach == Reach::beyond ? 20.0f : 0.0f;
  for (glm::vec4& p : mesh.position) {
    float x = random.number(-beyond, 128.0f + beyond);
    float y = random.number(-beyond, 64.0f + beyond);
    if (shared) {
      x = 64.0f + 55.0f * p.x + random.number(-5, 5);
      y = 32.0f + 25.0f * p.y + random.number(-3, 3);
    }
    if (on_grid) {
      // Half of them on pixel centres and edges, where ties are.
      const float grid = random.chance(50) ? 2.0f : 256.0f;
      x = static_cast<float>(static_cast<int>(x * grid)) / grid;
      y = static_cast<float>(static_cast<int>(y * grid)) / grid;
    }
    p = {x, y, 0, 1};
  }
}

void coverage(RandomBits& random, ScenePair& pair, bool on_grid, Reach reach) {
  DrawCall draw = window_draw(pair);
  draw.mesh = soup(random, random.between(3, 12), 1.0f);
  const bool shared = random.chance(50);
  if (shared) draw.mesh = bent_plane(random, random.between(2, 5), 0.0f, 1.0f);
  place_in_window(random, draw.mesh, shared, on_grid, reach);
  draw.state.shade_model = ShadeModel::flat;
  pair.draws.push_back(std::move(draw));
}
void coverage_grid(RandomBits& random, ScenePair& pair) { coverage(random, pair, true, Reach::inside); }
void coverage_float(RandomBits& random, ScenePair& pair) { coverage(random, pair, false, Reach::inside); }
void coverage_beyond(RandomBits& random, ScenePair& pair) { coverage(random, pair, false, Reach::beyond); }

PrimitiveMode any_polygon(RandomBits& random) { return static_cast<PrimitiveMode>(random.between(4, 9)); }

void primitive_modes(RandomBits& random, ScenePair& pair) {
  for (int i = random.between(1, 3); i > 0; --i) {
    DrawCall draw = any_draw(random, pair);
    draw.mesh = in_mode(random, any_polygon(random));
    pair.draws.push_back(std::move(draw));
  }
}

void provoking_vertex(RandomBits& random, ScenePair& pair) {
  primitive_modes(random, pair);
  for (DrawCall& draw : pair.draws) {
    draw.state.shade_model = ShadeModel::flat;
    if (random.chance(40)) {  // clipped: the colour must be taken before
      draw.state.clip_planes = {random_color(random, -1, 1)};
      draw.state.clip_planes[0].w = -3.0f * draw.state.clip_planes[0].z;
    }
  }
}

void culling(RandomBits& random, ScenePair& pair) {
  DrawCall draw = any_draw(random, pair);
  draw.mesh = random.chance(40)   ? sphere(random, 10)
              : random.chance(50) ? soup(random, 8, 0.9f)
                                  : in_mode(random, any_polygon(random));
  if (random.chance(40)) {
    draw.state.eye_from_object = pipeline::product(
        draw.state.eye_from_object, glm::mat4{{-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}});
  }
  draw.state.cull_face = random.one_of_first<pipeline::CullFace>(random.chance(5) ? 4 : 3);
  draw.state.front_face = random.one_of_first<pipeline::FrontFace>(2);
  if (random.chance(30)) draw.state.shade_model = ShadeModel::flat;
  pair.draws.push_back(std::move(draw));
}

void depth(RandomBits& random, ScenePair& pair) {
  DrawCall draw = any_draw(random, pair);
  draw.mesh = soup(random, random.between(4, 10), 1.0f);
  pair.draws.push_back(draw);
  if (random.chance(40)) {
    draw.mesh = soup(random, random.between(2, 6), 1.0f);
  } else {  // the same surfaces again, where equal and not equal differ
    for (glm::vec4& c : draw.mesh.color) c = random_color(random);
  }
  draw.state.depth.compare = random.one_of_first<raster::Compare>(8);
  draw.state.depth.write = random.chance(70);
  pair.draws.push_back(draw);
  draw.mesh = soup(random, 3, 1.2f);
  draw.state.depth.compare = random.one_of_first<raster::Compare>(8);
  pair.draws.push_back(draw);
  if (random.chance(40)) pair.clear.depth = random.number(0.3f, 1.0f);
  if (random.chance(40)) {
    const float a = random.number(0, 1);
    const float b = random.number(0, 1);
    for (DrawCall& d : pair.draws) {
      d.state.viewport.depth_near = a;
      d.state.viewport.depth_far = b;
    }
  }
}

/// On the grid both renderers interpolate from the same positions; elsewhere one of them from snapped ones.
void gouraud_on_grid(RandomBits& random, ScenePair& pair, bool perspective) {
  DrawCall draw = window_draw(pair);
  const bool shared = random.chance(50);
  draw.mesh = shared ? bent_plane(random, random.between(1, 3), 0.0f, 1.0f)
                     : soup(random, random.between(1, 5), 1.0f);
  place_in_window(random, draw.mesh, shared, true, Reach::inside);
  if (perspective) {
    draw.mesh.position_components = 4;
    for (glm::vec4& p : draw.mesh.position) p *= random.pick({0.5f, 1.0f, 2.0f, 4.0f});
  }
  pair.draws.push_back(std::move(draw));
}
void gouraud_affine(RandomBits& random, ScenePair& pair) { gouraud_on_grid(random, pair, false); }
void gouraud_perspective(RandomBits& random, ScenePair& pair) { gouraud_on_grid(random, pair, true); }

void gouraud_anywhere(RandomBits& random, ScenePair& pair) {
  DrawCall draw = any_draw(random, pair);
  draw.mesh = random.chance(50) ? soup(random, random.between(2, 8), 1.2f)
                                : bent_plane(random, random.between(1, 4), 0.4f, 1.0f);
  pair.draws.push_back(std::move(draw));
}

/// Triangles that reach behind the eye and beyond all planes.
void clipping(RandomBits& random, ScenePair& pair) {
  DrawCall draw = perspective_draw(random, pair);
  draw.mesh = soup(random, random.between(2, 7), 2.0f);
  const float scale = random.pick({2.0f, 4.0f, 12.0f});
  for (glm::vec4& p : draw.mesh.position) p = glm::vec4(glm::vec3(p) * scale, 1.0f);
  if (random.chance(20)) {  // w of the object coordinates
    draw.mesh.position_components = 4;
    for (glm::vec4& p : draw.mesh.position) p *= random.number(0.5f, 2.0f);
  }
  draw.state.depth_clamp = random.chance(20);
  pair.draws.push_back(std::move(draw));
}

void user_clip_planes(RandomBits& random, ScenePair& pair) {
  DrawCall draw = any_draw(random, pair);
  draw.mesh = random.chance(50) ? sphere(random, 10) : soup(random, random.between(3, 8), 1.2f);
  for (int i = random.between(1, 6); i > 0; --i) {
    glm::vec4 plane = random_color(random, -1, 1);
    plane.w = 4.0f * plane.z + random.number(-0.1f, 0.9f);
    draw.state.clip_planes.push_back(plane);
  }
  pair.draws.push_back(std::move(draw));
}

constexpr Feature kFeatures[] = {
    {"coverage, vertices on the 1/256 grid", coverage_grid, {.edge_ppm = 0}},
    {"coverage, arbitrary floats", coverage_float, {.edge_ppm = 5}},
    {"coverage, beyond the frame", coverage_beyond, {}},
    {"primitive modes", primitive_modes, {}},
    {"provoking vertex", provoking_vertex, {}},
    {"culling and winding", culling, {}},
    {"depth functions", depth, {}},
    {"Gouraud, affine", gouraud_affine, {.interior_ppm = 100}},
    {"Gouraud, perspective", gouraud_perspective, {.interior_ppm = 100}},
    {"Gouraud, arbitrary positions", gouraud_anywhere, {}},
    {"clipping, mixed signs of w", clipping, {}},
    {"user clip planes", user_clip_planes, {}},
};

}  // namespace

std::span<const Feature> geometry_features() { return kFeatures; }

}  // namespace barrido::crosscheck
