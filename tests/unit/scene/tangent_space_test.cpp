#include "pipeline/scene/tangent_space.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "pipeline/scene/prepared_geometry.h"

namespace barrido::scene {
namespace {

struct Mesh {
  std::vector<float> positions, normals, coordinates;
  std::vector<std::uint32_t> triangles;

  void add(const glm::vec3& p, const glm::vec3& n, float s, float t) {
    positions.insert(positions.end(), {p.x, p.y, p.z});
    normals.insert(normals.end(), {n.x, n.y, n.z});
    coordinates.insert(coordinates.end(), {s, t});
  }
  std::vector<CornerTangent> tangents() const {
    return corner_tangents({positions, normals, coordinates, triangles});
  }
};

struct CubeCorner {
  float s, t;
  glm::vec3 direction;
};

/// The cube that the ports of MikkTSpace to Rust (gltf-rs/mikktspace, bevy_mikktspace) publish results for:
/// four triangles a side round its middle, smooth normals, two sides whose coordinates have no area.
Mesh published_cube() {
  constexpr std::array<std::array<CubeCorner, 5>, 6> kSides{{{{{0, 0, {1, -1, 1}},
                                                               {0, 1, {1, -1, -1}},
                                                               {1, 1, {1, 1, -1}},
                                                               {1, 0, {1, 1, 1}},
                                                               {.5f, .5f, {1, 0, 0}}}},
                                                             {{{1, 0, {-1, 1, 1}},
                                                               {1, 1, {-1, 1, -1}},
                                                               {0, 1, {-1, -1, -1}},
                                                               {0, 0, {-1, -1, 1}},
                                                               {.5f, .5f, {-1, 0, 0}}}},
                                                             {{{0, 0, {1, 1, 1}},
                                                               {0, 1, {1, 1, -1}},
                                                               {0, 1, {-1, 1, -1}},
                                                               {0, 0, {-1, 1, 1}},
                                                               {0, .5f, {0, 1, 0}}}},
                                                             {{{0, 0, {-1, -1, 1}},
                                                               {0, 1, {-1, -1, -1}},
                                                               {0, 1, {1, -1, -1}},
                                                               {0, 0, {1, -1, 1}},
                                                               {0, .5f, {0, -1, 0}}}},
                                                             {{{0, 0, {-1, 1, 1}},
                                                               {0, 1, {-1, -1, 1}},
                                                               {1, 1, {1, -1, 1}},
                                                               {1, 0, {1, 1, 1}},
                                                               {.5f, .5f, {0, 0, 1}}}},
                                                             {{{1, 0, {1, 1, -1}},
                                                               {1, 1, {1, -1, -1}},
                                                               {0, 1, {-1, -1, -1}},
                                                               {0, 0, {-1, 1, -1}},
                                                               {.5f, .5f, {0, 0, -1}}}}}};
  Mesh mesh;
  for (std::uint32_t side = 0; side < 6; ++side) {
    for (const CubeCorner& c : kSides[side]) {
      mesh.add(c.direction / 2.0f, c.direction / glm::length(c.direction), c.s, c.t);
    }
    for (std::uint32_t i = 0; i < 4; ++i) {
      mesh.triangles.insert(mesh.triangles.end(), {5 * side + i, 5 * side + (i + 1) % 4, 5 * side + 4});
    }
  }
  return mesh;
}

struct PublishedTangent {
  std::size_t face, corner;
  glm::vec3 tangent, bitangent;
  float sign;
};

TEST(TangentSpace, GivesThePublishedTangentsOfTheCube) {
  constexpr float a = 0.40824825f, b = 0.81649655f;
  const PublishedTangent published[] = {
      {0, 0, {a, b, a}, {a, -a, -b}, -1},  {0, 1, {a, b, -a}, {-a, a, -b}, -1},
      {0, 2, {0, 1, 0}, {0, 0, -1}, -1},   {1, 1, {-a, b, a}, {-a, -a, -b}, -1},
      {2, 1, {-a, b, -a}, {a, a, -b}, -1}, {3, 0, {-a, b, -a}, {a, a, -b}, -1},
      {3, 1, {a, b, a}, {a, -a, -b}, -1},  {4, 0, {a, b, -a}, {-a, a, -b}, 1},
      {4, 1, {a, b, a}, {a, -a, -b}, 1},   {4, 2, {0, 1, 0}, {0, 0, -1}, 1},
      {5, 1, {-a, b, -a}, {a, a, -b}, 1},  {6, 1, {-a, b, a}, {-a, -a, -b}, 1},
      {7, 1, {a, b, -a}, {-a, a, -b}, 1},  {8, 0, {1, 0, 0}, {0, 1, 0}, -1},
      {11, 2, {1, 0, 0}, {0, 1, 0}, -1},   {12, 0, {-a, b, a}, {-a, -a, -b}, 1},
      {12, 1, {-a, b, -a}, {a, a, -b}, 1}, {12, 2, {1, 0, 0}, {0, 1, 0}, -1},
  };
  const std::vector<CornerTangent> tangents = published_cube().tangents();
  for (const PublishedTangent& p : published) {
    const CornerTangent& t = tangents[3 * p.face + p.corner];
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(t.tangent[axis], p.tangent[axis], 2e-7f) << p.face << ' ' << p.corner << ' ' << axis;
      EXPECT_NEAR(t.bitangent[axis], p.bitangent[axis], 2e-7f) << p.face << ' ' << p.corner << ' ' << axis;
    }
    EXPECT_EQ(t.sign(), p.sign) << p.face << ' ' << p.corner;
    EXPECT_NEAR(t.tangent_length, 1.0f, 1e-6f);
  }
}

/// Two squares beside each other, the right one's coordinates mirrored at the edge between them.
Mesh mirrored_squares() {
  Mesh mesh;
  for (int j = 0; j < 2; ++j) {
    for (int i = -1; i <= 1; ++i) {
      mesh.add({2.0f * static_cast<float>(i), static_cast<float>(j), 0}, {0, 0, 1},
               std::fabs(static_cast<float>(i)), static_cast<float>(j));
    }
  }
  mesh.triangles = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
  return mesh;
}

TEST(TangentSpace, AMirroredSeamHasTwoTangents) {
  const std::vector<CornerTangent> tangents = mirrored_squares().tangents();
  const CornerTangent &left = tangents[1], &right = tangents[6];  // both vertex 1
  EXPECT_EQ(left.tangent, glm::vec3(-1, 0, 0));
  EXPECT_EQ(right.tangent, glm::vec3(1, 0, 0));
  EXPECT_EQ(left.sign(), -1.0f);
  EXPECT_EQ(right.sign(), 1.0f);
  EXPECT_FLOAT_EQ(left.tangent_length, 2.0f);  // 2 units for 1 of s
  EXPECT_FLOAT_EQ(left.bitangent_length, 1.0f);
}

TEST(TangentSpace, SplitsVerticesOnAMirroredSeamAndNoOthers) {
  const Mesh mesh = mirrored_squares();
  Primitive primitive;
  primitive.vertex_count = 6;
  primitive.positions = FloatArray(mesh.positions);
  primitive.normals = FloatArray(mesh.normals);
  primitive.texcoords[0] = FloatArray(mesh.coordinates);
  primitive.indices = mesh.triangles;
  const auto plain = prepare(primitive, std::nullopt);
  const auto prepared = prepare_tangents(*plain, {});
  ASSERT_NE(prepared, nullptr);
  EXPECT_EQ(prepared->geometry.vertex_count, 8u);  // both vertices of the seam twice
  ASSERT_EQ(prepared->geometry.tangent.components, 4);
  for (std::size_t corner = 0; corner < 12; ++corner) {
    const std::uint32_t vertex = prepared->indices[corner];
    const float* t = prepared->tangents.data() + std::size_t{4} * vertex;
    const float* p = prepared->positions.data() + std::size_t{3} * vertex;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(p[axis], mesh.positions[3 * mesh.triangles[corner] + axis]);
    }
    const bool right = corner >= 6;
    EXPECT_EQ(t[0], right ? 1.0f : -1.0f);
    // v runs down, so 1 − v is what the algorithm gets: the other orientation.
    EXPECT_EQ(t[3], right ? -1.0f : 1.0f);
  }
  const auto lengths = prepare_tangents(*plain, {.with_lengths = true});
  EXPECT_FLOAT_EQ(lengths->tangents[0], -2.0f);
  EXPECT_FLOAT_EQ(lengths->bitangents[1], 1.0f);  // P_v along v itself
}

TEST(TangentSpace, WithoutCoordinatesOrSurfaceThereAreNone) {
  Primitive primitive;
  primitive.vertex_count = 3;
  primitive.positions = FloatArray({0, 0, 0, 1, 0, 0, 0, 1, 0});
  EXPECT_EQ(prepare_tangents(*prepare(primitive, std::nullopt), {}), nullptr);
  primitive.texcoords[0] = FloatArray({0, 0, 1, 0, 0, 1});
  EXPECT_NE(prepare_tangents(*prepare(primitive, std::nullopt), {}), nullptr);
  primitive.mode = pipeline::PrimitiveMode::lines;
  EXPECT_EQ(prepare_tangents(*prepare(primitive, std::nullopt), {}), nullptr);
}

TEST(TangentSpace, DegenerateTrianglesBorrowAndHugeNumbersDoNoHarm) {
  Mesh mesh = mirrored_squares();
  mesh.triangles.insert(mesh.triangles.end(), {1, 1, 4});
  const std::vector<CornerTangent> tangents = mesh.tangents();
  EXPECT_EQ(tangents[12].tangent, tangents[1].tangent);
  for (float& value : mesh.positions) value *= 1e30f;
  for (float& value : mesh.coordinates) value *= 1e-30f;
  for (const CornerTangent& t : mesh.tangents()) EXPECT_TRUE(std::isfinite(t.tangent.x + t.bitangent.y));
}

}  // namespace
}  // namespace barrido::scene
