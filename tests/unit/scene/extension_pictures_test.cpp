// Files with extensions that users meet, as drawn and looked at beside the pictures of those who made them:
// each is drawn, with no warning but those of its own, and the means of its parts are those of the picture
// that was looked at.
#include <cstdlib>
#include <sstream>

#include "import_support.h"
#include "pipeline/scene/render_scene.h"

namespace barrido::scene::test {
namespace {

namespace fs = std::filesystem;

constexpr int kColumns = 8, kRows = 6, kPart = 20;

/// Mean red, green and blue of each part of the frame, left to right and from the top.
std::vector<int> means(const raster::Framebuffer& frame) {
  std::vector<int> sums(kColumns * kRows * 3);
  for (int y = 0; y < kRows * kPart; ++y) {
    for (int x = 0; x < kColumns * kPart; ++x) {
      const std::uint32_t pixel = frame.color8()[static_cast<std::size_t>(y * kColumns * kPart + x)];
      for (int c = 0; c < 3; ++c) {
        sums[static_cast<std::size_t>((y / kPart * kColumns + x / kPart) * 3 + c)] +=
            static_cast<int>(pixel >> (8 * c) & 255);
      }
    }
  }
  for (int& sum : sums) sum /= kPart * kPart;
  return sums;
}

std::vector<int> drawn(const fs::path& file) {
  const Scene scene = import_gltf(file);
  RenderSettings settings;
  settings.width = kColumns * kPart;
  settings.height = kRows * kPart;
  SceneRenderer renderer(scene);
  return means(renderer.render(settings));
}

/// Lines of a file's name and its numbers. With BARRIDO_BLESS_EXTENSIONS set they are written anew, to be
/// looked at.
TEST(ExtensionPictures, AreAsTheyWereLookedAt) {
  const fs::path folder = assets_folder() / "extensions";
  if (!fs::exists(folder)) GTEST_SKIP() << "needs the test assets in " << assets_folder();
  const fs::path list = fs::path(BARRIDO_SOURCE_DIR) / "tests/unit/scene/extension_pictures.txt";
  const bool bless = std::getenv("BARRIDO_BLESS_EXTENSIONS") != nullptr;
  std::ifstream lines(list);
  std::ostringstream blessed;
  std::string line;
  int files = 0;
  while (std::getline(lines, line)) {
    std::istringstream numbers(line);
    std::string name;
    numbers >> name;
    SCOPED_TRACE(name);
    ++files;
    try {
      const std::vector<int> seen = drawn(folder / name);
      blessed << name;
      for (const int mean : seen) blessed << ' ' << mean;
      blessed << '\n';
      for (std::size_t i = 0; i < seen.size() && !bless; ++i) {
        int wanted = -1;
        numbers >> wanted;
        ASSERT_NEAR(seen[i], wanted, 3) << "part " << i / 3 << ", channel " << i % 3;
      }
    } catch (const InputError& error) {
      ADD_FAILURE() << error.what();
    }
  }
  EXPECT_EQ(files, 16);
  if (bless) std::ofstream(list) << blessed.str();
}

}  // namespace
}  // namespace barrido::scene::test
