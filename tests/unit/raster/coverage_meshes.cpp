#include "coverage_meshes.h"

#include <algorithm>
#include <utility>

#include "raster/base/portable_math.h"

namespace barrido::raster::testing {
namespace {

int between(std::mt19937_64& bits, int low, int high) {
  const auto span = static_cast<std::uint64_t>(static_cast<std::int64_t>(high) - low + 1);
  return static_cast<int>(low + static_cast<std::int64_t>(bits() % span));
}

/// Twice the signed area: positive when a, b, c turn counter-clockwise.
std::int64_t turn(GridPoint a, GridPoint b, GridPoint c) {
  return (static_cast<std::int64_t>(b.x) - a.x) * (static_cast<std::int64_t>(c.y) - a.y) -
         (static_cast<std::int64_t>(c.x) - a.x) * (static_cast<std::int64_t>(b.y) - a.y);
}

std::int64_t turn(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
  return turn(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
}

/// Puts the corners of folded triangles back until none is left.
void unfold(Mesh& mesh, const std::vector<GridPoint>& regular) {
  for (bool folded = true; folded;) {
    folded = false;
    for (const auto& triangle : mesh.triangles) {
      if (turn(mesh, triangle) >= 0) continue;
      folded = true;
      for (const std::uint32_t corner : triangle) mesh.points[corner] = regular[corner];
    }
  }
}

}  // namespace

Mesh jittered_grid(std::mt19937_64& bits, GridPoint origin, int columns, int rows, int cell, int jitter) {
  Mesh mesh;
  std::vector<GridPoint> regular;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      regular.push_back({origin.x + i * cell, origin.y + j * cell});
      const int dx = between(bits, -jitter, jitter);
      const int dy = between(bits, -jitter, jitter);
      mesh.points.push_back({regular.back().x + dx, regular.back().y + dy});
    }
  }
  const auto stride = static_cast<std::uint32_t>(columns) + 1;
  for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(rows); ++j) {
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(columns); ++i) {
      const std::uint32_t a = j * stride + i;
      const std::uint32_t b = a + 1;
      const std::uint32_t c = b + stride;
      const std::uint32_t d = a + stride;
      if (between(bits, 0, 1) == 0) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
      } else {
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({b, c, d});
      }
    }
  }
  unfold(mesh, regular);
  const auto at = [&](int i, int j) {
    return mesh.points[static_cast<std::size_t>(j) * stride + static_cast<std::size_t>(i)];
  };
  for (int i = 0; i < columns; ++i) mesh.outline.push_back(at(i, 0));
  for (int j = 0; j < rows; ++j) mesh.outline.push_back(at(columns, j));
  for (int i = columns; i > 0; --i) mesh.outline.push_back(at(i, rows));
  for (int j = rows; j > 0; --j) mesh.outline.push_back(at(0, j));
  return mesh;
}

Mesh sliver_fan(std::mt19937_64& bits, GridPoint hub, int count, int radius) {
  Mesh mesh;
  mesh.points.push_back(hub);
  for (int k = 0; k < count; ++k) {
    const double angle = 2.0 * kPi * k / count;
    const int r = between(bits, radius / 4, radius);
    const GridPoint next{hub.x + static_cast<int>(r * portable_cos(angle)),
                         hub.y + static_cast<int>(r * portable_sin(angle))};
    // Rounding to the grid may step back; such points are left out.
    if (mesh.outline.empty() || turn(hub, mesh.outline.back(), next) >= 0) {
      mesh.outline.push_back(next);
      mesh.points.push_back(next);
    }
  }
  while (turn(hub, mesh.outline.back(), mesh.outline.front()) < 0) {
    mesh.outline.pop_back();
    mesh.points.pop_back();
  }
  const auto ring = static_cast<std::uint32_t>(mesh.outline.size());
  for (std::uint32_t k = 0; k < ring; ++k) mesh.triangles.push_back({0, k + 1, (k + 1) % ring + 1});
  return mesh;
}

Mesh split_square(std::mt19937_64& bits, int reach, int points, int width, int height) {
  Mesh mesh;
  mesh.points = {{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}};
  mesh.outline = mesh.points;
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  for (int k = 0; k < points; ++k) {
    const bool near = k % 2 == 0;
    const int x = near ? between(bits, 0, width) : between(bits, -reach, reach);
    const int y = near ? between(bits, 0, height) : between(bits, -reach, reach);
    const GridPoint p{x, y};
    const auto holder = std::find_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
      return turn(mesh.points[t[0]], mesh.points[t[1]], p) > 0 &&
             turn(mesh.points[t[1]], mesh.points[t[2]], p) > 0 &&
             turn(mesh.points[t[2]], mesh.points[t[0]], p) > 0;
    });
    if (holder == mesh.triangles.end()) continue;  // on an edge: splitting one side would leave a T-junction
    const auto [a, b, c] = *holder;
    const auto index = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.push_back(p);
    *holder = {a, b, index};
    mesh.triangles.push_back({b, c, index});
    mesh.triangles.push_back({c, a, index});
  }
  return mesh;
}

std::vector<bool> inside_outline(const Mesh& mesh, int width, int height) {
  std::vector<bool> inside;
  inside.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  struct Edge {
    GridPoint low, high;
  };
  std::vector<Edge> edges;
  for (std::size_t k = 0; k < mesh.outline.size(); ++k) {
    const GridPoint a = mesh.outline[k];
    const GridPoint b = mesh.outline[(k + 1) % mesh.outline.size()];
    if (a.y != b.y) edges.push_back(a.y < b.y ? Edge{a, b} : Edge{b, a});
  }
  std::vector<Edge> crossing;
  for (int row = 0; row < height; ++row) {
    const std::int64_t y = std::int64_t{row} * 256 + 128;
    crossing.clear();
    for (const Edge& e : edges) {
      if (e.low.y <= y && y < e.high.y) crossing.push_back(e);
    }
    for (int column = 0; column < width; ++column) {
      const std::int64_t x = std::int64_t{column} * 256 + 128;
      const auto left_of_it = std::count_if(crossing.begin(), crossing.end(), [&](const Edge& e) {
        return (x - e.low.x) * (e.high.y - e.low.y) >= (y - e.low.y) * (e.high.x - e.low.x);
      });
      inside.push_back(left_of_it % 2 == 1);
    }
  }
  return inside;
}

}  // namespace barrido::raster::testing
