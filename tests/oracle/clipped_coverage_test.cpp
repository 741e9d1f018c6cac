// Watertightness through clipping: meshes with vertices behind the eye, at the near plane, outside the guard
// band and beyond user clip planes must cover each pixel exactly once. A closed surface around the eye covers
// the whole frame; a plane through the near plane covers what a ray through the pixel hits. Additive blending
// counts.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "pipeline/matrix.h"
#include "raster/base/portable_math.h"
#include "tests/oracle/harness.h"

namespace barrido::oracle {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;
constexpr double kNear = 0.1;
constexpr double kFar = 1000.0;

double uniform(std::mt19937_64& bits, double low, double high) {
  return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
}

glm::dvec3 direction(std::mt19937_64& bits) {
  for (;;) {
    const double x = uniform(bits, -1, 1);
    const double y = uniform(bits, -1, 1);
    const double z = uniform(bits, -1, 1);
    const glm::dvec3 v(x, y, z);
    const double length = glm::length(v);
    if (length > 0.1 && length < 1.0) return v / length;
  }
}

/// Three random orthogonal unit vectors.
std::array<glm::dvec3, 3> random_frame(std::mt19937_64& bits) {
  const glm::dvec3 a = direction(bits);
  const glm::dvec3 b = glm::normalize(glm::cross(a, direction(bits)));
  return {a, b, glm::cross(a, b)};
}

pipeline::State counting_state(double vertical_fov_deg) {
  pipeline::State state;
  state.clip_from_eye =
      pipeline::perspective(radians(vertical_fov_deg), static_cast<double>(kWidth) / kHeight, kNear, kFar);
  state.blend.enabled = true;
  state.blend.src_rgb = state.blend.dst_rgb = raster::BlendFactor::one;
  state.blend.src_alpha = state.blend.dst_alpha = raster::BlendFactor::one;
  return state;
}

/// A surface around the eye that every ray leaves through exactly one triangle: an octahedron of random
/// orientation, split at random points of its faces and edges, each vertex at a random distance.
DrawnMesh closed_surface(std::mt19937_64& bits, int splits) {
  std::vector<glm::dvec3> points;
  for (const glm::dvec3& axis : random_frame(bits)) {
    points.push_back(axis);
    points.push_back(-axis);
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t octant = 0; octant < 8; ++octant) {
    const std::uint32_t a = octant & 1;
    const std::uint32_t b = 2 + (octant >> 1 & 1);
    const std::uint32_t c = 4 + (octant >> 2);
    const bool even = ((octant & 1) + (octant >> 1 & 1) + (octant >> 2)) % 2 == 0;
    triangles.push_back(even ? std::array{a, b, c} : std::array{b, a, c});
  }
  for (int k = 0; k < splits; ++k) {
    const std::size_t chosen = bits() % triangles.size();
    const auto [a, b, c] = triangles[chosen];
    const double u = uniform(bits, 0.02, 1.0);
    const double v = uniform(bits, 0.02, 1.0);
    const double w = uniform(bits, 0.02, 1.0);
    const auto index = static_cast<std::uint32_t>(points.size());
    points.push_back(glm::normalize(points[a] * u + points[b] * v + points[c] * w));
    triangles[chosen] = {a, b, index};
    triangles.push_back({b, c, index});
    triangles.push_back({c, a, index});
  }
  DrawnMesh mesh;
  for (const glm::dvec3& point : points) {
    // Far enough that the near plane cuts nothing in view.
    mesh.add(point * std::pow(10.0, uniform(bits, 0.5, 2.5)), {0, 0, 1});
  }
  for (const auto& triangle : triangles) {
    mesh.indices.insert(mesh.indices.end(), triangle.begin(), triangle.end());
  }
  return mesh;
}

/// How often front and back faces cover each pixel.
struct Faces {
  FloatFrame front{kWidth, kHeight};
  FloatFrame back{kWidth, kHeight};

  void draw(pipeline::State state, const DrawnMesh& mesh) {
    state.cull_face = pipeline::CullFace::back;
    front.draw(state, mesh.geometry());
    state.cull_face = pipeline::CullFace::front;
    back.draw(state, mesh.geometry());
  }
};

// Snapping to 1/256 pixel can turn a sliver over, and then a pixel centre in it lies under two more
// triangles, one of each facing. So the exact law is that inner (back) faces minus outer (front) ones is 1 at
// every pixel; that there are no other faces than that one is true but for a few pixels in a million.
TEST(ClippedCoverage, ASurfaceAroundTheEyeCoversEachPixelOnce) {
  std::mt19937_64 bits(11);
  std::size_t triangles = 0;
  int wrong = 0;
  int turned_over = 0;
  int pixels = 0;
  Faces faces;
  for (int trial = 0; trial < 600 && wrong < 20; ++trial) {
    const DrawnMesh mesh = closed_surface(bits, static_cast<int>(bits() % 400));
    faces.draw(counting_state(uniform(bits, 5.0, 150.0)), mesh);
    triangles += mesh.indices.size() / 3;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const double front = faces.front.at(x, y).r;
        const double back = faces.back.at(x, y).r;
        ++pixels;
        if (front != 0.0) ++turned_over;
        if (back - front == 1.0) continue;
        ++wrong;
        ADD_FAILURE() << "trial " << trial << ": pixel (" << x << ", " << y << ") covered " << back
                      << " times by inner faces, " << front << " times by outer ones";
      }
    }
  }
  EXPECT_EQ(wrong, 0) << "of " << triangles << " triangles";
  EXPECT_LE(turned_over * 1e6 / pixels, 2.0);
  EXPECT_GE(triangles, 100000u);
}

/// A jittered grid on a plane through eye space: cells without T-junctions, `side` cells a side.
DrawnMesh ground(std::mt19937_64& bits, const glm::dvec3& center, const glm::dvec3& s, const glm::dvec3& t,
                 double cell, int side) {
  DrawnMesh mesh;
  for (int j = 0; j <= side; ++j) {
    for (int i = 0; i <= side; ++i) {
      const bool rim = i == 0 || j == 0 || i == side || j == side;
      const double x = (i - side / 2.0 + (rim ? 0.0 : uniform(bits, -0.2, 0.2))) * cell;
      const double y = (j - side / 2.0 + (rim ? 0.0 : uniform(bits, -0.2, 0.2))) * cell;
      mesh.add(center + s * x + t * y, {0, 0, 1});
    }
  }
  const auto stride = static_cast<std::uint32_t>(side) + 1;
  for (std::uint32_t j = 0; j + 1 < stride; ++j) {
    for (std::uint32_t i = 0; i + 1 < stride; ++i) {
      const std::uint32_t a = j * stride + i;
      const std::uint32_t d = a + stride;
      const std::array<std::uint32_t, 6> one{a, a + 1, d + 1, a, d + 1, d};
      const std::array<std::uint32_t, 6> other{a, a + 1, d, a + 1, d + 1, d};
      const auto& cells = bits() % 2 == 0 ? one : other;
      mesh.indices.insert(mesh.indices.end(), cells.begin(), cells.end());
    }
  }
  return mesh;
}

/// What a ray through the centre of a pixel meets: 1 the plane between near plane, user plane and rim, 0
/// nothing, -1 within rounding of one of them.
class PlaneOracle {
 public:
  PlaneOracle(const glm::dvec3& center, const glm::dvec3& s, const glm::dvec3& t, double half_side,
              double vertical_fov_deg, const glm::dvec4& clip_plane)
      : center_(center), s_(s), t_(t), half_side_(half_side), clip_plane_(clip_plane) {
    tangent_ = std::tan(vertical_fov_deg * kPi / 360.0);
  }

  int operator()(int x, int y) const {
    int certain = classify(x + 0.5, y + 0.5);
    // Vertices are snapped to 1/256 pixel: the borders are only known to that.
    for (const double dx : {-0.02, 0.02}) {
      for (const double dy : {-0.02, 0.02}) {
        if (classify(x + 0.5 + dx, y + 0.5 + dy) != certain) return -1;
      }
    }
    return certain;
  }

 private:
  int classify(double window_x, double window_y) const {
    const glm::dvec3 ray((2.0 * window_x / kWidth - 1.0) * tangent_ * kWidth / kHeight,
                         (2.0 * window_y / kHeight - 1.0) * tangent_, -1.0);
    const glm::dvec3 normal = glm::cross(s_, t_);
    const double depth = glm::dot(normal, center_) / glm::dot(normal, ray);  // eye-space distance along −z
    if (!(depth > kNear && depth < kFar)) return 0;
    const glm::dvec3 hit = ray * depth;
    if (glm::dot(glm::dvec3(clip_plane_), hit) + clip_plane_.w < 0.0) return 0;
    const glm::dvec3 local = hit - center_;
    const bool inside =
        std::fabs(glm::dot(local, s_)) < half_side_ && std::fabs(glm::dot(local, t_)) < half_side_;
    return inside ? 1 : 0;
  }

  glm::dvec3 center_, s_, t_;
  double half_side_;
  glm::dvec4 clip_plane_;
  double tangent_ = 1.0;
};

/// How many pixels are not covered as `expected` (-1: once or not at all) says, faces that face the other way
/// than the plane does in the frame counted as less than none. Adds the pixels with faces of both kinds.
template <class Expected>
int count_wrong(const Faces& faces, const std::string& name, const Expected& expected, int& turned_over) {
  int wrong = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double front = faces.front.at(x, y).r;
      const double back = faces.back.at(x, y).r;
      const double count = std::fabs(front - back);
      if (front > 0.0 && back > 0.0) ++turned_over;
      const int wanted = expected(x, y);
      if (wanted < 0 ? count <= 1.0 : count == wanted) continue;
      if (wrong++ < 3) {
        ADD_FAILURE() << name << ": pixel (" << x << ", " << y << ") covered " << front
                      << " times by front faces, " << back << " times by back faces, expected " << wanted;
      }
    }
  }
  return wrong;
}

TEST(ClippedCoverage, APlaneThroughTheNearPlaneIsCoveredOnce) {
  std::mt19937_64 bits(12);
  std::size_t triangles = 0;
  int wrong = 0;
  int certain = 0;
  int turned_over = 0;
  int trials = 0;
  Faces faces;
  for (int trial = 0; trial < 600; ++trial) {
    const auto [s, t, normal] = random_frame(bits);
    const double distance = uniform(bits, 0.02, 0.5);
    const glm::dvec3 center = normal * distance + glm::dvec3(0, 0, -uniform(bits, 0.0, 1.0));
    const int side = 2 + static_cast<int>(bits() % 30);
    const double cell = std::pow(10.0, uniform(bits, -1.5, 1.5));
    const double fov = uniform(bits, 20.0, 140.0);
    const DrawnMesh mesh = ground(bits, center, s, t, cell, side);
    pipeline::State state = counting_state(fov);
    glm::dvec4 plane(0, 0, 0, 1);
    if (bits() % 2 == 0) {
      const glm::dvec3 plane_normal = direction(bits);
      plane = glm::dvec4(plane_normal, uniform(bits, -0.1, 0.5));
      state.clip_planes.emplace_back(plane);
    }
    faces.draw(state, mesh);
    ++trials;
    triangles += mesh.indices.size() / 3;
    const PlaneOracle oracle(center, s, t, side * cell / 2.0, fov, plane);
    const auto expected = [&](int x, int y) {
      const int wanted = oracle(x, y);
      certain += wanted == 1 ? 1 : 0;
      return wanted;
    };
    wrong += count_wrong(faces, "trial " + std::to_string(trial), expected, turned_over);
    if (wrong > 20) break;
  }
  EXPECT_EQ(wrong, 0) << "of " << triangles << " triangles";
  EXPECT_LE(turned_over * 1e6 / (static_cast<double>(kWidth) * kHeight * trials), 2.0);
  EXPECT_GE(certain, 1000000);
}

}  // namespace
}  // namespace barrido::oracle
