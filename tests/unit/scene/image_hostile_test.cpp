// Files made to do harm: each is refused in one line, or read within the limits.
#include <gtest/gtest.h>

#include "image_test_support.h"

namespace barrido::scene::test {
namespace {

namespace fs = std::filesystem;

const fs::path kHostileFolder = fs::path(BARRIDO_SOURCE_DIR) / "../shared/assets/hostile";

std::vector<fs::path> hostile_pictures() {
  std::vector<fs::path> paths;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(kHostileFolder, error)) {
    if (entry.path().filename().string().starts_with("img_")) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

TEST(HostilePictures, AreRefusedInOneLine) {
  const auto paths = hostile_pictures();
  if (paths.empty()) GTEST_SKIP() << kHostileFolder << " is not here";
  for (const fs::path& path : paths) {
    for (const std::string& message :
         {message_of([&] { read_image(path); }), message_of([&] { read_float_image(path); })}) {
      EXPECT_TRUE(message.starts_with(path.string() + ": ")) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }
}

/// Small pictures in every format, with a few bytes changed, thousands of times.
TEST(HostilePictures, DamagedFilesOfTheModuleNeverCrash) {
  const Bytes rgba = noise_rgba(24, 24, true, 2);
  if (!module_is_here([&] { encode_image("exr", {1, 1, Bytes(4), {}}); })) {
    GTEST_SKIP() << "built without OpenImageIO";
  }
  const TemporaryFolder folder;
  Noise noise(7);
  for (const std::string extension : {"exr", "hdr", "tif", "bmp", "tga"}) {
    const Bytes original = encode_image(extension, {24, 24, rgba, {}});
    for (int round = 0; round < 300; ++round) {
      Bytes damaged = original;
      // Headers decide most, so that they are hit most.
      const std::size_t range =
          round % 2 == 0 ? std::min<std::size_t>(original.size(), 400) : original.size();
      for (int i = 0; i < 3; ++i) damaged[noise.next() % range] = noise.byte();
      const fs::path path = folder / ("damaged." + extension);
      write_bytes(path, damaged);
      try {
        const Image image = read_image(path, {1024, 1 << 20});
        EXPECT_EQ(image.rgba.size(),
                  static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4);
      } catch (const InputError&) {
      }
    }
  }
}

}  // namespace
}  // namespace barrido::scene::test
