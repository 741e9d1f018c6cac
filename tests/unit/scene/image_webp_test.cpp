// WebP and KTX2: pictures are written here, by libwebp's encoder or by hand, and read back.
#include <algorithm>

#include "image_test_support.h"

#ifdef BARRIDO_TEST_WEBP
#include <webp/encode.h>
#endif

namespace barrido::scene::test {
namespace {

Bytes ktx2(std::uint32_t format, std::uint32_t width, std::uint32_t height, const Bytes& level,
           std::uint32_t scheme = 0) {
  Bytes file{0xab, 'K', 'T', 'X', ' ', '2', '0', 0xbb, 0x0d, 0x0a, 0x1a, 0x0a};
  const auto put = [&](std::uint64_t value, int size) {
    for (int i = 0; i < size; ++i) file.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  };
  for (const std::uint32_t word : {format, 1u, width, height, 0u, 0u, 1u, 1u, scheme}) put(word, 4);
  for (int i = 0; i < 4; ++i) put(0, 4);
  put(0, 8);
  put(0, 8);
  put(104, 8);
  put(level.size(), 8);
  put(level.size(), 8);
  file.insert(file.end(), level.begin(), level.end());
  return file;
}

TEST(Ktx2, PlainPicturesAreRead) {
  const Bytes rgba = noise_rgba(5, 3, false, 1);
  EXPECT_EQ(pixels(decode_image(ktx2(43, 5, 3, rgba), "a")), rgba);
  EXPECT_EQ(pixels(decode_image(ktx2(23, 1, 2, {1, 2, 3, 4, 5, 6}), "a")),
            (Bytes{1, 2, 3, 255, 4, 5, 6, 255}));
  EXPECT_EQ(pixels(decode_image(ktx2(50, 1, 1, {1, 2, 3, 4}), "a")), (Bytes{3, 2, 1, 4}));
}

TEST(Ktx2, EverythingElseIsRefused) {
  const auto error = [](const Bytes& file) { return message_of([&] { decode_image(file, "a"); }); };
  const Bytes level(16);
  EXPECT_EQ(error(ktx2(0, 2, 2, level, 1)),
            "a: KTX2 compressed for Basis Universal (BasisLZ or UASTC) is not read");
  EXPECT_EQ(error(ktx2(43, 2, 2, level, 2)), "a: of KTX2, only 8 bits a channel without compression is read");
  EXPECT_EQ(error(ktx2(43, 3, 2, level)), "a: damaged KTX2: its pixels are cut off");
  EXPECT_EQ(error(ktx2(43, 100000, 100000, level)),
            "a: 100000 × 100000 pixels: a side may have at most 16384");
  Bytes whole = ktx2(43, 2, 2, level);
  for (std::size_t size = 12; size < whole.size(); ++size) {
    EXPECT_NE(error(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size))).find("damaged"),
              std::string::npos);
  }
  std::fill(whole.begin() + 80, whole.begin() + 96, 0xff);  // Where its level lies, and how long
  EXPECT_EQ(error(whole), "a: damaged KTX2: its pixels are cut off");
}

#ifdef BARRIDO_TEST_WEBP
Bytes lossless(const Bytes& rgba, int width, int height) {
  std::uint8_t* data = nullptr;
  const std::size_t size = WebPEncodeLosslessRGBA(rgba.data(), width, height, width * 4, &data);
  const Bytes file(data, data + size);
  WebPFree(data);
  return file;
}

TEST(Webp, KeepsEveryByteWithoutLoss) {
  Bytes rgba = noise_rgba(33, 17, false, 5);
  for (std::size_t i = 3; i < rgba.size(); i += 4) rgba[i] |= 1;  // The encoder clears what alpha 0 hides.
  EXPECT_EQ(pixels(decode_image(lossless(rgba, 33, 17), "a")), rgba);
}

TEST(Webp, CutOffAnywhereIsRefused) {
  const Bytes file = lossless(noise_rgba(20, 20, true, 6), 20, 20);
  for (std::size_t size = 12; size < file.size(); size += 7) {
    const std::string error = message_of([&] { decode_image(std::span(file).first(size), "a"); });
    EXPECT_TRUE(error.starts_with("a: damaged WebP: ")) << size << ": " << error;
  }
}

TEST(Webp, SizesAreCheckedBeforeMemoryIsTaken) {
  Bytes file = lossless(noise_rgba(20, 20, true, 6), 20, 20);
  file[21] = file[22] = file[23] = 0xff;  // Width and height of VP8L, 14 bits each, behind its signature
  EXPECT_EQ(message_of([&] {
              decode_image(file, "a", {.max_side = 16384, .max_pixels = 1 << 20});
            }).find("pixels: a picture may have at most 1048576") != std::string::npos,
            true);
}
#endif

}  // namespace
}  // namespace barrido::scene::test
