// Triangle meshes as the tool builds them, and the simple shapes: grids, spheres, tori, boxes. Object space,
// y up, counter-clockwise seen from outside. Must not know files.
#pragma once

#include <cstdint>
#include <vector>

#include "models/tool/vector.h"

namespace barrido::models {

/// Numbers of glTF's primitive modes.
enum class Mode : std::uint8_t { triangles = 4, triangle_strip = 5 };

/// Vertex arrays of one primitive; all but positions may be empty, else one element a vertex.
struct Mesh {
  Mode mode = Mode::triangles;
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;    ///< Unit length.
  std::vector<Vec2> texcoords;  ///< glTF's: t = 0 is the picture's top row.
  std::vector<Vec4> colors;     ///< Linear RGBA.
  std::vector<std::uint32_t> indices;
};

/// Appends the vertices and triangles of `part` (same mode and arrays) to `mesh`.
void append(Mesh& mesh, const Mesh& part);

/// Two triangles for every cell of a grid of (columns + 1) × (rows + 1) vertices, row-major from `first`,
/// whose rows run to the right and whose columns run down, seen from outside. A triangle with two equal
/// corners is left out.
void add_grid_triangles(Mesh& mesh, std::uint32_t first, int columns, int rows);

/// Parallelogram origin + s·right + t·down, s, t in [0, 1], in columns × rows cells. Its normal is
/// right × (−down); texture coordinates run from (0, 0) at the origin to `texcoord_scale`.
Mesh make_grid(const Vec3& origin, const Vec3& right, const Vec3& down, int columns, int rows,
               const Vec2& texcoord_scale = {1, 1});

/// Sphere about the origin, latitude and longitude; s runs east, t from the north pole (+Y) to the south.
Mesh make_sphere(double radius, int slices, int stacks);

/// Torus about the y axis: `ring` from the centre to the tube's middle, `tube` its radius.
Mesh make_torus(double ring, double tube, int slices, int sides, const Vec2& texcoord_scale);

/// Box standing on y = 0 with its base's centre at `centre`, turned so that its x axis is `axis_x` (unit,
/// horizontal). `size` is width, height, depth. The bottom is left out.
Mesh make_standing_box(const Vec3& centre, const Vec3& axis_x, const Vec3& size);

}  // namespace barrido::models
