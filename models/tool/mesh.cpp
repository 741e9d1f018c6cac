#include "models/tool/mesh.h"

#include "raster/base/portable_math.h"

namespace barrido::models {
namespace {

/// Cosine and sine of i/n of a full turn; exact where i/n is a multiple of a quarter, so that seams close.
Vec2 on_circle(int i, int n) {
  if (i * 4 % n == 0) {
    constexpr Vec2 kQuarters[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    return kQuarters[(i * 4 / n) % 4];
  }
  const double angle = 2.0 * kPi * i / n;
  return {portable_cos(angle), portable_sin(angle)};
}

}  // namespace

void add_grid_triangles(Mesh& mesh, std::uint32_t first, int columns, int rows) {
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto& p = mesh.positions;
    if (p[a] == p[b] || p[b] == p[c] || p[c] == p[a]) return;
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
  };
  const auto stride = static_cast<std::uint32_t>(columns) + 1;
  for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(rows); ++row) {
    for (std::uint32_t column = 0; column + 1 < stride; ++column) {
      const std::uint32_t top_left = first + row * stride + column;
      const std::uint32_t bottom_left = top_left + stride;
      add(top_left, bottom_left, bottom_left + 1);
      add(top_left, bottom_left + 1, top_left + 1);
    }
  }
}

void append(Mesh& mesh, const Mesh& part) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.mode = part.mode;
  mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
  mesh.normals.insert(mesh.normals.end(), part.normals.begin(), part.normals.end());
  mesh.texcoords.insert(mesh.texcoords.end(), part.texcoords.begin(), part.texcoords.end());
  mesh.colors.insert(mesh.colors.end(), part.colors.begin(), part.colors.end());
  for (const std::uint32_t index : part.indices) mesh.indices.push_back(first + index);
}

Mesh make_grid(const Vec3& origin, const Vec3& right, const Vec3& down, int columns, int rows,
               const Vec2& texcoord_scale) {
  Mesh mesh;
  const Vec3 normal = unit(glm::cross(down, right));
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      const double s = static_cast<double>(column) / columns;
      const double t = static_cast<double>(row) / rows;
      mesh.positions.push_back(origin + right * s + down * t);
      mesh.normals.push_back(normal);
      mesh.texcoords.emplace_back(s * texcoord_scale.x, t * texcoord_scale.y);
    }
  }
  add_grid_triangles(mesh, 0, columns, rows);
  return mesh;
}

Mesh make_sphere(double radius, int slices, int stacks) {
  Mesh mesh;
  for (int stack = 0; stack <= stacks; ++stack) {
    const Vec2 polar = on_circle(stack, 2 * stacks);
    for (int slice = 0; slice <= slices; ++slice) {
      // Seen from outside with +Y up, east is to the right: x = sin, z = cos of the longitude.
      const Vec2 around = on_circle(slice, slices);
      const Vec3 normal{around.y * polar.y, polar.x, around.x * polar.y};
      mesh.positions.push_back(normal * radius);
      mesh.normals.push_back(normal);
      mesh.texcoords.emplace_back(static_cast<double>(slice) / slices, static_cast<double>(stack) / stacks);
    }
  }
  add_grid_triangles(mesh, 0, slices, stacks);
  return mesh;
}

Mesh make_torus(double ring, double tube, int slices, int sides, const Vec2& texcoord_scale) {
  Mesh mesh;
  for (int side = 0; side <= sides; ++side) {
    // From the inner edge over the top to the outer edge and back below, which is "down" seen from outside.
    const Vec2 profile = on_circle(side, sides);
    for (int slice = 0; slice <= slices; ++slice) {
      const Vec2 around = on_circle(slice, slices);
      const Vec3 normal{-profile.x * around.y, profile.y, -profile.x * around.x};
      const double distance = ring - profile.x * tube;
      mesh.positions.emplace_back(distance * around.y, profile.y * tube, distance * around.x);
      mesh.normals.push_back(normal);
      mesh.texcoords.emplace_back(texcoord_scale.x * slice / slices, texcoord_scale.y * side / sides);
    }
  }
  add_grid_triangles(mesh, 0, slices, sides);
  return mesh;
}

Mesh make_standing_box(const Vec3& centre, const Vec3& axis_x, const Vec3& size) {
  const Vec3 axis_z{-axis_x.z, 0, axis_x.x};
  const Vec3 x = axis_x * size.x;
  const Vec3 y{0, size.y, 0};
  const Vec3 z = axis_z * size.z;
  const Vec3 corner = centre - x * 0.5 - z * 0.5;  // The one at −x, −z, on the floor.
  constexpr int kCells = 4;
  Mesh mesh = make_grid(corner + y, x, z, kCells, kCells);              // top
  append(mesh, make_grid(corner + y + z, x, -y, kCells, kCells));       // +z
  append(mesh, make_grid(corner + y + x, -x, -y, kCells, kCells));      // −z
  append(mesh, make_grid(corner + y + x + z, -z, -y, kCells, kCells));  // +x
  append(mesh, make_grid(corner + y, z, -y, kCells, kCells));           // −x
  return mesh;
}

}  // namespace barrido::models
