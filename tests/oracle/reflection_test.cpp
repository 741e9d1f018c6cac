// Reflections in a sphere (course T17) against the reflected ray in double precision, looked up in cube maps
// whose contents are known.
//
// Tolerance. The sphere has 384 × 192 facets; as in sphere_test.cpp the normal at a pixel with N_z > 0.25 is
// known to 2.3e-4 and the reflected ray, which turns twice as fast, to 5e-4.
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/matrix.h"
#include "pipeline/scene/cube_directions.h"
#include "tests/oracle/harness.h"

namespace barrido::oracle {
namespace {

constexpr int kSize = 160;
constexpr double kHalfView = 0.30;  // tangent of half the angle of view
constexpr glm::dvec3 kCenter{0, 0, -4};
constexpr double kLeastNormalZ = 0.25;
constexpr double kRayError = 5e-4;

DrawnMesh sphere_mesh() {
  constexpr int kSlices = 384, kStacks = 192;
  DrawnMesh mesh;
  for (int j = 0; j <= kStacks; ++j) {
    const double theta = M_PI * j / kStacks;
    for (int i = 0; i <= kSlices; ++i) {
      const double phi = 2 * M_PI * i / kSlices;
      const glm::dvec3 n(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi));
      mesh.add(n + kCenter, n);
    }
  }
  for (std::uint32_t j = 0; j < kStacks; ++j) {
    for (std::uint32_t i = 0; i < kSlices; ++i) {
      const std::uint32_t a = j * (kSlices + 1) + i, b = a + kSlices + 1;
      mesh.indices.insert(mesh.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
    }
  }
  return mesh;
}

/// Eye to world: the map stands in the world, the eye is turned.
glm::dmat4 world_from_eye() { return glm::dmat4(pipeline::rotation(0.7, {0.3, 1.0, 0.2})); }

pipeline::State reflecting_state(const raster::Texture& map) {
  pipeline::State state;
  state.clip_from_eye = pipeline::perspective(2 * std::atan(kHalfView), 1.0, 1.0, 10.0);
  state.cull_face = pipeline::CullFace::back;
  state.depth.test = true;
  state.clamp_colors = false;
  state.texture_units[0].texture = &map;
  state.texture_units[0].env_mode = raster::TextureEnvMode::replace;
  for (std::size_t c = 0; c < 3; ++c) {
    state.texture_coordinates[0].generation[c].enabled = true;
    state.texture_coordinates[0].generation[c].mode = pipeline::TexGenMode::reflection_map;
  }
  state.texture_coordinates[0].matrix = glm::mat4(world_from_eye());
  return state;
}

/// Calls function(x, y, r) with the reflected direction in the world for every pixel well within the sphere.
template <class Function>
void for_each_reflection(Function&& function) {
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const glm::dvec3 ray = glm::normalize(
          glm::dvec3(((x + 0.5) / kSize * 2 - 1) * kHalfView, ((y + 0.5) / kSize * 2 - 1) * kHalfView, -1.0));
      const double along = glm::dot(ray, kCenter);
      const double under = along * along - glm::dot(kCenter, kCenter) + 1.0;
      if (under < 0) continue;
      const glm::dvec3 n = ray * (along - std::sqrt(under)) - kCenter;
      if (-glm::dot(n, ray) < kLeastNormalZ) continue;
      const glm::dvec3 reflected = ray - 2.0 * glm::dot(n, ray) * n;
      function(x, y, glm::dmat3(world_from_eye()) * reflected);
    }
  }
}

raster::Texture cube_of(int size, const std::function<glm::dvec3(const glm::dvec3&)>& color) {
  std::array<std::vector<std::uint8_t>, 6> bytes;
  std::array<raster::Pixels8, 6> faces;
  for (int face = 0; face < 6; ++face) {
    std::vector<std::uint8_t>& rgba = bytes[static_cast<std::size_t>(face)];
    for (int j = 0; j < size; ++j) {
      for (int i = 0; i < size; ++i) {
        const glm::dvec3 c =
            color(scene::cube_direction(face, scene::texel_middle(i, size), scene::texel_middle(j, size)));
        for (int k = 0; k < 3; ++k) rgba.push_back(static_cast<std::uint8_t>(std::lround(c[k] * 255.0)));
        rgba.push_back(255);
      }
    }
    faces[static_cast<std::size_t>(face)] = {size, size, rgba};
  }
  raster::TextureOptions options;
  options.mipmaps = false;
  return raster::Texture::make_cube(faces, options);
}

/// Which face a direction meets, +X −X +Y −Y +Z −Z, and by how much its major axis leads.
struct Face {
  int index;
  double lead;
};
Face face_of(const glm::dvec3& d) {
  const glm::dvec3 a = glm::abs(d);
  const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
  const double second = std::max(a[(axis + 1) % 3], a[(axis + 2) % 3]);
  return {axis * 2 + (d[axis] < 0 ? 1 : 0), a[axis] - second};
}

constexpr std::array<glm::dvec3, 6> kFaceColors{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 1),
                                                glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 1),
                                                glm::dvec3(0, 0, 1), glm::dvec3(1, 1, 0)};

TEST(ReflectionOracle, EveryPixelMeetsTheRightFace) {  // T17
  const raster::Texture map =
      cube_of(4, [](const glm::dvec3& d) { return kFaceColors[static_cast<std::size_t>(face_of(d).index)]; });
  pipeline::State state = reflecting_state(map);
  state.texture_units[0].min_filter = raster::MinFilter::nearest;
  state.texture_units[0].mag_filter = raster::MagFilter::nearest;
  const DrawnMesh mesh = sphere_mesh();
  FloatFrame frame(kSize, kSize);
  frame.draw(state, mesh.geometry());
  int compared = 0, wrong = 0;
  std::array<int, 6> seen{};
  for_each_reflection([&](int x, int y, const glm::dvec3& reflected) {
    const Face face = face_of(reflected);
    if (face.lead < 2 * kRayError) return;
    ++compared;
    ++seen[static_cast<std::size_t>(face.index)];
    if (glm::dvec3(frame.at(x, y)) != kFaceColors[static_cast<std::size_t>(face.index)]) ++wrong;
  });
  EXPECT_GT(compared, 10000);
  EXPECT_EQ(wrong, 0);
  for (const int pixels : seen) EXPECT_GT(pixels, 50);
}

TEST(ReflectionOracle, ColorsFollowTheDirection) {  // T17
  // Colour ½ + ½ of the direction scaled to the cube: linear in s and t on every face and continuous over the
  // edges, so that the linear filter reproduces it but for the rounding of texels to 1/510.
  constexpr int kMapSize = 64;
  const auto color = [](const glm::dvec3& d) {
    return glm::dvec3(0.5) + d * 0.5 / std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  };
  const raster::Texture map = cube_of(kMapSize, color);
  pipeline::State state = reflecting_state(map);
  state.texture_units[0].min_filter = raster::MinFilter::linear;
  const DrawnMesh mesh = sphere_mesh();
  FloatFrame frame(kSize, kSize);
  frame.draw(state, mesh.geometry());
  Comparison inside, edge;
  for_each_reflection([&](int x, int y, const glm::dvec3& reflected) {
    // Within a texel of a face's edge the filter mixes two faces, over a bend of the colour.
    const Face face = face_of(reflected);
    const bool near_edge = face.lead < 2.0 / kMapSize;
    (near_edge ? edge : inside).add(x, y, glm::dvec3(frame.at(x, y)), color(reflected));
  });
  EXPECT_GT(inside.compared, 10000);
  // √3·5e-4/2 for the ray, half a step of a byte for the texels, a step of the filter.
  EXPECT_LE(inside.largest, 0.0005 + 1.0 / 510.0 + 1e-4);
  EXPECT_LE(edge.largest, 1.0 / kMapSize);
}

}  // namespace
}  // namespace barrido::oracle
