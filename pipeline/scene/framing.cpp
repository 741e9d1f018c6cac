#include "pipeline/scene/framing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "pipeline/scene/triangles.h"
#include "raster/base/portable_math.h"

namespace barrido::scene {
namespace {

constexpr double kEyeAzimuthDeg = 25.0;
constexpr double kEyeElevationDeg = 18.0;
constexpr double kMargin = 1.05;
constexpr int kFramingMoments = 9;

/// Which vertices of each primitive are drawn: empty for all. Found once for all looks at the scene.
class DrawnVertices {
 public:
  DrawnVertices(const Scene& scene, std::span<const int> nodes) : by_mesh_(scene.meshes.size()) {
    for (const int node : nodes) {
      const int mesh = scene.nodes[static_cast<std::size_t>(node)].mesh;
      if (mesh == kNone) continue;
      auto& primitives = by_mesh_[static_cast<std::size_t>(mesh)];
      if (!primitives.empty()) continue;
      for (const Primitive& p : scene.meshes[static_cast<std::size_t>(mesh)].primitives) {
        primitives.push_back(drawn_vertices(p.mode, p.indices.values(), p.vertex_count));
      }
    }
  }
  const std::vector<bool>& of(int mesh, std::size_t primitive) const {
    return by_mesh_[static_cast<std::size_t>(mesh)][primitive];
  }

 private:
  std::vector<std::vector<std::vector<bool>>> by_mesh_;
};

/// Adds points to `gathered`, which is the same whatever their order.
template <class Gathered>
void add_points(std::span<const float> positions, const std::vector<bool>& drawn,
                const glm::dmat4& world_from_object, Gathered& gathered) {
  for (std::size_t i = 0; i + 2 < positions.size(); i += 3) {
    if (!drawn.empty() && !drawn[i / 3]) continue;
    // Adding 0 turns −0 into 0, so that of equal numbers it does not matter which one is kept.
    const glm::dvec3 p =
        glm::dvec3(world_from_object * glm::dvec4(positions[i], positions[i + 1], positions[i + 2], 1.0)) +
        0.0;
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) gathered.add(p);
  }
}

/// The nodes to look at, and when.
struct Scenery {
  const Scene& scene;
  std::span<const int> nodes;
  std::span<const Pose> poses;
  DrawnVertices drawn{scene, nodes};
};

template <class Gathered>
void add_node(const Scenery& scenery, const Pose& pose, int node, Gathered& gathered) {
  const Scene& scene = scenery.scene;
  const int mesh = scene.nodes[static_cast<std::size_t>(node)].mesh;
  if (mesh == kNone) return;
  const glm::dmat4 world_from_node = file_world_from_node(pose, static_cast<std::size_t>(node));
  const std::vector<Primitive>& primitives = scene.meshes[static_cast<std::size_t>(mesh)].primitives;
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const std::vector<bool>& drawn = scenery.drawn.of(mesh, i);
    if (is_deformed(scene, node, primitives[i])) {
      const DeformedVertices deformed = deform(scene, pose, node, primitives[i]);
      glm::dmat4 world_from_origin(1.0);
      world_from_origin[3] += glm::dvec4(pose.origin, 0.0);
      add_points(deformed.positions, drawn, deformed.in_world_space ? world_from_origin : world_from_node,
                 gathered);
    } else {
      add_points(primitives[i].positions.values(), drawn, world_from_node, gathered);
    }
  }
}

/// `gathered` with every drawn vertex of all nodes and poses in the file's world; Gathered has add(point) and
/// join(gathered).
template <class Gathered>
Gathered gather_points(const Scenery& scenery, Gathered gathered) {
  using Range = tbb::blocked_range<std::size_t>;
  const auto join = [](Gathered a, const Gathered& b) {
    a.join(b);
    return a;
  };
  for (const Pose& pose : scenery.poses) {
    const auto add_nodes = [&](const Range& range, Gathered sum) {
      for (std::size_t i = range.begin(); i < range.end(); ++i)
        add_node(scenery, pose, scenery.nodes[i], sum);
      return sum;
    };
    gathered = tbb::parallel_reduce(Range(0, scenery.nodes.size()), gathered, add_nodes, join);
  }
  return gathered;
}

struct BoxGatherer {
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  glm::dvec3 low{kInfinity}, high{-kInfinity};

  void add(const glm::dvec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  void join(const BoxGatherer& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
};

struct RadiusGatherer {
  glm::dvec3 center{0.0};
  double radius_squared = 0.0;

  void add(const glm::dvec3& p) {
    radius_squared = std::max(radius_squared, glm::dot(p - center, p - center));
  }
  void join(const RadiusGatherer& other) { radius_squared = std::max(radius_squared, other.radius_squared); }
};

/// The highest and lowest place of each radius: the largest radius of every slice of the sphere, at both of
/// the slice's ends.
class RingCollector {
 public:
  RingCollector(const Sphere& sphere, const glm::dvec3& up) : sphere_(sphere), up_(unit_or(up, {0, 1, 0})) {}

  void add(const glm::dvec3& p) {
    const glm::dvec3 offset = p - sphere_.center;
    const double height = glm::dot(offset, up_) + 0.0;
    const glm::dvec3 across = offset - up_ * height;
    const double place = (height / sphere_.radius * 0.5 + 0.5) * kSlices;
    const auto slice = static_cast<std::size_t>(std::clamp(place, 0.0, kSlices - 1.0));
    Slice& s = slices_[slice];
    s.radius_squared = std::max(s.radius_squared, glm::dot(across, across));
    s.low = std::min(s.low, height);
    s.high = std::max(s.high, height);
  }

  void join(const RingCollector& other) {
    for (std::size_t i = 0; i < kSlices; ++i) {
      slices_[i].radius_squared = std::max(slices_[i].radius_squared, other.slices_[i].radius_squared);
      slices_[i].low = std::min(slices_[i].low, other.slices_[i].low);
      slices_[i].high = std::max(slices_[i].high, other.slices_[i].high);
    }
  }

  std::vector<glm::dvec2> rings() const {
    std::vector<glm::dvec2> rings;
    for (const Slice& slice : slices_) {
      if (slice.low > slice.high) continue;
      const double radius = std::sqrt(slice.radius_squared);
      rings.insert(rings.end(), {{radius, slice.low}, {radius, slice.high}});
    }
    return rings;
  }

 private:
  static constexpr int kSlices = 64;
  struct Slice {
    double radius_squared = 0.0;
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
  };
  Sphere sphere_;
  glm::dvec3 up_;
  std::array<Slice, kSlices> slices_;
};

Sphere bounding_sphere(const Scenery& scenery) {
  const BoxGatherer box = gather_points(scenery, BoxGatherer{});
  if (box.low.x > box.high.x) return {};
  const RadiusGatherer farthest = gather_points(scenery, RadiusGatherer{box.low * 0.5 + box.high * 0.5});
  Sphere sphere{farthest.center, std::sqrt(farthest.radius_squared)};
  // What is smaller is a point as far as single precision can tell, about the origin that the poses chose.
  const glm::dvec3 place = sphere.center - scenery.poses[0].origin;
  const double distance = std::sqrt(glm::dot(place, place));
  if (sphere.radius == 0.0) {
    sphere.radius = std::max(1.0, distance * 1e-3);
  } else {
    sphere.radius = std::max(sphere.radius, distance * 1e-6);
  }
  return sphere;
}

}  // namespace

Bounds find_bounds(const Scene& scene, std::span<const int> nodes, std::span<const Pose> poses,
                   const glm::dvec3& up) {
  const Scenery scenery{scene, nodes, poses};
  Bounds bounds;
  bounds.sphere = bounding_sphere(scenery);
  bounds.rings = gather_points(scenery, RingCollector(bounds.sphere, up)).rings();
  return bounds;
}

std::vector<Pose> framing_poses(const Scene& scene, int animation) {
  std::vector<Pose> poses;
  if (animation == kNone) {
    poses.push_back(pose_at(scene, kNone, 0.0));
    return poses;
  }
  const double duration_s = scene.animations[static_cast<std::size_t>(animation)].duration_s;
  for (int i = 0; i < kFramingMoments; ++i) {
    poses.push_back(pose_at(scene, animation, duration_s * i / (kFramingMoments - 1)));
  }
  return poses;
}

glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& fallback) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0.0) || !std::isfinite(largest)) return fallback;
  const glm::dvec3 scaled = v / largest;
  return scaled / std::sqrt(glm::dot(scaled, scaled));
}

glm::dvec3 turned(const glm::dvec3& p, const glm::dvec3& axis, double angle_deg) {
  const double angle = radians(angle_deg);
  const double c = portable_cos(angle), s = portable_sin(angle);
  return p * c + glm::cross(axis, p) * s + axis * (glm::dot(axis, p) * (1.0 - c));
}

glm::dmat3 world_from_upright(const glm::dvec3& up) {
  const glm::dvec3 y(0, 1, 0);
  const glm::dvec3 unit_up = unit_or(up, y);
  const glm::dvec3 axis = unit_or(glm::cross(y, unit_up), {1, 0, 0});
  const double angle_deg = portable_acos(glm::dot(y, unit_up)) * (180.0 / kPi);
  return {turned({1, 0, 0}, axis, angle_deg), unit_up, turned({0, 0, 1}, axis, angle_deg)};
}

glm::dvec3 default_eye_direction(const glm::dvec3& up) {
  const glm::dmat3 turn = world_from_upright(up);
  return turned(turned(turn[2], turn[0], -kEyeElevationDeg), turn[1], kEyeAzimuthDeg);
}

double framing_distance(const Bounds& bounds, double vertical_fov_rad, double aspect) {
  const double tan_y = std::max(portable_tan(vertical_fov_rad * 0.5), 1e-6);
  const double tan_x = tan_y * aspect;
  const double c = portable_cos(radians(kEyeElevationDeg)), s = portable_sin(radians(kEyeElevationDeg));
  // A point at angle φ of a ring (ρ, h) is ρ·sinφ to the right, h·c − ρ·cosφ·s up, and ρ·cosφ·c + h·s towards
  // the eye. It is in view when |right| ≤ tan_x·(distance − towards), |up| likewise; these are the largest
  // distances over all φ.
  double distance = 0.0;
  for (const glm::dvec2& ring : bounds.rings) {
    const double sideways = ring.x * std::sqrt(c * c + 1.0 / (tan_x * tan_x)) + ring.y * s;
    const double above = ring.x * std::abs(c - s / tan_y) + ring.y * (s + c / tan_y);
    const double below = ring.x * (c + s / tan_y) + ring.y * (s - c / tan_y);
    distance = std::max({distance, sideways, above, below});
  }
  // Of points and specks the sphere, which always has a size, keeps a distance.
  return kMargin * std::max(distance, bounds.sphere.radius);
}

}  // namespace barrido::scene
