// Cube maps: what stands beyond an edge of a face must be the texel that touches it on the cube. The oracle
// compares points in space: two texels touch when the middles of their sides coincide.
#include <gtest/gtest.h>

#include <stdexcept>

#include "random_texels.h"
#include "raster/textures/texture.h"

namespace barrido::raster {
namespace {

using testing::byte_texel;
using testing::random_rgba;
using Point = std::array<int, 3>;

constexpr int kSide = 5;

/// The point of `face` at (s, t) in units where a face spans [-kSide, kSide]: OpenGL 1.3, table 3.19, with
/// sc = s, tc = t, |ma| = kSide.
Point on_cube(int face, int s, int t) {
  const Point table[6] = {{kSide, -t, -s}, {-kSide, -t, s}, {s, kSide, t},
                          {s, -kSide, -t}, {s, -t, kSide},  {-s, -t, -kSide}};
  return table[face];
}

struct Texel {
  int face, i, j;
};

int center(int index) { return 2 * index + 1 - kSide; }

/// All texels of other faces that have the middle of one side at `point`.
std::vector<Texel> touching(int face, const Point& point) {
  std::vector<Texel> found;
  for (int other = 0; other < kCubeFaces; ++other) {
    if (other == face) continue;
    for (int k = 0; k < kSide; ++k) {
      if (on_cube(other, center(k), -kSide) == point) found.push_back({other, k, 0});
      if (on_cube(other, center(k), kSide) == point) found.push_back({other, k, kSide - 1});
      if (on_cube(other, -kSide, center(k)) == point) found.push_back({other, 0, k});
      if (on_cube(other, kSide, center(k)) == point) found.push_back({other, kSide - 1, k});
    }
  }
  return found;
}

Texture random_cube(bool seamless, Encoding encoding = Encoding::linear) {
  std::array<std::vector<std::uint8_t>, kCubeFaces> rgba;
  std::array<Pixels8, kCubeFaces> faces;
  for (std::size_t f = 0; f < kCubeFaces; ++f) {
    rgba[f] = random_rgba(kSide, kSide, 100 + f);
    faces[f] = {kSide, kSide, rgba[f]};
  }
  TextureOptions options;
  options.seamless = seamless;
  options.encoding = encoding;
  return Texture::make_cube(faces, options);
}

TEST(CubeTexture, SeamsShowTheNeighbouringFace) {
  for (const Encoding encoding : {Encoding::linear, Encoding::srgb}) {
    const Texture cube = random_cube(true, encoding);
    for (int face = 0; face < kCubeFaces; ++face) {
      for (int k = 0; k < kSide; ++k) {
        const struct {
          int i, j;
          Point middle;
        } sides[] = {{k, -1, on_cube(face, center(k), -kSide)},
                     {k, kSide, on_cube(face, center(k), kSide)},
                     {-1, k, on_cube(face, -kSide, center(k))},
                     {kSide, k, on_cube(face, kSide, center(k))}};
        for (const auto& side : sides) {
          const std::vector<Texel> neighbours = touching(face, side.middle);
          ASSERT_EQ(neighbours.size(), 1u);
          const Texel& n = neighbours[0];
          EXPECT_EQ(cube.texel(0, face, side.i, side.j), cube.texel(0, n.face, n.i, n.j))
              << "face " << face << " at " << side.i << ", " << side.j;
        }
      }
    }
  }
}

TEST(CubeTexture, CornersAreTheMeanOfTheThreeTexelsThatMeetThere) {
  const Texture cube = random_cube(true);
  const int last = kSide - 1;
  for (int face = 0; face < kCubeFaces; ++face) {
    for (const int i : {-1, kSide}) {
      for (const int j : {-1, kSide}) {
        const Point corner = on_cube(face, i < 0 ? -kSide : kSide, j < 0 ? -kSide : kSide);
        std::array<int, 4> sum{};
        int meeting = 0;
        for (int other = 0; other < kCubeFaces; ++other) {
          for (const int x : {0, last}) {
            for (const int y : {0, last}) {
              if (on_cube(other, x == 0 ? -kSide : kSide, y == 0 ? -kSide : kSide) != corner) continue;
              const std::array<int, 4> texel = byte_texel(cube, 0, other, x, y);
              for (std::size_t c = 0; c < 4; ++c) sum[c] += texel[c];
              ++meeting;
            }
          }
        }
        ASSERT_EQ(meeting, 3);
        for (int& channel : sum) channel = (2 * channel + 3) / 6;  // thirds, rounded
        EXPECT_EQ(byte_texel(cube, 0, face, i, j), sum) << "face " << face << " at " << i << ", " << j;
      }
    }
  }
}

TEST(CubeTexture, WithoutSeamlessTheApronRepeatsTheEdge) {
  const Texture cube = random_cube(false);
  for (int face = 0; face < kCubeFaces; ++face) {
    for (int k = 0; k < kSide; ++k) {
      EXPECT_EQ(cube.texel(0, face, k, -1), cube.texel(0, face, k, 0));
      EXPECT_EQ(cube.texel(0, face, kSide, k), cube.texel(0, face, kSide - 1, k));
    }
    EXPECT_EQ(cube.texel(0, face, -1, kSide), cube.texel(0, face, 0, kSide - 1));
  }
}

TEST(CubeTexture, SmallestLevelMeetsItsNeighbours) {
  const Texture cube = random_cube(true);
  ASSERT_EQ(cube.level_count(), 3);
  // Table 3.19: left of +Z lies −X, right of it +X; t runs downwards, so row −1 is towards +Y.
  EXPECT_EQ(cube.texel(2, 4, -1, 0), cube.texel(2, 1, 0, 0));
  EXPECT_EQ(cube.texel(2, 4, 1, 0), cube.texel(2, 0, 0, 0));
  EXPECT_EQ(cube.texel(2, 4, 0, -1), cube.texel(2, 2, 0, 0));
  EXPECT_EQ(cube.texel(2, 4, 0, 1), cube.texel(2, 3, 0, 0));
}

TEST(CubeTexture, FacesMustBeSquaresOfOneSize) {
  const auto square = random_rgba(4, 4, 1);
  const auto oblong = random_rgba(4, 2, 1);
  std::array<Pixels8, kCubeFaces> faces;
  faces.fill({4, 4, square});
  faces[3] = {4, 2, oblong};
  EXPECT_THROW(Texture::make_cube(faces, {}), std::invalid_argument);
}

}  // namespace
}  // namespace barrido::raster
