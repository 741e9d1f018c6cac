// What every mesh of the model tool must keep, as functions for the tests.
#pragma once

#include <gtest/gtest.h>

#include "models/tool/mesh.h"

namespace barrido::models {

struct Triangle {
  std::uint32_t a, b, c;
};

inline std::vector<Triangle> triangles_of(const Mesh& mesh) {
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    triangles.push_back({mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
  }
  return triangles;
}

inline Vec3 area_normal(const Mesh& mesh, const Triangle& t) {
  const auto& p = mesh.positions;
  return glm::cross(p[t.b] - p[t.a], p[t.c] - p[t.a]);
}

/// Volume enclosed by a closed mesh; negative when it is wound inside out.
inline double signed_volume(const Mesh& mesh) {
  double volume = 0.0;
  for (const Triangle& t : triangles_of(mesh)) {
    volume += glm::dot(mesh.positions[t.a], area_normal(mesh, t)) / 6.0;
  }
  return volume;
}

/// Counter-clockwise triangles, unit normals on their outer side, and, where there are texture coordinates,
/// pictures that are not mirrored seen from outside.
inline void expect_sound(const Mesh& mesh) {
  ASSERT_EQ(mesh.positions.size(), mesh.normals.size());
  ASSERT_EQ(mesh.positions.size(), mesh.texcoords.size());
  for (const Vec3& normal : mesh.normals) EXPECT_NEAR(length_of(normal), 1.0, 1e-12);
  for (const Triangle& t : triangles_of(mesh)) {
    const Vec3 normal = area_normal(mesh, t);
    EXPECT_GT(length_of(normal), 0.0);
    for (const std::uint32_t v : {t.a, t.b, t.c}) EXPECT_GT(glm::dot(normal, mesh.normals[v]), 0.0);
    const Vec2 ab = mesh.texcoords[t.b] - mesh.texcoords[t.a];
    const Vec2 ac = mesh.texcoords[t.c] - mesh.texcoords[t.a];
    // t runs down: an unmirrored counter-clockwise triangle has a negative area in (s, t).
    EXPECT_LT(ab.x * ac.y - ab.y * ac.x, 0.0);
  }
}

}  // namespace barrido::models
