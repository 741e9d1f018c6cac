// Meshes of the generated scenes.
#include <cmath>

#include "pipeline/matrix.h"
#include "raster/base/portable_math.h"
#include "tests/osmesa/parts.h"

namespace barrido::crosscheck {
namespace {

using pipeline::PrimitiveMode;

glm::vec3 in_box(RandomBits& random, float half) {
  const float x = random.number(-half, half);
  const float y = random.number(-half, half);
  return {x, y, random.number(-half, half)};
}

glm::vec3 unit(const glm::dvec3& v) {
  const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  return length > 0.0 ? glm::vec3(v / length) : glm::vec3(0, 0, 1);
}

void add_vertex(RandomBits& random, Mesh& mesh, const glm::vec3& p, const glm::vec3& n, const glm::vec2& uv) {
  mesh.position.emplace_back(p, 1.0f);
  mesh.normal.push_back(n);
  mesh.color.push_back(random_color(random));
  mesh.texcoord[0].emplace_back(uv, 0.0f, 1.0f);
  mesh.texcoord[1].emplace_back(uv.y * 1.5f + 0.25f, uv.x - uv.y, 0.0f, 1.0f);
}

}  // namespace

Mesh soup(RandomBits& random, int triangles, float spread) {
  Mesh mesh;
  for (int i = 0; i < triangles; ++i) {
    const glm::vec3 middle = in_box(random, 1.0f);
    for (int corner = 0; corner < 3; ++corner) {
      const glm::vec3 p = middle + in_box(random, spread);
      add_vertex(random, mesh, p, unit(in_box(random, 1.0f)), {p.x + p.z, p.y});
    }
  }
  return mesh;
}

Mesh bent_plane(RandomBits& random, int cells, float bump, float texture_scale) {
  Mesh mesh;
  const float du = random.number(-1.0f, 1.0f);
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const float x = 2.0f * static_cast<float>(i) / static_cast<float>(cells) - 1.0f;
      const float y = 2.0f * static_cast<float>(j) / static_cast<float>(cells) - 1.0f;
      const glm::vec3 p{x, y, bump * (x * x - y * x + random.number(-0.2f, 0.2f))};
      const glm::vec3 n = unit(glm::dvec3(-bump * (2 * x - y), bump * x, 1));
      add_vertex(random, mesh, p, n,
                 {texture_scale * (0.5f * x + 0.5f) + du, texture_scale * (0.5f * y + 0.5f)});
    }
  }
  const auto at = [cells](int i, int j) { return static_cast<std::uint32_t>(j * (cells + 1) + i); };
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      for (const std::uint32_t v :
           {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)})
        mesh.indices.push_back(v);
    }
  }
  return mesh;
}

Mesh sphere(RandomBits& random, int slices) {
  Mesh mesh;
  const int stacks = slices / 2;
  for (int j = 0; j <= stacks; ++j) {
    for (int i = 0; i <= slices; ++i) {
      const double v = static_cast<double>(j) / stacks;
      const double u = static_cast<double>(i) / slices;
      const double ring = portable_sin(kPi * v);
      const glm::vec3 p(glm::dvec3(ring * portable_cos(2 * kPi * u), -portable_cos(kPi * v),
                                   -ring * portable_sin(2 * kPi * u)));
      add_vertex(random, mesh, p, p, {static_cast<float>(u), static_cast<float>(v)});
    }
  }
  const auto at = [slices](int i, int j) { return static_cast<std::uint32_t>(j * (slices + 1) + i); };
  for (int j = 0; j < stacks; ++j) {
    for (int i = 0; i < slices; ++i) {
      if (j > 0)
        for (const std::uint32_t v : {at(i, j), at(i + 1, j), at(i + 1, j + 1)}) mesh.indices.push_back(v);
      if (j + 1 < stacks)
        for (const std::uint32_t v : {at(i, j), at(i + 1, j + 1), at(i, j + 1)}) mesh.indices.push_back(v);
    }
  }
  return mesh;
}

void add_tangents(RandomBits& random, Mesh& mesh, bool with_bitangents) {
  const float sign = random.chance(50) ? 1.0f : -1.0f;
  for (const glm::vec3& n : mesh.normal) {
    // Across the normal, roughly along x.
    const glm::dvec3 along =
        glm::dvec3(1.0, 0.1, 0.2) - glm::dvec3(n) * static_cast<double>(n.x + 0.1f * n.y + 0.2f * n.z);
    const glm::vec3 t = unit(along);
    const glm::vec3 b{n.y * t.z - n.z * t.y, n.z * t.x - n.x * t.z, n.x * t.y - n.y * t.x};
    const float u = with_bitangents ? random.number(0.5f, 2.0f) : 1.0f;
    mesh.tangent.emplace_back(t * u, sign);
    if (with_bitangents) mesh.bitangent.push_back(b * sign * random.number(0.5f, 2.0f));
  }
}

Mesh in_mode(RandomBits& random, PrimitiveMode mode) {
  Mesh mesh;
  mesh.mode = mode;
  const bool ring = mode == PrimitiveMode::triangle_fan || mode == PrimitiveMode::polygon;
  const int count = random.between(3, 11);
  const glm::vec3 n{0, 0, 1};
  if (ring) {  // convex, counter-clockwise
    for (int i = 0; i < count; ++i) {
      const double a = 2 * kPi * (i + 0.6 * random.number(0, 1)) / count;
      const glm::vec3 p(glm::dvec3(portable_cos(a), portable_sin(a), 0.0));
      add_vertex(random, mesh, p, n, glm::vec2(p));
    }
  } else if (mode == PrimitiveMode::triangle_strip || mode == PrimitiveMode::quad_strip) {
    for (int i = 0; i < count; ++i) {
      const float y = i % 2 == 0 ? -random.number(0.3f, 1) : random.number(0.3f, 1);
      const glm::vec3 p{2.0f * static_cast<float>(i / 2) / 5.0f - 1.0f + (i % 2 == 0 ? 0.0f : 0.1f), y, 0};
      add_vertex(random, mesh, p, n, glm::vec2(p));
    }
  } else {
    const int corners = mode == PrimitiveMode::quads ? 4 : 3;
    for (int i = 0; i < count / 2 * corners + count % 2; ++i) {
      const double a = 2 * kPi * (i % corners + 0.6 * random.number(0, 1)) / corners;
      const float x = static_cast<float>(i / corners) * 0.4f - 0.8f;
      const glm::vec3 p(glm::dvec3(x + 0.5 * portable_cos(a), 0.7 * portable_sin(a), 0.13 * (i / corners)));
      add_vertex(random, mesh, p, n, glm::vec2(p));
    }
  }
  if (mode ==
      PrimitiveMode::quads) {  // OpenGL does not say along which diagonal they are cut: colours of a plane
    const glm::vec4 across = random_color(random, -0.3f, 0.3f);
    const glm::vec4 up = random_color(random, -0.2f, 0.2f);
    for (std::size_t i = 0; i < mesh.position.size(); ++i) {
      mesh.color[i] = glm::vec4(0.5f) + mesh.position[i].x * across + mesh.position[i].y * up;
    }
  }
  if (random.chance(50)) {  // the same through indices
    for (std::size_t i = 0; i < mesh.position.size(); ++i)
      mesh.indices.push_back(static_cast<std::uint32_t>(i));
  }
  return mesh;
}

Mesh scattered(RandomBits& random, PrimitiveMode mode, int elements) {
  Mesh mesh;
  mesh.mode = mode;
  for (int i = 0; i < elements; ++i) {
    const glm::vec3 p = in_box(random, 1.3f);
    add_vertex(random, mesh, p, unit(in_box(random, 1.0f)), {p.x, p.y});
  }
  return mesh;
}

glm::mat4 translation(float x, float y, float z) {
  glm::mat4 m(1.0f);
  m[3] = {x, y, z, 1.0f};
  return m;
}

glm::mat4 random_rotation(RandomBits& random) {
  const double angle = random.number(0, 6.2f);
  return pipeline::rotation(angle, glm::dvec3(in_box(random, 1.0f)));
}

glm::mat4 random_placement(RandomBits& random) {
  const float x = random.number(-0.5f, 0.5f);
  const float y = random.number(-0.5f, 0.5f);
  const glm::mat4 place = translation(x, y, random.number(-5.0f, -3.0f));
  return pipeline::product(place, random_rotation(random));
}

DrawCall perspective_draw(RandomBits& random, const ScenePair& pair) {
  DrawCall draw;
  draw.state.eye_from_object = random_placement(random);
  draw.state.clip_from_eye = pipeline::perspective(random.number(0.5f, 1.0f),
                                                   static_cast<double>(pair.width) / pair.height, 1.0, 20.0);
  draw.state.depth.test = true;
  return draw;
}

DrawCall affine_draw(RandomBits& random, const ScenePair& pair) {
  DrawCall draw;
  const double half = random.number(0.9f, 1.8f);
  const double aspect = static_cast<double>(pair.width) / pair.height;
  draw.state.eye_from_object = random_placement(random);
  draw.state.clip_from_eye = pipeline::orthographic(-half * aspect, half * aspect, -half, half, 1.0, 9.0);
  draw.state.depth.test = true;
  return draw;
}

DrawCall any_draw(RandomBits& random, const ScenePair& pair) {
  return random.chance(70) ? perspective_draw(random, pair) : affine_draw(random, pair);
}

glm::vec4 random_color(RandomBits& random, float low, float high) {
  const auto c = random.color(low, high);
  return {c[0], c[1], c[2], c[3]};
}

}  // namespace barrido::crosscheck
