#include "pipeline/scene/tangent_space.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstring>
#include <deque>
#include <tuple>
#include <unordered_map>

#include "raster/base/portable_math.h"

namespace barrido::scene {
namespace {

constexpr std::uint32_t kNobody = ~0u;

// Sums in the order that is written here; glm may choose another.
float dot(const glm::vec3& a, const glm::vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
float length(const glm::vec3& v) { return std::sqrt(dot(v, v)); }
bool is_something(float x) { return std::fabs(x) > FLT_MIN; }
glm::vec3 unit(const glm::vec3& v) {
  const bool usable = is_something(v.x) || is_something(v.y) || is_something(v.z);
  return usable ? v * (1.0f / length(v)) : v;
}
/// The part of `v` in the plane of `n`, as a unit vector.
glm::vec3 in_plane(const glm::vec3& n, const glm::vec3& v) { return unit(v - n * dot(n, v)); }

/// Coordinates beyond all measure may have overflowed.
glm::vec3 usable(const glm::vec3& v, const glm::vec3& otherwise) { return dot(v, v) < 2.0f ? v : otherwise; }

int next_corner(int corner) { return corner < 2 ? corner + 1 : 0; }
int previous_corner(int corner) { return corner > 0 ? corner - 1 : 2; }

/// How a triangle lies on its map.
struct Face {
  std::array<std::uint32_t, 3> vertex{};  ///< Shared
  glm::vec3 along_s{0}, along_t{0};       ///< Unit vectors, or 0
  float length_s = 0.0f, length_t = 0.0f;
  bool keeps_orientation = false;
  bool joins_any = true;       ///< It has no area on the map: it may join tangents of either orientation.
  bool is_degenerate = false;  ///< Two of its places are equal.
  std::array<std::uint32_t, 3> neighbor{kNobody, kNobody, kNobody};  ///< Across the edge from corner i
  std::array<std::uint32_t, 3> group{kNobody, kNobody, kNobody};     ///< Of corner i
};

/// Faces round one vertex, edge by edge, whose maps have one orientation.
struct Group {
  std::uint32_t vertex = 0;
  bool keeps_orientation = false;
  std::vector<std::uint32_t> faces;
};

struct VertexKey {
  std::array<std::uint32_t, 8> bits{};
  bool operator==(const VertexKey&) const = default;
};
struct KeyHash {
  std::size_t operator()(const VertexKey& key) const {
    std::uint64_t hash = 14695981039346656037u;
    for (const std::uint32_t word : key.bits) hash = (hash ^ word) * 1099511628211u;
    return static_cast<std::size_t>(hash ^ (hash >> 29));
  }
};

class TangentSpace {
 public:
  explicit TangentSpace(const TexturedTriangles& mesh) : mesh_(mesh) {}

  std::vector<CornerTangent> run() {
    share_vertices();
    for (Face& face : faces_) lay_out(face);
    find_neighbors();
    find_groups();
    std::vector<CornerTangent> corners(3 * faces_.size());
    for (const Group& group : groups_) evaluate(group, corners);
    fill_degenerate(corners);
    return corners;
  }

 private:
  glm::vec3 position(std::uint32_t vertex) const { return load(mesh_.positions, vertex); }
  glm::vec3 normal(std::uint32_t vertex) const { return load(mesh_.normals, vertex); }
  static glm::vec3 load(std::span<const float> values, std::uint32_t vertex) {
    const float* v = values.data() + std::size_t{3} * vertex;
    return {v[0], v[1], v[2]};
  }
  float s(std::uint32_t vertex) const { return mesh_.coordinates[std::size_t{2} * vertex]; }
  float t(std::uint32_t vertex) const { return mesh_.coordinates[std::size_t{2} * vertex + 1]; }

  VertexKey key_of(std::uint32_t vertex) const {
    const glm::vec3 p = position(vertex), n = normal(vertex);
    const float values[8] = {p.x, p.y, p.z, n.x, n.y, n.z, s(vertex), t(vertex)};
    VertexKey key;
    for (std::size_t i = 0; i < 8; ++i)
      key.bits[i] = std::bit_cast<std::uint32_t>(values[i] + 0.0f);  // −0 is 0
    return key;
  }

  /// Vertices that are equal in all count as one: the first of them.
  void share_vertices() {
    std::unordered_map<VertexKey, std::uint32_t, KeyHash> first;
    first.reserve(mesh_.positions.size() / 3);
    faces_.resize(mesh_.triangles.size() / 3);
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t vertex = mesh_.triangles[3 * f + i];
        faces_[f].vertex[i] = first.try_emplace(key_of(vertex), vertex).first->second;
      }
    }
  }

  /// First derivatives of the place by the coordinates.
  void lay_out(Face& face) const {
    const auto [a, b, c] = face.vertex;
    const glm::vec3 pa = position(a), pb = position(b), pc = position(c);
    face.is_degenerate = pa == pb || pa == pc || pb == pc;
    const float s1 = s(b) - s(a), t1 = t(b) - t(a), s2 = s(c) - s(a), t2 = t(c) - t(a);
    const glm::vec3 d1 = pb - pa, d2 = pc - pa;
    const float twice_area = s1 * t2 - t1 * s2;
    face.keeps_orientation = twice_area > 0.0f;
    if (!is_something(twice_area)) return;
    const glm::vec3 along_s = d1 * t2 - d2 * t1, along_t = d1 * -s2 + d2 * s1;
    const float size_s = length(along_s), size_t = length(along_t);
    const float sign = face.keeps_orientation ? 1.0f : -1.0f;
    if (is_something(size_s)) face.along_s = along_s * (sign / size_s);
    if (is_something(size_t)) face.along_t = along_t * (sign / size_t);
    face.length_s = size_s / std::fabs(twice_area);
    face.length_t = size_t / std::fabs(twice_area);
    face.joins_any = !is_something(face.length_s) || !is_something(face.length_t);
  }

  struct Edge {
    std::uint32_t low, high, face;
    int corner;
    bool upwards;
  };

  /// Faces whose edges run from one shared vertex to another and back; where there are more than two, the
  /// first with the first that runs the other way.
  void find_neighbors() {
    std::vector<Edge> edges;
    edges.reserve(3 * faces_.size());
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
      if (faces_[f].is_degenerate) continue;
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t from = vertex_of(f, i), to = vertex_of(f, next_corner(i));
        edges.push_back({std::min(from, to), std::max(from, to), f, i, from < to});
      }
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
      return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
    });
    std::deque<Edge> waiting;  // of one pair of vertices, all in one direction
    for (const Edge& edge : edges) {
      if (!waiting.empty() && (waiting.front().low != edge.low || waiting.front().high != edge.high)) {
        waiting.clear();
      }
      if (waiting.empty() || waiting.front().upwards == edge.upwards) {
        waiting.push_back(edge);
        continue;
      }
      const Edge& other = waiting.front();
      faces_[edge.face].neighbor[static_cast<std::size_t>(edge.corner)] = other.face;
      faces_[other.face].neighbor[static_cast<std::size_t>(other.corner)] = edge.face;
      waiting.pop_front();
    }
  }

  std::uint32_t vertex_of(std::uint32_t face, int corner) const {
    return faces_[face].vertex[static_cast<std::size_t>(corner)];
  }
  int corner_at(std::uint32_t face, std::uint32_t vertex) const {
    const auto& corners = faces_[face].vertex;
    return corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2;
  }

  void find_groups() {
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
      Face& face = faces_[f];
      if (face.is_degenerate || face.joins_any) continue;
      for (int i = 0; i < 3; ++i) {
        if (face.group[static_cast<std::size_t>(i)] != kNobody) continue;
        groups_.push_back({vertex_of(f, i), face.keeps_orientation, {}});
        spread(static_cast<std::uint32_t>(groups_.size() - 1), f);
      }
    }
  }

  /// Adds the face, and those beside it round the group's vertex, as far as they are of one orientation.
  void spread(std::uint32_t number, std::uint32_t start) {
    Group& group = groups_[number];
    std::vector<std::uint32_t> open{start};
    while (!open.empty()) {
      const std::uint32_t f = open.back();
      open.pop_back();
      Face& face = faces_[f];
      const int corner = corner_at(f, group.vertex);
      if (face.group[static_cast<std::size_t>(corner)] != kNobody) continue;
      const bool is_free = face.group == std::array{kNobody, kNobody, kNobody};
      if (face.joins_any && is_free) face.keeps_orientation = group.keeps_orientation;
      if (face.keeps_orientation != group.keeps_orientation) continue;
      face.group[static_cast<std::size_t>(corner)] = number;
      group.faces.push_back(f);
      for (const int edge : {corner, previous_corner(corner)}) {
        const std::uint32_t beside = face.neighbor[static_cast<std::size_t>(edge)];
        if (beside != kNobody) open.push_back(beside);
      }
    }
    std::sort(group.faces.begin(), group.faces.end());
  }

  /// The angle of the face at the corner, seen along the normal.
  float angle_at(std::uint32_t face, int corner, const glm::vec3& n) const {
    const glm::vec3 here = position(vertex_of(face, corner));
    const glm::vec3 v1 = in_plane(n, position(vertex_of(face, previous_corner(corner))) - here);
    const glm::vec3 v2 = in_plane(n, position(vertex_of(face, next_corner(corner))) - here);
    return static_cast<float>(portable_acos(static_cast<double>(std::clamp(dot(v1, v2), -1.0f, 1.0f))));
  }

  void evaluate(const Group& group, std::vector<CornerTangent>& corners) const {
    const glm::vec3 n = normal(group.vertex);
    CornerTangent mean{glm::vec3(0.0f), glm::vec3(0.0f), 0.0f, 0.0f, group.keeps_orientation};
    float angles = 0.0f;
    for (const std::uint32_t f : group.faces) {
      const Face& face = faces_[f];
      if (face.joins_any) continue;
      const float angle = angle_at(f, corner_at(f, group.vertex), n);
      mean.tangent += in_plane(n, face.along_s) * angle;
      mean.bitangent += in_plane(n, face.along_t) * angle;
      mean.tangent_length += face.length_s * angle;
      mean.bitangent_length += face.length_t * angle;
      angles += angle;
    }
    mean.tangent = usable(unit(mean.tangent), CornerTangent().tangent);
    mean.bitangent = usable(unit(mean.bitangent), CornerTangent().bitangent);
    if (angles > 0.0f) {
      mean.tangent_length /= angles;
      mean.bitangent_length /= angles;
    }
    for (const std::uint32_t f : group.faces) {
      corners[std::size_t{3} * f + static_cast<std::size_t>(corner_at(f, group.vertex))] = mean;
    }
  }

  /// The first corner of another triangle with the same vertex gives its tangent.
  void fill_degenerate(std::vector<CornerTangent>& corners) const {
    std::unordered_map<std::uint32_t, std::size_t> first;
    const auto for_corners = [&](bool degenerate, const auto& visit) {
      for (std::size_t f = 0; f < faces_.size(); ++f) {
        if (faces_[f].is_degenerate != degenerate) continue;
        for (std::size_t i = 0; i < 3; ++i) visit(faces_[f].vertex[i], 3 * f + i);
      }
    };
    const auto degenerate = [](const Face& face) { return face.is_degenerate; };
    if (std::none_of(faces_.begin(), faces_.end(), degenerate)) return;
    for_corners(false, [&](std::uint32_t vertex, std::size_t corner) { first.try_emplace(vertex, corner); });
    for_corners(true, [&](std::uint32_t vertex, std::size_t corner) {
      if (const auto found = first.find(vertex); found != first.end())
        corners[corner] = corners[found->second];
    });
  }

  TexturedTriangles mesh_;
  std::vector<Face> faces_;
  std::vector<Group> groups_;
};

}  // namespace

std::vector<CornerTangent> corner_tangents(const TexturedTriangles& mesh) { return TangentSpace(mesh).run(); }

}  // namespace barrido::scene
