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

void coverage(RandomBits& random, ScenePair& pair, bool on_grid) {
  DrawCall draw = window_draw(pair);
  draw.mesh = soup(random, random.between(3, 12), 1.0f);
  const bool shared = random.chance(50);
  if (shared) draw.mesh = bent_plane(random, random.between(2, 5), 0.0f, 1.0f);
  for (glm::vec4& p : draw.mesh.position) {
    float x = random.number(-20.0f, 148.0f);
    float y = random.number(-20.0f, 84.0f);
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
  draw.state.shade_model = ShadeModel::flat;
  pair.draws.push_back(std::move(draw));
}
void coverage_grid(RandomBits& random, ScenePair& pair) { coverage(random, pair, true); }
void coverage_float(RandomBits& random, ScenePair& pair) { coverage(random, pair, false); }

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

void gouraud(RandomBits& random, ScenePair& pair, DrawCall draw) {
  draw.mesh = random.chance(50) ? soup(random, random.between(2, 8), 1.2f)
                                : bent_plane(random, random.between(1, 4), 0.4f, 1.0f);
  pair.draws.push_back(std::move(draw));
}
void gouraud_affine(RandomBits& random, ScenePair& pair) { gouraud(random, pair, affine_draw(random, pair)); }
void gouraud_perspective(RandomBits& random, ScenePair& pair) {
  gouraud(random, pair, perspective_draw(random, pair));
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
    {"coverage, arbitrary floats", coverage_float, {}},
    {"primitive modes", primitive_modes, {}},
    {"provoking vertex", provoking_vertex, {}},
    {"culling and winding", culling, {}},
    {"depth functions", depth, {}},
    {"Gouraud, affine", gouraud_affine, {}},
    {"Gouraud, perspective", gouraud_perspective, {}},
    {"clipping, mixed signs of w", clipping, {.edge_ppm = 50}},
    {"user clip planes", user_clip_planes, {.edge_ppm = 50}},
};

}  // namespace

std::span<const Feature> geometry_features() { return kFeatures; }

}  // namespace barrido::crosscheck
