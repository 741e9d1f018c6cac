#include "pipeline/scene/normals.h"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "pipeline/scene/triangles.h"

namespace barrido::scene {
namespace {

/// Two squares that share the edge x = 0, the right one bent down by `angle_deg`.
struct Bend {
  std::vector<float> positions;
  std::vector<std::uint32_t> triangles{0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};

  explicit Bend(double angle_deg) {
    const auto c = static_cast<float>(std::cos(angle_deg * M_PI / 180)),
               s = static_cast<float>(std::sin(angle_deg * M_PI / 180));
    positions = {-1, 0, 0, 0, 0, 0, c, 0, -s, -1, 1, 0, 0, 1, 0, c, 1, -s};
  }
};

std::array<float, 3> normal_of(const NormalSplit& split, std::size_t corner) {
  const float* n = split.normals.data() + std::size_t{3} * split.indices[corner];
  return {n[0], n[1], n[2]};
}

TEST(Normals, FlatNormalsGiveEveryTriangleItsOwnVertices) {
  const Bend bend(90);
  const NormalSplit split = flat_normals(bend.positions, bend.triangles);
  EXPECT_EQ(split.source, bend.triangles);
  EXPECT_EQ(normal_of(split, 0), (std::array<float, 3>{0, 0, 1}));
  EXPECT_NEAR(normal_of(split, 6)[0], 1, 1e-6);
}

TEST(Normals, AveragedBelowTheCreaseAngleSplitAbove) {  // S2, S3
  const Bend bend(40);
  const NormalSplit smooth = averaged_normals(bend.positions, bend.triangles, 41);
  EXPECT_EQ(smooth.source.size(), 6u);
  // The three triangles around vertex 1 have areas ½, ½ and ½ (left, right, right).
  const double tilt = std::atan2(2 * std::sin(40 * M_PI / 180), 1 + 2 * std::cos(40 * M_PI / 180));
  EXPECT_NEAR(normal_of(smooth, 1)[0], std::sin(tilt), 1e-6);
  const NormalSplit creased = averaged_normals(bend.positions, bend.triangles, 39);
  EXPECT_EQ(creased.source.size(), 8u);
  EXPECT_EQ(normal_of(creased, 1), (std::array<float, 3>{0, 0, 1}));
}

TEST(Normals, VerticesAtOnePlaceCountAsOnePoint) {
  const Bend bend(30);
  std::vector<float> apart;  // no vertex is shared
  std::vector<std::uint32_t> triangles;
  for (const std::uint32_t vertex : bend.triangles) {
    triangles.push_back(static_cast<std::uint32_t>(triangles.size()));
    for (std::size_t k = 0; k < 3; ++k) apart.push_back(bend.positions[3 * vertex + k]);
  }
  const NormalSplit together = averaged_normals(bend.positions, bend.triangles, 180);
  const NormalSplit split = averaged_normals(apart, triangles, 180);
  for (std::size_t corner = 0; corner < triangles.size(); ++corner) {
    EXPECT_EQ(normal_of(split, corner), normal_of(together, corner)) << corner;
  }
}

TEST(Normals, DegenerateAndBrokenTrianglesDoNoHarm) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<float> positions{0, 0, 0, 1, 0, 0, 2, 0, 0, nan, 1, nan};
  const std::vector<std::uint32_t> triangles{0, 1, 2, 0, 1, 3, 3, 3, 3};
  for (const NormalSplit& split :
       {flat_normals(positions, triangles), averaged_normals(positions, triangles, 60)}) {
    for (std::size_t corner = 0; corner < triangles.size(); ++corner) {
      EXPECT_EQ(normal_of(split, corner), (std::array<float, 3>{0, 0, 1}));
    }
  }
}

TEST(Triangles, StripsAndFansKeepTheirWindingAndTheirLastVertex) {
  using Mode = pipeline::PrimitiveMode;
  using List = std::vector<std::uint32_t>;
  EXPECT_EQ(triangle_list(Mode::triangle_strip, {}, 5), (List{0, 1, 2, 2, 1, 3, 2, 3, 4}));
  EXPECT_EQ(triangle_list(Mode::triangle_fan, {}, 4), (List{0, 1, 2, 0, 2, 3}));
  const List indices{7, 8, 9, 7, 9};
  EXPECT_EQ(triangle_list(Mode::triangles, indices, 10), (List{7, 8, 9}));
  EXPECT_TRUE(triangle_list(Mode::lines, {}, 6).empty());
  EXPECT_TRUE(triangle_list(Mode::triangle_strip, {}, 2).empty());
}

}  // namespace
}  // namespace barrido::scene
