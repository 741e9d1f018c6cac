#include "models/tool/teapot.h"

namespace barrido::models {
namespace {

/// Weights of the four control points of a cubic at i/n, and their first derivatives (Bernstein polynomials).
struct Weights {
  std::array<double, 4> value;
  std::array<double, 4> slope;
};

Weights weights_at(int i, int n) {
  const double t = static_cast<double>(i) / n;
  const double r = static_cast<double>(n - i) / n;  // Not 1 − t: so the curve read backwards is the same.
  return {{r * r * r, 3 * r * r * t, 3 * r * t * t, t * t * t},
          {-3 * r * r, 3 * r * r - 6 * r * t, 6 * r * t - 3 * t * t, 3 * t * t}};
}

/// The sum is bracketed so that reversing the order of the control points gives the same bits: patches that
/// share an edge then share its vertices exactly.
Vec3 blend(const std::array<Vec3, 4>& points, const std::array<double, 4>& weights) {
  return (points[0] * weights[0] + points[3] * weights[3]) +
         (points[1] * weights[1] + points[2] * weights[2]);
}

using Net = std::array<std::array<Vec3, 4>, 4>;  // [row][column]

/// Σ over rows and columns of row_weights[i]·column_weights[j]·P[i][j].
Vec3 blend(const Net& net, const std::array<double, 4>& row_weights,
           const std::array<double, 4>& column_weights) {
  std::array<Vec3, 4> curve;
  for (std::size_t row = 0; row < 4; ++row) curve[row] = blend(net[row], column_weights);
  return blend(curve, row_weights);
}

Net control_net(const PatchIndices& patch) {
  Net net;
  for (std::size_t i = 0; i < 16; ++i) {
    const ControlPoint& p = kTeapotControlPoints[patch[i]];
    net[i / 4][i % 4] = {p[0], p[2], -p[1]};  // From z up to y up: a quarter turn about x.
  }
  return net;
}

/// Outward normal from the partial derivatives, S_row × S_column in the order of the published rows. Where a
/// whole edge of the patch is one point (the knob's top, the middle of the bottom) S_column is zero there and
/// grows along the row direction as S_row,column does: the limit of the normal is S_row × S_row,column.
Vec3 normal_at(const Net& net, const Weights& row, const Weights& column) {
  const Vec3 along_row = blend(net, row.slope, column.value);
  const Vec3 normal = glm::cross(blend(net, row.value, column.slope), along_row);
  constexpr double kNoArea = 1e-9;
  if (length_of(normal) > kNoArea) return unit(normal);
  return unit(glm::cross(blend(net, row.slope, column.slope), along_row));
}

/// Rounded to what the file holds, so that points that are one there are one here: the corners of a pole.
Vec3 to_float(const Vec3& p) { return Vec3(glm::vec3(p)); }

}  // namespace

Mesh make_teapot(int cells) {
  Mesh mesh;
  for (const PatchIndices& patch : kTeapotPatches) {
    const Net net = control_net(patch);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int i = 0; i <= cells; ++i) {
      // Published rows run down the body and their points to the left, seen from outside: from the right,
      // then.
      for (int j = cells; j >= 0; --j) {
        const Weights row = weights_at(i, cells);
        const Weights column = weights_at(j, cells);
        mesh.positions.push_back(to_float(blend(net, row.value, column.value)));
        mesh.normals.push_back(normal_at(net, row, column));
        mesh.texcoords.emplace_back(static_cast<double>(cells - j) / cells, static_cast<double>(i) / cells);
      }
    }
    add_grid_triangles(mesh, first, cells, cells);
  }
  return mesh;
}

}  // namespace barrido::models
