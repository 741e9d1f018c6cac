#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "image_test_support.h"
#include "pipeline/pictures/environment.h"

namespace barrido::scene::test {
namespace {

namespace fs = std::filesystem;

struct Direction {
  double x, y, z;
};

/// Direction of (s, t), both in [−1, 1], on a face: the columns sc, tc and ma of OpenGL 1.3, table 3.19,
/// solved for (rx, ry, rz).
Direction direction_of(std::size_t face, double s, double t) {
  switch (face) {
    case 0:
      return {1, -t, -s};
    case 1:
      return {-1, -t, s};
    case 2:
      return {s, 1, t};
    case 3:
      return {s, -1, -t};
    case 4:
      return {s, -t, 1};
    default:
      return {-s, -t, -1};
  }
}

using Rgba = std::array<std::uint8_t, 4>;

/// A colour for each direction, smooth everywhere.
Rgba color_of(const Direction& d) {
  const double length = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
  const auto byte = [length](double v) {
    return static_cast<std::uint8_t>(128 + std::lround(100 * v / length));
  };
  return {byte(d.x), byte(d.y), byte(d.z), 255};
}

constexpr int kFace = 32;

Bytes paint(int width, int height, const std::function<Rgba(int x, int y)>& color) {
  Bytes rgba;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Rgba pixel = color(x, y);
      rgba.insert(rgba.end(), pixel.begin(), pixel.end());
    }
  }
  return rgba;
}

double coordinate(int i, int size) { return (2.0 * i + 1.0) / size - 1.0; }

Bytes face_picture(std::size_t face) {
  return paint(kFace, kFace, [face](int x, int y) {
    return color_of(direction_of(face, coordinate(x, kFace), coordinate(y, kFace)));
  });
}

/// A cross laid out by a table of faces, -1 where there is none; `turned` is the face that stands on its
/// head.
Bytes cross_picture(int columns, int rows, const std::vector<int>& faces, int turned) {
  return paint(columns * kFace, rows * kFace, [&](int x, int y) -> Rgba {
    const int face = faces[static_cast<std::size_t>(y / kFace * columns + x / kFace)];
    if (face < 0) return {0, 0, 0, 255};
    const int sign = face == turned ? -1 : 1;
    return color_of(direction_of(static_cast<std::size_t>(face), sign * coordinate(x % kFace, kFace),
                                 sign * coordinate(y % kFace, kFace)));
  });
}

Bytes latitude_longitude_picture(int height) {
  return paint(2 * height, height, [height](int x, int y) {
    const double longitude = M_PI * coordinate(x, 2 * height);
    const double latitude = -M_PI / 2 * coordinate(y, height);
    return color_of({std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                     -std::cos(latitude) * std::cos(longitude)});
  });
}

class Environment : public testing::Test {
 protected:
  void write(const std::string& name, int width, int height, const Bytes& rgba) {
    write_image(folder_ / name, {width, height, rgba, {}});
  }
  void write_six(const std::array<const char*, 6>& names) {
    for (std::size_t face = 0; face < 6; ++face) {
      write(names[face] + std::string(".png"), kFace, kFace, face_picture(face));
    }
  }
  /// The largest difference from the picture that `face_picture` paints.
  static int worst_difference(const CubeMapImage& cube) {
    EXPECT_EQ(cube.size, kFace);
    int worst = 0;
    for (std::size_t face = 0; face < 6; ++face) {
      const Bytes expected = face_picture(face);
      EXPECT_EQ(cube.faces_rgba[face].size(), expected.size());
      for (std::size_t i = 0; i < expected.size(); ++i) {
        worst = std::max(worst, std::abs(cube.faces_rgba[face][i] - expected[i]));
      }
    }
    return worst;
  }
  TemporaryFolder folder_;
};

TEST_F(Environment, SixFilesByEveryNaming) {
  const std::vector<std::array<const char*, 6>> namings{{"px", "nx", "py", "ny", "pz", "nz"},
                                                        {"posx", "negx", "posy", "negy", "posz", "negz"},
                                                        {"right", "left", "top", "bottom", "front", "back"}};
  for (const auto& names : namings) {
    const TemporaryFolder folder;
    for (std::size_t face = 0; face < 6; ++face) {
      write_image(folder / (std::string("sky_") + names[face] + ".png"),
                  {kFace, kFace, face_picture(face), {}});
    }
    EXPECT_EQ(worst_difference(read_environment(folder / "sky_{face}.png")), 0);
  }
}

TEST_F(Environment, AFolder) {
  write_six({"px", "nx", "py", "ny", "pz", "nz"});
  EXPECT_EQ(worst_difference(read_environment(folder_.path())), 0);
}

TEST_F(Environment, CrossesGiveTheSameFaces) {
  write("horizontal.png", 4 * kFace, 3 * kFace,
        cross_picture(4, 3, {-1, 2, -1, -1, 1, 4, 0, 5, -1, 3, -1, -1}, -1));
  write("vertical.png", 3 * kFace, 4 * kFace,
        cross_picture(3, 4, {-1, 2, -1, 1, 4, 0, -1, 3, -1, -1, 5, -1}, 5));
  EXPECT_EQ(worst_difference(read_environment(folder_ / "horizontal.png")), 0);
  EXPECT_EQ(worst_difference(read_environment(folder_ / "vertical.png")), 0);
}

TEST_F(Environment, LatitudeLongitudeGivesTheSameFaces) {
  write("panorama.png", 4 * kFace, 2 * kFace, latitude_longitude_picture(2 * kFace));
  EXPECT_LE(worst_difference(read_environment(folder_ / "panorama.png")), 2);
  EXPECT_LE(worst_difference(read_environment(folder_ / "panorama.png", 0.0f, false)), 1);
}

/// Six colours, so that a wrong place of the middle or a mirrored picture shows.
TEST_F(Environment, MiddleOfEachFaceLooksAlongItsAxis) {
  const auto place = [](int x, int y) -> Rgba {     // of 64 × 32 pixels
    if (y < 8) return {255, 255, 0, 255};           // up
    if (y >= 24) return {0, 255, 255, 255};         // down
    if (x < 8 || x >= 56) return {0, 0, 255, 255};  // behind the middle: +Z
    if (x < 24) return {0, 255, 0, 255};            // left: −X
    if (x < 40) return {255, 255, 255, 255};        // middle: −Z
    return {255, 0, 0, 255};                        // right: +X
  };
  write("panorama.png", 64, 32, paint(64, 32, place));
  const CubeMapImage cube = read_environment(folder_ / "panorama.png");
  ASSERT_EQ(cube.size, 16);
  const std::array<Rgba, 6> expected{{{255, 0, 0, 255},
                                      {0, 255, 0, 255},
                                      {255, 255, 0, 255},
                                      {0, 255, 255, 255},
                                      {0, 0, 255, 255},
                                      {255, 255, 255, 255}}};
  for (std::size_t face = 0; face < 6; ++face) {
    const std::uint8_t* middle = cube.faces_rgba[face].data() + (8 * 16 + 8) * 4;
    EXPECT_EQ((Rgba{middle[0], middle[1], middle[2], middle[3]}), expected[face]) << "face " << face;
  }
}

/// Along each edge of the cube the texels of the two faces nearly agree: no seam behind the middle or at the
/// poles.
TEST_F(Environment, FacesMeetAtTheirEdges) {
  Bytes picture = latitude_longitude_picture(128);
  write("panorama.png", 256, 128, picture);
  const CubeMapImage cube = read_environment(folder_ / "panorama.png");
  const int n = cube.size;
  for (std::size_t face = 0; face < 6; ++face) {
    for (int i = 0; i < n; ++i) {
      for (const auto& [x, y] : {std::pair{0, i}, {n - 1, i}, {i, 0}, {i, n - 1}}) {
        const Rgba expected = color_of(direction_of(face, coordinate(x, n), coordinate(y, n)));
        const std::uint8_t* texel = cube.faces_rgba[face].data() + (y * n + x) * 4;
        for (std::size_t c = 0; c < 3; ++c)
          ASSERT_NEAR(texel[c], expected[c], 2) << face << ": " << x << ", " << y;
      }
    }
  }
}

/// A panorama of noise turned by a quarter gives the same faces, each a quarter further on; what goes wrong
/// at the picture's edges or poles goes wrong in another place of the turned one.
TEST_F(Environment, NoSeamWhereThePictureEnds) {
  const int height = 34, width = 68;  // odd faces: their middle columns lie on the picture's edge
  const Bytes noise = noise_rgba(width, height, true, 6);
  const Bytes turned = paint(width, height, [&](int x, int y) -> Rgba {
    const std::uint8_t* from = noise.data() + (y * width + (x + width / 4) % width) * 4;
    return {from[0], from[1], from[2], from[3]};
  });
  write("a.png", width, height, noise);
  write("b.png", width, height, turned);
  const CubeMapImage a = read_environment(folder_ / "a.png"), b = read_environment(folder_ / "b.png");
  const int n = a.size;
  const auto texel = [n](const CubeMapImage& cube, std::size_t face, int x, int y, std::size_t c) {
    return cube.faces_rgba[face][static_cast<std::size_t>(y * n + x) * 4 + c];
  };
  // What stood to the right, +X, now stands in the middle, −Z, and so on.
  const std::array<std::size_t, 6> from{4, 5, 2, 3, 1, 0};
  for (std::size_t face = 0; face < 6; ++face) {
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        const int u = face == 2 ? n - 1 - y : face == 3 ? y : x;
        const int v = face == 2 ? x : face == 3 ? n - 1 - x : y;
        const bool pole = (face == 2 || face == 3) && x == n / 2 && y == n / 2;  // has no direction to turn
        for (std::size_t c = 0; c < 3 && !pole; ++c) {
          ASSERT_NEAR(texel(b, face, x, y, c), texel(a, from[face], u, v, c), 1)
              << "face " << face << ": " << x << ", " << y;
        }
      }
    }
  }
}

TEST_F(Environment, PolesAreTheMeanOfOppositeLongitudes) {
  const Bytes four{0, 0, 0, 255, 40, 0, 0, 255, 80, 0, 0, 255, 200, 0, 0, 255};
  Bytes rgba = four;
  for (std::size_t i = 0; i < four.size(); ++i) rgba.push_back(i % 4 == 3 ? 255 : four[i] / 2);
  write("a.png", 4, 2, rgba);
  const CubeMapImage cube = read_environment(folder_ / "a.png", 0.0f, false);
  ASSERT_EQ(cube.size, 1);
  EXPECT_EQ(cube.faces_rgba[2][0], 80);
  EXPECT_EQ(cube.faces_rgba[3][0], 40);
}

TEST_F(Environment, BytesOfAUniformPanoramaPassUnchanged) {
  for (const bool srgb : {true, false}) {
    for (int value = 0; value < 256; ++value) {
      const auto byte = static_cast<std::uint8_t>(value);
      write("uniform.png", 2, 1, {byte, byte, byte, 255, byte, byte, byte, 255});
      const CubeMapImage cube = read_environment(folder_ / "uniform.png", 5.0f, srgb);
      ASSERT_EQ(cube.size, 1);
      for (const auto& face : cube.faces_rgba) ASSERT_EQ(face, (Bytes{byte, byte, byte, 255})) << srgb;
    }
  }
}

TEST_F(Environment, HighRangeIsExposedClampedAndEncoded) {
  std::vector<float> floats;
  for (int i = 0; i < 8; ++i) floats.insert(floats.end(), {0.125f, 0.5f, 40.0f, 1.0f});
  const fs::path path = folder_ / "high.exr";
  if (!module_is_here([&] { write_image(path, {4, 2, {}, floats}); }))
    GTEST_SKIP() << "built without OpenImageIO";
  const auto first_texel = [&](float exposure_ev, bool srgb) {
    const CubeMapImage cube = read_environment(path, exposure_ev, srgb);
    return Bytes(cube.faces_rgba[0].begin(), cube.faces_rgba[0].begin() + 4);
  };
  EXPECT_EQ(first_texel(0.0f, false), (Bytes{32, 128, 255, 255}));
  EXPECT_EQ(first_texel(0.0f, true), (Bytes{99, 188, 255, 255}));
  EXPECT_EQ(first_texel(2.0f, false), (Bytes{128, 255, 255, 255}));
  EXPECT_EQ(first_texel(-1.0f, true), (Bytes{71, 137, 255, 255}));

  std::vector<float> cross;
  for (int i = 0; i < 12; ++i) cross.insert(cross.end(), {0.125f, 0.5f, 40.0f, 1.0f});
  write_image(path, {4, 3, {}, cross});
  EXPECT_EQ(first_texel(-1.0f, true), (Bytes{71, 137, 255, 255}));
  EXPECT_EQ(first_texel(2.0f, false), (Bytes{128, 255, 255, 255}));
}

TEST_F(Environment, BadInputIsOneClearMessage) {
  write("odd.png", 10, 7, noise_rgba(10, 7, true, 1));
  EXPECT_EQ(message_of([&] { read_environment(folder_ / "odd.png"); }),
            (folder_ / "odd.png").string() +
                ": 10 × 7 pixels are neither a cross (4:3 or 3:4) nor latitude-longitude (2:1)");
  EXPECT_EQ(message_of([&] { read_environment(folder_ / "no.hdr"); }),
            (folder_ / "no.hdr").string() + ": no such file");
  EXPECT_EQ(message_of([&] { read_environment(folder_ / "sky_{face}.png"); }),
            (folder_ / "sky_{face}.png").string() + ": no file with px, posx or right in place of {face}");
  EXPECT_EQ(
      message_of([&] { read_environment(folder_.path()); }),
      folder_.path().string() + ": the folder holds no px, posx or right (.png .jpg .exr .hdr .tif .tga)");

  write("px.png", 4, 4, noise_rgba(4, 4, true, 1));
  EXPECT_EQ(message_of([&] { read_environment(folder_.path()); }),
            (folder_ / "nx.png").string() + ": no such file");
  write("nx.png", 4, 3, noise_rgba(4, 3, true, 1));
  EXPECT_EQ(message_of([&] { read_environment(folder_.path()); }),
            (folder_ / "nx.png").string() + ": 4 × 3 pixels: a face of a cube map must be square");
  write("nx.png", 5, 5, noise_rgba(5, 5, true, 1));
  EXPECT_EQ(message_of([&] { read_environment(folder_.path()); }),
            (folder_ / "nx.png").string() + ": 5 × 5 pixels, but " + (folder_ / "px.png").string() +
                " has 4 a side: the six faces must be of one size");
}

}  // namespace
}  // namespace barrido::scene::test
