#include "models/tool/pictures.h"

#include <cstdlib>

#include <filesystem>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "models/tool/file.h"

namespace barrido::models {
namespace {

constexpr int kSize = 64;

int channel(const Picture& picture, int x, int y, int c) {
  return picture.rgb[static_cast<std::size_t>((y * picture.width + x) * 3 + c)];
}

/// Largest difference between the last and the first column, as neighbours of a repeating picture, and of
/// neighbouring columns inside it.
struct Steps {
  int seam = 0;
  int inside = 0;
};

Steps column_steps(const Picture& picture) {
  Steps steps;
  for (int y = 0; y < picture.height; ++y) {
    for (int c = 0; c < 3; ++c) {
      const auto step = [&](int x0, int x1) {
        return std::abs(channel(picture, x0, y, c) - channel(picture, x1, y, c));
      };
      steps.seam = std::max(steps.seam, step(picture.width - 1, 0));
      for (int x = 0; x + 1 < picture.width; ++x) steps.inside = std::max(steps.inside, step(x, x + 1));
    }
  }
  return steps;
}

TEST(Pictures, MarbleRepeatsWithoutSeam) {
  const Steps steps = column_steps(draw_marble(kSize));
  EXPECT_GT(steps.inside, 0);
  EXPECT_LE(steps.seam, steps.inside);
}

TEST(Pictures, PatchTellsItsCorners) {
  const Picture patch = draw_patch(256);
  const auto at = [&](int x, int y) { return Vec3(channel(patch, x, y, 0), channel(patch, x, y, 1), 0); };
  EXPECT_LT(at(20, 240).x, at(240, 240).x);   // red grows to the right
  EXPECT_LT(at(240, 20).y, at(240, 240).y);   // green grows downwards
  EXPECT_EQ(channel(patch, 48, 48, 2), 255);  // the arrow at the top left
}

/// Neighbouring faces of the sky look at nearly the same direction along their common edge.
TEST(Pictures, SkyFacesMeet) {
  const Picture px = draw_sky(0, kSize);
  const Picture py = draw_sky(2, kSize);
  const Picture pz = draw_sky(4, kSize);
  constexpr int kLast = kSize - 1;
  double x_z = 0.0, y_z = 0.0, y_x = 0.0;
  for (int i = 0; i < kSize; ++i) {
    for (int c = 0; c < 3; ++c) {
      x_z += std::abs(channel(pz, kLast, i, c) - channel(px, 0, i, c));
      y_z += std::abs(channel(py, i, kLast, c) - channel(pz, i, 0, c));
      y_x += std::abs(channel(py, kLast, kLast - i, c) - channel(px, i, 0, c));
    }
  }
  // Mean difference of the bytes; a face turned or mirrored gives 20 and more.
  constexpr double kBytes = 3.0 * kSize;
  EXPECT_LT(x_z / kBytes, 4.0);
  EXPECT_LT(y_z / kBytes, 4.0);
  EXPECT_LT(y_x / kBytes, 4.0);
}

TEST(Pictures, PngKeepsThePixels) {
  for (const Picture& picture : {draw_checker(kSize), draw_marble(kSize)}) {
    const auto path = std::filesystem::path(testing::TempDir()) / "barrido_picture.png";
    const std::vector<std::uint8_t> bytes = encode_small_png(picture);
    write_file(path, bytes);
    EXPECT_EQ(read_png(path).rgb, picture.rgb);
    std::filesystem::remove(path);
  }
}

TEST(Pictures, UnreadablePngNamesItsFile) {
  try {
    read_png("no/such.png");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("no/such.png"), std::string::npos);
  }
}

}  // namespace
}  // namespace barrido::models
