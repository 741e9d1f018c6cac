#include "pipeline/scene/normals.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "pipeline/scene/weld.h"
#include "raster/base/portable_math.h"

namespace barrido::scene {
namespace {

glm::dvec3 position_of(std::span<const float> positions, std::uint32_t vertex) {
  const float* p = positions.data() + std::size_t{3} * vertex;
  return {p[0], p[1], p[2]};
}

/// In double, so that neither tiny nor huge models leave the range of the numbers.
struct Face {
  glm::dvec3 area{0.0};  ///< Normal times twice the area
  glm::dvec3 unit{0.0};  ///< Zero when there is no area
};

std::vector<Face> faces_of(std::span<const float> positions, std::span<const std::uint32_t> triangles) {
  std::vector<Face> faces(triangles.size() / 3);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const glm::dvec3 a = position_of(positions, triangles[3 * f]);
    const glm::dvec3 b = position_of(positions, triangles[3 * f + 1]);
    const glm::dvec3 c = position_of(positions, triangles[3 * f + 2]);
    const glm::dvec3 area = glm::cross(b - a, c - a);
    const double length = std::sqrt(glm::dot(area, area));
    if (length > 0.0 && std::isfinite(length)) faces[f] = {area, area / length};
  }
  return faces;
}

void append(std::vector<float>& normals, const glm::dvec3& normal) {
  const double length = std::sqrt(glm::dot(normal, normal));
  const glm::dvec3 unit = length > 0.0 ? normal / length : glm::dvec3(0, 0, 1);
  normals.insert(normals.end(),
                 {static_cast<float>(unit.x), static_cast<float>(unit.y), static_cast<float>(unit.z)});
}

/// The corners (triangle × 3 + 0..2) around each point, as one list with the place where each point begins.
struct Corners {
  std::vector<std::uint32_t> begin;
  std::vector<std::uint32_t> corner;
};

Corners corners_by_point(std::span<const std::uint32_t> point, std::span<const std::uint32_t> triangles) {
  Corners corners;
  corners.begin.assign(point.size() + 1, 0);
  for (const std::uint32_t vertex : triangles) ++corners.begin[point[vertex] + 1];
  std::partial_sum(corners.begin.begin(), corners.begin.end(), corners.begin.begin());
  corners.corner.resize(triangles.size());
  std::vector<std::uint32_t> next(corners.begin.begin(), corners.begin.end() - 1);
  for (std::size_t c = 0; c < triangles.size(); ++c) {
    corners.corner[next[point[triangles[c]]]++] = static_cast<std::uint32_t>(c);
  }
  return corners;
}

/// A point where more triangles than this meet keeps the normals of its faces: the work grows with the
/// square.
constexpr std::size_t kMaxTrianglesAroundPoint = 4096;

/// Sum over the triangles around one point that lie on the same side of every crease as `own`.
glm::dvec3 normal_at(const Face& own, std::span<const std::uint32_t> around, const std::vector<Face>& faces,
                     double cos_crease) {
  if (around.size() > kMaxTrianglesAroundPoint) return own.unit;
  glm::dvec3 sum(0.0);
  for (const std::uint32_t corner : around) {
    const Face& other = faces[corner / 3];
    if (glm::dot(own.unit, other.unit) >= cos_crease) sum += other.area;
  }
  return sum;
}

/// The new vertices made so far, found again by their source and normal.
class SplitVertices {
 public:
  SplitVertices(NormalSplit& split, std::size_t source_count)
      : split_(split), newest_(source_count, kNoCopy) {}

  std::uint32_t find_or_add(std::uint32_t source, const glm::dvec3& normal, bool may_be_known) {
    append(split_.normals, normal);
    const float* wanted = split_.normals.data() + split_.normals.size() - 3;
    for (std::uint32_t copy = newest_[source]; may_be_known && copy != kNoCopy; copy = older_[copy]) {
      if (!std::equal(wanted, wanted + 3, split_.normals.data() + std::size_t{3} * copy)) continue;
      split_.normals.resize(split_.normals.size() - 3);
      return copy;
    }
    const auto copy = static_cast<std::uint32_t>(split_.source.size());
    split_.source.push_back(source);
    older_.push_back(newest_[source]);
    newest_[source] = copy;
    return copy;
  }

 private:
  static constexpr std::uint32_t kNoCopy = 0xffffffffu;
  NormalSplit& split_;
  std::vector<std::uint32_t> newest_;  // of each source vertex
  std::vector<std::uint32_t> older_;   // of each new vertex
};

}  // namespace

NormalSplit flat_normals(std::span<const float> positions, std::span<const std::uint32_t> triangles) {
  NormalSplit split;
  split.source.assign(triangles.begin(), triangles.end());
  split.indices.resize(triangles.size());
  std::iota(split.indices.begin(), split.indices.end(), 0u);
  split.normals.reserve(triangles.size() * 3);
  for (const Face& face : faces_of(positions, triangles)) {
    for (int corner = 0; corner < 3; ++corner) append(split.normals, face.unit);
  }
  return split;
}

NormalSplit averaged_normals(std::span<const float> positions, std::span<const std::uint32_t> triangles,
                             double crease_angle_deg) {
  const std::vector<Face> faces = faces_of(positions, triangles);
  const std::vector<std::uint32_t> point = weld(positions, 3).number;
  const Corners corners = corners_by_point(point, triangles);
  // A little wider than asked, so that an angle of exactly the crease's is not decided by rounding.
  const double cos_crease = portable_cos(radians(std::clamp(crease_angle_deg, 0.0, 180.0))) - 1e-9;

  NormalSplit split;
  split.indices.resize(triangles.size());
  SplitVertices vertices(split, point.size());
  for (std::size_t c = 0; c < triangles.size(); ++c) {
    const std::uint32_t begin = corners.begin[point[triangles[c]]];
    const std::uint32_t end = corners.begin[point[triangles[c]] + 1];
    const std::span<const std::uint32_t> around(corners.corner.data() + begin, end - begin);
    split.indices[c] = vertices.find_or_add(triangles[c], normal_at(faces[c / 3], around, faces, cos_crease),
                                            around.size() <= kMaxTrianglesAroundPoint);
  }
  return split;
}

}  // namespace barrido::scene
