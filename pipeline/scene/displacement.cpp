#include "pipeline/scene/displacement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "pipeline/scene/displacement_heights.h"
#include "pipeline/scene/subdivision.h"
#include "pipeline/scene/triangles.h"
#include "pipeline/scene/weld.h"

namespace barrido::scene {
namespace {

/// More would be finer than pixels, whatever the picture.
constexpr std::uint64_t kMostAutomaticTriangles = std::uint64_t{1} << 20;
/// Indices have 32 bits.
constexpr std::uint64_t kMostVertices = std::uint64_t{1} << 31;

std::vector<float> packed(const pipeline::Attribute& attribute, std::uint32_t count) {
  std::vector<float> values;
  values.reserve(std::size_t{3} * count);
  for (std::uint32_t v = 0; v < count; ++v) {
    const float* element = attribute.data + static_cast<std::size_t>(attribute.stride) * v;
    values.insert(values.end(), element, element + 3);
  }
  return values;
}

void append(std::vector<float>& values, const glm::dvec3& v) {
  values.insert(values.end(), {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
}

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
  const double length = std::sqrt(glm::dot(v, v));
  return length > 0.0 && std::isfinite(length) ? v / length : glm::dvec3(0.0);
}

std::vector<std::uint32_t> triangles_of(const PreparedGeometry& geometry) {
  return triangle_list(geometry.geometry.mode, geometry.geometry.indices, geometry.geometry.vertex_count);
}

/// The surface as it was, as the fine vertices need it.
struct Source {
  const PreparedGeometry& geometry;
  std::vector<std::uint32_t> triangles;
  Welded positions;                   ///< Classes of vertices: at one place,
  Welded corners;                     ///< and of one normal there.
  std::vector<glm::dvec3> direction;  ///< Of each place: the mean of its different normals.
  std::vector<glm::dvec3> place;

  explicit Source(const PreparedGeometry& prepared) : geometry(prepared), triangles(triangles_of(prepared)) {
    const std::uint32_t count = prepared.geometry.vertex_count;
    const std::vector<float> position = packed(prepared.geometry.position, count);
    const std::vector<float> normal = packed(prepared.geometry.normal, count);
    positions = weld(position, 3);
    std::vector<float> both;
    both.reserve(6 * std::size_t{count});
    for (std::size_t v = 0; v < 3 * std::size_t{count}; v += 3) {
      both.insert(both.end(), position.begin() + static_cast<std::ptrdiff_t>(v),
                  position.begin() + static_cast<std::ptrdiff_t>(v) + 3);
      both.insert(both.end(), normal.begin() + static_cast<std::ptrdiff_t>(v),
                  normal.begin() + static_cast<std::ptrdiff_t>(v) + 3);
    }
    corners = weld(both, 6);
    direction.resize(positions.count, glm::dvec3(0.0));
    place.resize(positions.count, glm::dvec3(0.0));
    std::vector<bool> seen(corners.count, false);
    for (std::uint32_t v = 0; v < count; ++v) {
      place[positions.number[v]] = vector3(prepared.geometry.position, v);
      if (seen[corners.number[v]]) continue;
      seen[corners.number[v]] = true;
      direction[positions.number[v]] += unit_or_zero(vector3(prepared.geometry.normal, v));
    }
    for (glm::dvec3& d : direction) d = unit_or_zero(d);
  }

  std::vector<std::uint32_t> class_of_corners(const Welded& welded) const {
    std::vector<std::uint32_t> classes(triangles.size());
    for (std::size_t c = 0; c < triangles.size(); ++c) classes[c] = welded.number[triangles[c]];
    return classes;
  }
};

/// The mean of three values by a grid point's parts, the first of `order` first: two triangles that share an
/// edge add the same numbers in the same order.
template <class Value, class ValueOf>
Value blended(const GridPoint& point, const std::array<int, 3>& order, double pieces, ValueOf value) {
  Value sum(0.0);
  for (const int k : order) {
    if (point.weight[k] != 0) sum += value(k) * static_cast<double>(point.weight[k]);
  }
  return sum / pieces;
}

/// A fine point of the surface: where it was, where it goes, how far.
struct MovingPoint {
  glm::dvec3 place{0.0};
  glm::dvec3 direction{0.0};
  double heights = 0.0;
  std::uint32_t count = 0;
};

class Displacing {
 public:
  Displacing(PreparedGeometry& geometry, const HeightMap& heights, int pieces)
      : out_(geometry),
        heights_(heights),
        source_(geometry),
        grid_(pieces),
        place_classes_(source_.class_of_corners(source_.positions)),
        corner_classes_(source_.class_of_corners(source_.corners)),
        places_(place_classes_, source_.positions.count, pieces),
        normals_(corner_classes_, source_.corners.count, pieces) {}

  void run() {
    gather_points();
    move_points();
    make_vertices();
    make_normals();
    replace();
  }

 private:
  std::size_t triangle_count() const { return source_.triangles.size() / 3; }
  std::uint32_t corner(std::size_t t, int k) const {
    return source_.triangles[3 * t + static_cast<std::size_t>(k)];
  }

  /// Every vertex of the grids, triangle by triangle.
  template <class Visit>
  void for_each_vertex(Visit visit) const {
    for (std::size_t t = 0; t < triangle_count(); ++t) {
      for (const GridPoint& point : grid_.points) visit(t, point);
    }
  }

  void gather_points() {
    points_.resize(places_.count());
    const double pieces = grid_.pieces;
    std::optional<PictureHeights> picture;
    std::optional<SolidHeights> solid;
    if (heights_.picture != nullptr) {
      picture.emplace(heights_, mean_edge_texels(out_, heights_, source_.triangles) / pieces);
    } else if (heights_.solid) {
      solid.emplace(out_, *heights_.solid);
      solid->set_distance(mean_edge_length(out_, source_.triangles) / pieces);
    }
    const auto height_at = [&](std::size_t t, const GridPoint& point) {
      if (picture) {
        return picture->at(blended<glm::dvec2>(point, {0, 1, 2}, pieces, [&](int k) {
          return glm::dvec2(place_on_heights(out_, heights_, corner(t, k)));
        }));
      }
      if (!solid) return 1.0;
      return solid->at(blended<glm::dvec3>(point, {0, 1, 2}, pieces,
                                           [&](int k) { return vector3(out_.rest, corner(t, k)); }));
    };
    for_each_vertex([&](std::size_t t, const GridPoint& grid_point) {
      const std::uint32_t* place = place_classes_.data() + 3 * t;
      std::array<int, 3> order{0, 1, 2};
      std::sort(order.begin(), order.end(), [&](int a, int b) { return place[a] < place[b]; });
      MovingPoint& point = points_[places_.number(t, grid_point)];
      point.place =
          blended<glm::dvec3>(grid_point, order, pieces, [&](int k) { return source_.place[place[k]]; });
      point.direction =
          blended<glm::dvec3>(grid_point, order, pieces, [&](int k) { return source_.direction[place[k]]; });
      point.heights += height_at(t, grid_point);
      ++point.count;
    });
  }

  void move_points() {
    moved_.reserve(3 * points_.size());
    amount_.reserve(points_.size());
    for (const MovingPoint& point : points_) {
      const double height = point.count > 0 ? point.heights / point.count : 0.0;
      const double amount = double{heights_.by.bias} + double{heights_.by.scale} * height;
      const glm::dvec3 place = point.place + unit_or_zero(point.direction) * amount;
      append(moved_, place);
      amount_.push_back(static_cast<float>(amount));
    }
  }

  glm::dvec3 moved(std::uint32_t point) const {
    const float* p = moved_.data() + std::size_t{3} * point;
    return {p[0], p[1], p[2]};
  }

  void make_vertices() {
    const double pieces = grid_.pieces;
    const auto blend = [&](const pipeline::Attribute& from, int components, std::vector<float>& to,
                           std::size_t t, const GridPoint& point) {
      if (from.data == nullptr) return;
      for (int c = 0; c < components; ++c) {
        const double value = blended<double>(point, {0, 1, 2}, pieces, [&](int k) {
          return double{
              from.data[static_cast<std::size_t>(from.stride) * corner(t, k) + static_cast<std::size_t>(c)]};
        });
        to.push_back(static_cast<float>(value));
      }
    };
    for_each_vertex([&](std::size_t t, const GridPoint& point) {
      const std::uint32_t number = places_.number(t, point);
      vertex_normal_.push_back(normals_.number(t, point));
      positions_.insert(positions_.end(), moved_.begin() + std::ptrdiff_t{3} * number,
                        moved_.begin() + std::ptrdiff_t{3} * number + 3);
      vertex_amount_.push_back(amount_[number]);
      for (std::size_t set = 0; set < 2; ++set) blend(out_.texcoord_sets[set], 2, texcoords_[set], t, point);
      blend(out_.colors, 4, colors_, t, point);
      blend(out_.rest, 3, rest_, t, point);
    });
    const auto per_triangle = static_cast<std::uint32_t>(grid_.points.size());
    indices_.reserve(triangle_count() * grid_.triangles.size() * 3);
    for (std::size_t t = 0; t < triangle_count(); ++t) {
      const auto first = static_cast<std::uint32_t>(t) * per_triangle;
      for (const auto& [a, b, c] : grid_.triangles) {
        indices_.insert(indices_.end(), {first + a, first + b, first + c});
      }
    }
  }

  /// −1 where a triangle's normals look to the side from which it seems wound clockwise.
  double side_of(std::size_t t) const {
    const auto position = [&](int k) { return vector3(out_.geometry.position, corner(t, k)); };
    const auto normal = [&](int k) { return vector3(out_.geometry.normal, corner(t, k)); };
    const glm::dvec3 area = glm::cross(position(1) - position(0), position(2) - position(0));
    return glm::dot(area, normal(0) + normal(1) + normal(2)) < 0.0 ? -1.0 : 1.0;
  }

  /// The sum, by area, of the normals of the moved triangles around each corner's side of the surface.
  void make_normals() {
    std::vector<glm::dvec3> sums(normals_.count(), glm::dvec3(0.0));
    const std::size_t fine = grid_.triangles.size() * 3;
    for (std::size_t i = 0; i < indices_.size(); i += 3) {
      glm::dvec3 p[3];
      for (std::size_t k = 0; k < 3; ++k) {
        const float* v = positions_.data() + std::size_t{3} * indices_[i + k];
        p[k] = {v[0], v[1], v[2]};
      }
      const glm::dvec3 area = glm::cross(p[1] - p[0], p[2] - p[0]) * side_of(i / fine);
      if (!std::isfinite(glm::dot(area, area))) continue;
      for (std::size_t k = 0; k < 3; ++k) sums[vertex_normal_[indices_[i + k]]] += area;
    }
    const double pieces = grid_.pieces;
    std::size_t vertex = 0;
    for_each_vertex([&](std::size_t t, const GridPoint& point) {
      glm::dvec3 normal = unit_or_zero(sums[vertex_normal_[vertex++]]);
      if (normal == glm::dvec3(0.0)) {
        normal = unit_or_zero(blended<glm::dvec3>(
            point, {0, 1, 2}, pieces, [&](int k) { return vector3(out_.geometry.normal, corner(t, k)); }));
      }
      append(new_normals_, normal);
    });
  }

  void replace() {
    out_.displaced = {grid_.pieces, indices_.size() / 3, std::move(vertex_amount_)};
    out_.positions = std::move(positions_);
    out_.normals = std::move(new_normals_);
    out_.indices = std::move(indices_);
    out_.geometry.mode = pipeline::PrimitiveMode::triangles;
    out_.geometry.vertex_count = static_cast<std::uint32_t>(out_.positions.size() / 3);
    out_.geometry.position = {out_.positions.data(), 3, 3};
    out_.geometry.normal = {out_.normals.data(), 3, 3};
    out_.geometry.indices = out_.indices;
    out_.geometry.tangent = out_.geometry.bitangent = {};  // Made anew where they are wanted.
    if (out_.colors.data != nullptr) {
      out_.own_colors = std::move(colors_);
      out_.colors = {out_.own_colors.data(), 4, 4};
    }
    for (std::size_t set = 0; set < 2; ++set) {
      if (out_.texcoord_sets[set].data == nullptr) continue;
      out_.texcoords[set] = std::move(texcoords_[set]);
      out_.texcoord_sets[set] = {out_.texcoords[set].data(), 2, 2};
    }
    // Solid textures stick to the surface as it was.
    out_.rest_positions = std::move(rest_);
    out_.rest = {out_.rest_positions.data(), 3, 3};
    out_.center = middle_of(out_.positions);
  }

  static glm::vec3 middle_of(const std::vector<float>& positions) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    glm::vec3 low(kInfinity), high(-kInfinity);
    for (std::size_t i = 0; i < positions.size(); i += 3) {
      const glm::vec3 p(positions[i], positions[i + 1], positions[i + 2]);
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    return low.x <= high.x ? low * 0.5f + high * 0.5f : glm::vec3(0.0f);
  }

  PreparedGeometry& out_;
  const HeightMap& heights_;
  Source source_;
  TriangleGrid grid_;
  std::vector<std::uint32_t> place_classes_, corner_classes_;
  FinePoints places_;   ///< One a place of the fine surface: these move.
  FinePoints normals_;  ///< One a place and side of it: these have normals.
  std::vector<MovingPoint> points_;
  std::vector<float> moved_, amount_;  ///< Of each of them
  std::vector<std::uint32_t> vertex_normal_;
  std::vector<float> positions_, new_normals_, colors_, rest_, vertex_amount_;
  std::array<std::vector<float>, 2> texcoords_;
  std::vector<std::uint32_t> indices_;
};

std::uint64_t triangle_count(const PreparedGeometry& geometry) { return triangles_of(geometry).size() / 3; }

}  // namespace

bool can_displace(const PreparedGeometry& geometry, const HeightMap& heights) {
  if (!is_surface(geometry.geometry.mode) || geometry.geometry.normal.data == nullptr) return false;
  return heights.picture == nullptr ||
         geometry.texcoord_sets[static_cast<std::size_t>(heights.texcoord_set)].data != nullptr;
}

int displacement_pieces(const PreparedGeometry& geometry, const HeightMap& heights, std::uint64_t memory) {
  if (heights.by.pieces > 0) return heights.by.pieces;
  if (heights.picture == nullptr && !heights.solid) return 1;
  const std::vector<std::uint32_t> triangles = triangles_of(geometry);
  constexpr double kPointsACell = 8.0;
  const double wanted =
      std::ceil(heights.picture != nullptr ? mean_edge_texels(geometry, heights, triangles)
                                           : mean_edge_length(geometry, triangles) * kPointsACell *
                                                 SolidHeights(geometry, *heights.solid).cells_a_unit());
  int pieces = static_cast<int>(std::clamp(wanted, 1.0, double{kMaxDisplacedPieces}));
  const auto fits = [&](int n) {
    const auto squared = static_cast<std::uint64_t>(n) * static_cast<std::uint64_t>(n);
    return triangles.size() / 3 * squared <= kMostAutomaticTriangles &&
           displacement_bytes(geometry, n) <= memory;
  };
  while (pieces > 1 && !fits(pieces)) --pieces;
  return pieces;
}

std::uint64_t displacement_bytes(const PreparedGeometry& geometry, int pieces) {
  const auto n = static_cast<std::uint64_t>(pieces);
  const std::uint64_t vertices = (n + 1) * (n + 2) / 2;
  // Of points (there are no more than vertices): where they were and go, sums of normals.
  constexpr std::uint64_t kPointBytes = sizeof(MovingPoint) + 16 + sizeof(glm::dvec3);
  // Vectors grow to at most twice what they hold: position, normal, amount, two sets, a colour, a place at
  // rest, a number.
  constexpr std::uint64_t kVertexBytes = 2 * (12 + 12 + 4 + 16 + 16 + 12 + 4);
  constexpr std::uint64_t kTriangleBytes = 12;
  const std::uint64_t triangles = triangle_count(geometry);
  if (triangles * vertices > kMostVertices) return std::numeric_limits<std::uint64_t>::max();
  return triangles * (vertices * (kPointBytes + kVertexBytes) + n * n * kTriangleBytes);
}

void displace(PreparedGeometry& geometry, const HeightMap& heights, int pieces) {
  Displacing(geometry, heights, pieces).run();
}

}  // namespace barrido::scene
