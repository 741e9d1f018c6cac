// The shapes that the golden scenes are made of.
#include "raster/base/portable_math.h"
#include "tests/golden/stage.h"

namespace barrido::golden {
namespace {

void add_vertex(Shape& shape, const glm::vec3& p, const glm::vec3& n, float s, float t) {
  shape.position.emplace_back(p, 1.0f);
  shape.normal.push_back(n);
  shape.texcoord.emplace_back(s, t, 0.0f, 1.0f);
}

/// Triangles of a grid whose rows of vertices run to the right and upwards, seen from the front.
void add_cells(Shape& shape, int columns, int rows) {
  const auto at = [columns](int i, int j) { return static_cast<std::uint32_t>(j * (columns + 1) + i); };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      for (const std::uint32_t index : {at(i, j), at(i + 1, j), at(i + 1, j + 1)})
        shape.indices.push_back(index);
      for (const std::uint32_t index : {at(i, j), at(i + 1, j + 1), at(i, j + 1)})
        shape.indices.push_back(index);
    }
  }
}

}  // namespace

Shape rectangle(float x0, float y0, float x1, float y1, float z, float repeat) {
  Shape shape;
  add_vertex(shape, {x0, y0, z}, {0, 0, 1}, 0, 0);
  add_vertex(shape, {x1, y0, z}, {0, 0, 1}, repeat, 0);
  add_vertex(shape, {x0, y1, z}, {0, 0, 1}, 0, repeat);
  add_vertex(shape, {x1, y1, z}, {0, 0, 1}, repeat, repeat);
  add_cells(shape, 1, 1);
  return shape;
}

Shape plane(int cells, float repeat) {
  Shape shape;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const float s = static_cast<float>(i) / static_cast<float>(cells);
      const float t = static_cast<float>(j) / static_cast<float>(cells);
      add_vertex(shape, {2 * s - 1, 2 * t - 1, 0}, {0, 0, 1}, s * repeat, t * repeat);
    }
  }
  add_cells(shape, cells, cells);
  return shape;
}

Shape ground(float depth, float repeat) {
  Shape shape;
  const float half = 0.5f * depth;
  for (const float z : {1.0f, -depth}) {
    for (const float x : {-half, half}) {
      add_vertex(shape, {x, -1, z}, {0, 1, 0}, (x / depth + 0.5f) * repeat, (1 - z) / depth * repeat);
    }
  }
  add_cells(shape, 1, 1);
  return shape;
}

Shape sphere(int slices, int stacks) {
  Shape shape;
  for (int j = 0; j <= stacks; ++j) {
    const double latitude = kPi * (static_cast<double>(j) / stacks - 0.5);
    for (int i = 0; i <= slices; ++i) {
      const double longitude = 2 * kPi * i / slices;
      const double ring = portable_cos(latitude);
      const glm::vec3 p(
          glm::dvec3(ring * portable_sin(longitude), portable_sin(latitude), ring * portable_cos(longitude)));
      add_vertex(shape, p, p, static_cast<float>(i) / static_cast<float>(slices),
                 static_cast<float>(j) / static_cast<float>(stacks));
    }
  }
  add_cells(shape, slices, stacks);
  return shape;
}

Shape open_box() {
  constexpr glm::vec3 kAxes[5][2] = {{{0, 0, -1}, {0, 1, 0}},   // +X: to the right, up
                                     {{0, 0, 1}, {0, 1, 0}},    // −X
                                     {{1, 0, 0}, {0, 0, -1}},   // +Y
                                     {{1, 0, 0}, {0, 0, 1}},    // −Y
                                     {{-1, 0, 0}, {0, 1, 0}}};  // −Z
  constexpr glm::vec4 kColors[5] = {{0.9f, 0.3f, 0.2f, 1},
                                    {0.2f, 0.7f, 0.8f, 1},
                                    {0.4f, 0.8f, 0.3f, 1},
                                    {0.7f, 0.3f, 0.7f, 1},
                                    {0.9f, 0.8f, 0.3f, 1}};
  Shape shape;
  shape.mode = PrimitiveMode::quads;
  for (std::size_t face = 0; face < 5; ++face) {
    const glm::vec3& r = kAxes[face][0];
    const glm::vec3& u = kAxes[face][1];
    const glm::vec3 n{r.y * u.z - r.z * u.y, r.z * u.x - r.x * u.z, r.x * u.y - r.y * u.x};
    for (const auto& [s, t] : {std::pair{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}}) {
      add_vertex(shape, n + r * (2 * s - 1) + u * (2 * t - 1), n, s, t);
      shape.color.push_back(kColors[face]);
    }
  }
  return shape;
}

Shape triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec4& color) {
  Shape shape;
  for (const glm::vec3& p : {a, b, c}) add_vertex(shape, p, {0, 0, 1}, p.x, p.y);
  return with_color(std::move(shape), color);
}

Shape with_color(Shape shape, const glm::vec4& color) {
  shape.color.assign(shape.position.size(), color);
  return shape;
}

}  // namespace barrido::golden
