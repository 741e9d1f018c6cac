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

void append_text(Bytes& out, const std::string& text) {
  out.insert(out.end(), text.begin(), text.end());
  out.push_back(0);
}

void append_u32(Bytes& out, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<std::uint8_t>(value >> shift));
}

/// An EXR header with the attributes that decide how much memory its reader takes, and nothing after it.
Bytes exr_header(std::uint32_t x_max, std::uint32_t y_max, std::uint32_t tile_side,
                 std::uint32_t version = 2) {
  Bytes exr{0x76, 0x2f, 0x31, 0x01};
  append_u32(exr, version);
  append_text(exr, "dataWindow");
  append_text(exr, "box2i");
  append_u32(exr, 16);
  for (const std::uint32_t value : {0u, 0u, x_max, y_max}) append_u32(exr, value);
  if (tile_side != 0) {
    append_text(exr, "tiles");
    append_text(exr, "tiledesc");
    append_u32(exr, 9);
    append_u32(exr, tile_side);
    append_u32(exr, tile_side);
    exr.push_back(0);
  }
  exr.push_back(0);
  return exr;
}

TEST(HostilePictures, ExrHeadersAreCheckedBeforeTheirReaderTakesMemory) {
  const TemporaryFolder folder;
  const fs::path path = folder / "a.exr";
  const auto message = [&path](const Bytes& bytes) {
    write_bytes(path, bytes);
    return message_of([&path] { read_image(path); }).substr(path.string().size());
  };
  EXPECT_EQ(message(exr_header(99, 0x7ffffffe, 0)),
            ": 100 × 2147483647 pixels: a side may have at most 16384");
  EXPECT_EQ(message(exr_header(99, 0x80000000, 0)), ": a picture of 100 × 0 pixels is empty");
  EXPECT_EQ(message(exr_header(8191, 8191, 1)), ": it has too many tiles");
  EXPECT_EQ(message(exr_header(99, 99, 0)).substr(0, 2), ": ");
  Bytes parts = exr_header(99, 99, 0, 0x1002);
  const Bytes second = exr_header(99, 999999, 0);
  parts.insert(parts.end(), second.begin() + 8, second.end());
  EXPECT_EQ(message(parts), ": 100 × 1000000 pixels: a side may have at most 16384");
  const Bytes whole = exr_header(99, 99, 16);
  for (std::size_t size = 4; size + 1 < whole.size(); ++size) {
    EXPECT_EQ(message({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}),
              ": damaged EXR: the header is cut off");
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
