#include <gtest/gtest.h>

#include "image_test_support.h"
#include "pipeline/files/write_file.h"

namespace barrido::scene::test {
namespace {

namespace fs = std::filesystem;

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(WriteImage, PngAndJpegByExtension) {
  const TemporaryFolder folder;
  const Bytes rgba = noise_rgba(20, 10, true, 1);
  write_image(folder / "a.png", {20, 10, rgba, {}});
  write_image(folder / "B.JPG", {20, 10, rgba, {}});
  EXPECT_EQ(pixels(read_image(folder / "a.png")), rgba);
  EXPECT_EQ(bytes_of_file(folder / "a.png"), encode_png({20, 10, rgba, {}}));
  EXPECT_EQ(bytes_of_file(folder / "B.JPG"), encode_jpeg({20, 10, rgba, {}}));
  EXPECT_EQ(encode_image("png", {20, 10, rgba, {}}), encode_png({20, 10, rgba, {}}));
  EXPECT_EQ(encode_image(".jpg", {20, 10, rgba, {}}), encode_jpeg({20, 10, rgba, {}}));
  EXPECT_EQ(files_in(folder.path()), 2u);
}

TEST(WriteImage, FormatsAreKnownByTheirNames) {
  for (const char* name : {"a.png", "a.jpg", "a.JPEG", "a.exr", "a.hdr", "a.tif", "a.tga", "a.bmp"}) {
    EXPECT_TRUE(is_writable_format(name)) << name;
  }
  for (const char* name : {"a", "png", "a.gif", "a.png.txt", ""})
    EXPECT_FALSE(is_writable_format(name)) << name;
  const Bytes rgba(4);
  EXPECT_EQ(message_of([&] {
              write_image("a.gif", {1, 1, rgba, {}});
            }),
            "a.gif: '.gif' is no format that can be written (png jpg exr hdr tif webp bmp tga ppm)");
  EXPECT_EQ(message_of([&] {
              write_image("frame", {1, 1, rgba, {}});
            }),
            "frame: a name without extension says no format (png jpg exr hdr tif webp bmp tga ppm)");
}

TEST(WriteImage, UnwritableTargetsAreRefusedWithTheSystemsReason) {
  const TemporaryFolder folder;
  const Bytes rgba(4);
  const auto message = [&](const fs::path& path) {
    return message_of([&] { write_image(path, {1, 1, rgba, {}}); });
  };
  const fs::path missing = folder / "missing" / "a.png";
  EXPECT_EQ(message(missing), missing.string() + ": cannot be written: No such file or directory");
  fs::create_directory(folder / "folder.png");
  EXPECT_EQ(message(folder / "folder.png"),
            (folder / "folder.png").string() + ": cannot be written: Is a directory");
  write_bytes(folder / "file", rgba);
  EXPECT_EQ(message(folder / "file" / "a.png"),
            (folder / "file" / "a.png").string() + ": cannot be written: Not a directory");
  EXPECT_EQ(files_in(folder.path()), 2u) << "something was left behind";
}

TEST(WriteImage, DevicesAreWrittenToNotReplaced) {
  if (!fs::is_character_file("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const TemporaryFolder folder;
  const Bytes rgba(4);
  fs::create_symlink("/dev/full", folder / "full.png");
  EXPECT_EQ(message_of([&] {
              write_image(folder / "full.png", {1, 1, rgba, {}});
            }),
            (folder / "full.png").string() + ": cannot be written: No space left on device");
  fs::create_symlink("/dev/null", folder / "null.png");
  EXPECT_NO_THROW(write_image(folder / "null.png", {1, 1, rgba, {}}));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(files_in(folder.path()), 2u);
}

TEST(WriteImage, AFailureLeavesTheOldFile) {
  const TemporaryFolder folder;
  const Bytes wide(std::size_t{70000} * 4);  // JPEG ends at 65500
  const Bytes old{1, 2, 3};
  write_bytes(folder / "a.jpg", old);
  EXPECT_THROW(write_image(folder / "a.jpg", {70000, 1, wide, {}}), InputError);
  EXPECT_EQ(bytes_of_file(folder / "a.jpg"), old);
  EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST(WriteAtomically, AWriterThatFailsLeavesNothing) {
  const TemporaryFolder folder;
  fs::path seen;
  const auto fail = [&seen](const fs::path& file) {
    seen = file;
    write_bytes(file, Bytes{1, 2, 3});
    throw InputError("x", "", "failed half-way");
  };
  EXPECT_EQ(message_of([&] { write_atomically(folder / "a.exr", fail); }), "x: failed half-way");
  EXPECT_EQ(seen.parent_path(), folder.path()) << "a file elsewhere could not be renamed";
  EXPECT_EQ(files_in(folder.path()), 0u);
}

TEST(WriteAtomically, TheNameAppearsWhenAllIsWritten) {
  const TemporaryFolder folder;
  write_atomically(folder / "a", [&](const fs::path& file) {
    write_bytes(file, Bytes{1, 2, 3});
    EXPECT_FALSE(fs::exists(folder / "a"));
  });
  EXPECT_EQ(bytes_of_file(folder / "a"), (Bytes{1, 2, 3}));
  EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST(WriteImage, ASymbolicLinkStaysOne) {
  const TemporaryFolder folder;
  const Bytes rgba = noise_rgba(2, 2, true, 1);
  write_bytes(folder / "target.png", Bytes{1});
  fs::create_symlink("target.png", folder / "link.png");
  write_image(folder / "link.png", {2, 2, rgba, {}});
  EXPECT_TRUE(fs::is_symlink(folder / "link.png"));
  EXPECT_EQ(pixels(read_image(folder / "target.png")), rgba);
}

TEST(WriteImage, LongNamesAreFine) {
  const TemporaryFolder folder;
  const Bytes rgba(4);
  const fs::path path = folder / (std::string(251, 'n') + ".png");
  write_image(path, {1, 1, rgba, {}});
  EXPECT_TRUE(fs::exists(path));
}

TEST(WriteImage, FloatsWithoutBytesAreEncoded) {
  const std::vector<float> floats{0.0f, 0.2140411f, 2.0f, 0.5f};
  const Image image = decode_image(encode_png({1, 1, {}, floats}), "x.png");
  EXPECT_EQ(pixels(image), (Bytes{0, 127, 255, 128}));  // sRGB of 0.214 is 0.5: 127.5, just below
}

TEST(ReadImage, MissingFilesAndFolders) {
  const TemporaryFolder folder;
  EXPECT_EQ(message_of([&] { read_image(folder / "no.png"); }),
            (folder / "no.png").string() + ": no such file");
  EXPECT_EQ(message_of([&] { read_image(folder.path()); }),
            folder.path().string() + ": is a folder, not a file");
}

TEST(ReadImage, ContentDecidesNotTheName) {
  const TemporaryFolder folder;
  const Bytes rgba = noise_rgba(3, 3, true, 1);
  write_bytes(folder / "a.exr", encode_png({3, 3, rgba, {}}));
  EXPECT_EQ(pixels(read_image(folder / "a.exr")), rgba);
}

TEST(ReadFloatImage, BytesAreDecodedFromSrgb) {
  const TemporaryFolder folder;
  const Bytes rgba{0, 188, 255, 51};
  write_image(folder / "a.png", {1, 1, rgba, {}});
  const FloatImage image = read_float_image(folder / "a.png");
  ASSERT_EQ(image.rgba.size(), 4u);
  EXPECT_FLOAT_EQ(image.rgba[0], 0.0f);
  EXPECT_NEAR(image.rgba[1], 0.5028865f, 1e-5f);
  EXPECT_FLOAT_EQ(image.rgba[2], 1.0f);
  EXPECT_FLOAT_EQ(image.rgba[3], 0.2f);
}

}  // namespace
}  // namespace barrido::scene::test
