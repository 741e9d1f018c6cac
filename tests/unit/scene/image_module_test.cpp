// Pictures that go through the OpenImageIO module, and that it stays away as long as nobody needs it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "image_test_support.h"

namespace barrido::scene::test {
namespace {

namespace fs = std::filesystem;

bool openimageio_is_mapped() {
  std::ifstream maps("/proc/self/maps");
  const std::string text{std::istreambuf_iterator<char>(maps), {}};
  return text.find("OpenImageIO") != std::string::npos;
}

class ModuleFormats : public testing::Test {
 protected:
  void SetUp() override {
    const Bytes rgba(4);
    if (!module_is_here([&] { encode_image("exr", {1, 1, rgba, {}}); })) {
      GTEST_SKIP() << "built without OpenImageIO";
    }
  }

  Bytes round_trip(const std::string& name, int width, int height, const Bytes& rgba) {
    write_image(folder_ / name, {width, height, rgba, {}});
    const Image image = read_image(folder_ / name);
    EXPECT_EQ(image.width, width);
    EXPECT_EQ(image.height, height);
    return pixels(image);
  }

  FloatImage round_trip(const std::string& name, int width, int height, const std::vector<float>& rgba,
                        const WriteOptions& options = {}) {
    write_image(folder_ / name, {width, height, {}, rgba}, options);
    return read_float_image(folder_ / name);
  }

  TemporaryFolder folder_;
};

/// Straight colours over the maximum and below zero, alpha from 0.25 to 1.
std::vector<float> float_pixels(int count) {
  Noise noise(4);
  std::vector<float> rgba;
  for (int i = 0; i < count; ++i) {
    for (int c = 0; c < 3; ++c) rgba.push_back(static_cast<float>(noise.next() % 4096) / 256.0f - 1.0f);
    rgba.push_back(static_cast<float>(1 + noise.next() % 4) / 4.0f);
  }
  return rgba;
}

TEST(Module, IsNotLoadedForPngAndJpeg) {
  if (openimageio_is_mapped()) GTEST_SKIP() << "another test of this process has loaded it";
  const TemporaryFolder folder;
  const Bytes rgba = noise_rgba(8, 8, true, 1);
  for (const char* name : {"a.png", "a.jpg"}) {
    write_image(folder / name, {8, 8, rgba, {}});
    read_image(folder / name);
    read_float_image(folder / name);
  }
  EXPECT_TRUE(is_writable_format("a.exr"));
  EXPECT_FALSE(openimageio_is_mapped());
}

void write_exr_with_broken_module(const fs::path& folder) {
  ::setenv("BARRIDO_MODULE_PATH", folder.c_str(), 1);
  const Bytes rgba(4);
  try {
    write_image(folder / "a.exr", {1, 1, rgba, {}});
  } catch (const InputError& error) {
    std::cerr << error.what();
    std::exit(fs::exists(folder / "a.exr") ? 4 : 3);
  }
  std::exit(0);
}

TEST(ModuleDeathTest, AModuleThatCannotBeLoadedIsOneClearError) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // a process that has not looked for the module yet
  const TemporaryFolder folder;
  write_bytes(folder / "barrido_oiio.so", Bytes{1, 2, 3});
  EXPECT_EXIT(write_exr_with_broken_module(folder.path()), testing::ExitedWithCode(3),
              "a.exr: writing EXR needs the module barrido_oiio.so, which cannot be loaded: ");
}

TEST_F(ModuleFormats, EightBitFormatsKeepEveryByte) {
  const Bytes opaque = noise_rgba(33, 17, true, 2), transparent = noise_rgba(33, 17, false, 3);
  for (const char* name : {"a.tif", "a.tga", "a.bmp"}) {
    EXPECT_EQ(round_trip(name, 33, 17, opaque), opaque) << name;
  }
  for (const char* name : {"b.tif", "b.tga"}) {
    EXPECT_EQ(round_trip(name, 33, 17, transparent), transparent) << name;
  }
}

TEST_F(ModuleFormats, BmpIsComposedOverBlack) {
  EXPECT_EQ(round_trip("a.bmp", 2, 1, Bytes{200, 100, 50, 128, 9, 8, 7, 255}),
            (Bytes{100, 50, 25, 255, 9, 8, 7, 255}));
}

TEST_F(ModuleFormats, BytesSurviveFloatFormats) {
  const Bytes opaque = noise_rgba(33, 17, true, 2);
  EXPECT_EQ(round_trip("a.exr", 33, 17, opaque), opaque);
  const Bytes hdr = round_trip("a.hdr", 33, 17, opaque);
  // A shared exponent leaves 8 bits to the largest channel and fewer to the others.
  for (std::size_t i = 0; i < hdr.size(); i += 4) {
    const auto largest = std::max_element(opaque.begin() + static_cast<std::ptrdiff_t>(i),
                                          opaque.begin() + static_cast<std::ptrdiff_t>(i + 3)) -
                         opaque.begin();
    ASSERT_NEAR(hdr[static_cast<std::size_t>(largest)], opaque[static_cast<std::size_t>(largest)], 1);
  }
}

TEST_F(ModuleFormats, FloatsSurvive) {
  const std::vector<float> rgba = float_pixels(21 * 9);
  for (const char* name : {"a.exr", "a.tif"}) {
    const FloatImage image = round_trip(name, 21, 9, rgba);
    ASSERT_EQ(image.width, 21);
    ASSERT_EQ(image.height, 9);
    for (std::size_t i = 0; i < rgba.size(); ++i)
      ASSERT_NEAR(image.rgba[i], rgba[i], 2e-6f) << name << " " << i;
  }
}

TEST_F(ModuleFormats, HalfFloatsAreAskedFor) {
  const std::vector<float> rgba{0.1f, 1000.3f, 2.0f, 1.0f};
  WriteOptions options;
  options.half_floats = true;
  const FloatImage half = round_trip("half.exr", 1, 1, rgba, options);
  EXPECT_EQ(half.rgba, (std::vector<float>{0.0999755859375f, 1000.5f, 2.0f, 1.0f}));
  const FloatImage full = round_trip("full.exr", 1, 1, rgba);
  EXPECT_EQ(full.rgba, rgba);
}

TEST_F(ModuleFormats, HdrKeepsValuesOverTheMaximum) {
  const FloatImage image =
      round_trip("a.hdr", 2, 1, std::vector<float>{100.0f, 50.0f, 25.0f, 1.0f, 3.0f, 3.0f, 3.0f, 0.5f});
  EXPECT_NEAR(image.rgba[0], 100.0f, 0.5f);
  EXPECT_NEAR(image.rgba[1], 50.0f, 0.5f);
  EXPECT_NEAR(image.rgba[2], 25.0f, 0.5f);
  EXPECT_NEAR(image.rgba[4], 1.5f, 0.01f) << "composed over black";
  EXPECT_EQ(image.rgba[7], 1.0f);
}

TEST_F(ModuleFormats, FloatsAreClampedAndEncodedAsBytes) {
  write_image(folder_ / "a.exr", {1, 1, {}, std::vector<float>{-1.0f, 0.5f, 7.0f, 1.0f}});
  EXPECT_EQ(pixels(read_image(folder_ / "a.exr")), (Bytes{0, 188, 255, 255}));
}

TEST_F(ModuleFormats, EncodedInMemoryAsInAFile) {
  const Bytes rgba = noise_rgba(16, 16, true, 2);
  for (const std::string extension : {"tif", "hdr", "bmp", "ppm"}) {
    const Bytes encoded = encode_image(extension, {16, 16, rgba, {}});
    write_image(folder_ / ("a." + extension), {16, 16, rgba, {}});
    EXPECT_EQ(encoded, bytes_of_file(folder_ / ("a." + extension))) << extension;
  }
}

TEST_F(ModuleFormats, WebpAndPpmAreWrittenButNotRead) {
  const Bytes rgba = noise_rgba(16, 16, true, 2);
  for (const std::string extension : {"webp", "ppm"}) {
    const fs::path path = folder_ / ("a." + extension);
    write_image(path, {16, 16, rgba, {}});
    EXPECT_GT(fs::file_size(path), 100u);
    EXPECT_EQ(
        message_of([&] { read_image(path); }),
        path.string() + ": not a picture in a format that is read (PNG, JPEG, EXR, HDR, TIFF, BMP, TGA)");
  }
}

TEST_F(ModuleFormats, UnwritableTargetsAreRefusedWithTheSystemsReason) {
  const Bytes rgba(4);
  const fs::path missing = folder_ / "missing" / "a.exr";
  EXPECT_EQ(message_of([&] {
              write_image(missing, {1, 1, rgba, {}});
            }),
            missing.string() + ": cannot be written: No such file or directory");
}

TEST_F(ModuleFormats, TruncatedFilesAreRefused) {
  const Bytes rgba = noise_rgba(64, 64, true, 2);
  for (const std::string extension : {"exr", "hdr", "tif", "bmp", "tga"}) {
    const Bytes whole = encode_image(extension, {64, 64, rgba, {}});
    for (const std::size_t size : {std::size_t{1}, std::size_t{20}, std::size_t{60}, whole.size() / 2}) {
      const fs::path path = folder_ / ("cut." + extension);
      write_bytes(path, std::span(whole).first(size));
      EXPECT_THROW(read_image(path), InputError) << extension << " cut to " << size;
    }
  }
}

TEST_F(ModuleFormats, LimitsAreKept) {
  const Bytes rgba = noise_rgba(64, 64, true, 2);
  for (const std::string extension : {"exr", "hdr", "tif", "bmp", "tga"}) {
    const fs::path path = folder_ / ("a." + extension);
    write_image(path, {64, 64, rgba, {}});
    EXPECT_EQ(message_of([&] {
                read_image(path, {63, 1 << 20});
              }),
              path.string() + ": 64 × 64 pixels: a side may have at most 63");
  }
}

}  // namespace
}  // namespace barrido::scene::test
