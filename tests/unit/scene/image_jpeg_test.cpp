#include <algorithm>
#include <cstdlib>

#include "image_test_support.h"
#include "pipeline/files/bytes.h"

namespace barrido::scene::test {
namespace {

// Pictures of 16 × 8 pixels, left half and right half of one colour each, written by libjpeg-turbo.
constexpr const char* kGrey =  // grey 40 and 200
    "/9j/2wBDAAIBAQEBAQIBAQECAgICAgQDAgICAgUEBAMEBgUGBgYFBgYGBwkIBgcJBwYGCAsICQoKCgoKBggLDAsKDAkKCgr/"
    "wAALCAAIABABAREA/8QAFQABAQAAAAAAAAAAAAAAAAAACQr/xAAUEAEAAAAAAAAAAAAAAAAAAAAA/9oACAEBAAA/ACfVAP/Z";

constexpr const char* kRgb =  // (200, 100, 50) and (30, 60, 220)
    "/9j/2wBDAAIBAQEBAQIBAQECAgICAgQDAgICAgUEBAMEBgUGBgYFBgYGBwkIBgcJBwYGCAsICQoKCgoKBggLDAsKDAkKCgr/"
    "2wBDAQICAgICAgUDAwUKBwYHCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgr/wAAR"
    "CAAIABADAREAAhEBAxEB/8QAFQABAQAAAAAAAAAAAAAAAAAABQj/xAAUEAEAAAAAAAAAAAAAAAAAAAAA/8QAFQEBAQAAAAAA"
    "AAAAAAAAAAAACAn/xAAUEQEAAAAAAAAAAAAAAAAAAAAA/9oADAMBAAIRAxEAPwA8VzYRGv4lu//Z";

constexpr const char* kProgressive =  // the same, in many scans
    "/9j/2wBDAAIBAQEBAQIBAQECAgICAgQDAgICAgUEBAMEBgUGBgYFBgYGBwkIBgcJBwYGCAsICQoKCgoKBggLDAsKDAkKCgr/"
    "2wBDAQICAgICAgUDAwUKBwYHCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgr/wgAR"
    "CAAIABADAREAAhEBAxEB/8QAFQABAQAAAAAAAAAAAAAAAAAABAf/xAAVAQEBAAAAAAAAAAAAAAAAAAAHCP/aAAwDAQACEAMQ"
    "AAABOVtkRv6W/wD/xAAUEAEAAAAAAAAAAAAAAAAAAAAQ/9oACAEBAAEFAj//xAAUEQEAAAAAAAAAAAAAAAAAAAAQ/9oACAED"
    "AQE/AT//xAAUEQEAAAAAAAAAAAAAAAAAAAAQ/9oACAECAQE/AT//xAAUEAEAAAAAAAAAAAAAAAAAAAAQ/9oACAEBAAY/Aj//"
    "xAAUEAEAAAAAAAAAAAAAAAAAAAAQ/9oACAEBAAE/IT//2gAMAwEAAgADAAAAEAP/xAAUEQEAAAAAAAAAAAAAAAAAAAAQ/9oA"
    "CAEDAQE/ED//xAAUEQEAAAAAAAAAAAAAAAAAAAAQ/9oACAECAQE/ED//xAAUEAEAAAAAAAAAAAAAAAAAAAAQ/9oACAEBAAE/"
    "ED//2Q==";

constexpr const char*
    kCmykAdobe =  // inks (0.2, 0.6, 0.8, 0.2) and (0.8, 0.4, 0, 0), upside down as Adobe has it
    "/9j/7gAOQWRvYmUAZAAAAAAA/9sAQwACAQEBAQECAQEBAgICAgIEAwICAgIFBAQDBAYFBgYGBQYGBgcJCAYHCQcGBggLCAkK"
    "CgoKCgYICwwLCgwJCgoK/8AAFAgACAAQBEMRAE0RAFkRAEsRAP/EABcAAAMBAAAAAAAAAAAAAAAAAAgJCgf/xAAUEAEAAAAA"
    "AAAAAAAAAAAAAAAA/9oADgRDAE0AWQBLAAA/AGYMXLLMwTNjMWYDMf/Z";

constexpr const char* kCmykPlain =  // the same inks, as they are
    "/9j/2wBDAAIBAQEBAQIBAQECAgICAgQDAgICAgUEBAMEBgUGBgYFBgYGBwkIBgcJBwYGCAsICQoKCgoKBggLDAsKDAkKCgr/"
    "wAAUCAAIABAEQxEATREAWREASxEA/8QAFwAAAwEAAAAAAAAAAAAAAAAACAkKB//EABQQAQAAAAAAAAAAAAAAAAAAAAD/2gAO"
    "BEMATQBZAEsAAD8AWW2QzAstTIDNGeDN/9k=";

constexpr const char* kYcck =  // the same inks, upside down and as YCCK
    "/9j/7gAOQWRvYmUAZAAAAAAC/9sAQwACAQEBAQECAQEBAgICAgIEAwICAgIFBAQDBAYFBgYGBQYGBgcJCAYHCQcGBggLCAkK"
    "CgoKCgYICwwLCgwJCgoK/9sAQwECAgICAgIFAwMFCgcGBwoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoK"
    "CgoKCgoKCgoKCgoK/8AAFAgACAAQBAERAAIRAQMRAQQRAP/EABcAAAMBAAAAAAAAAAAAAAAAAAAFCAn/xAAUEAEAAAAAAAAA"
    "AAAAAAAAAAAA/8QAFQEBAQAAAAAAAAAAAAAAAAAACAn/xAAUEQEAAAAAAAAAAAAAAAAAAAAA/9oADgQBAAIRAxEEAAA/AArA"
    "jaYEaIa5CzH/2Q==";

Bytes decoded_base64(const char* text) {
  const auto content = gltf::decode_data_uri(std::string("data:image/jpeg;base64,") + text);
  return {content.block.bytes().begin(), content.block.bytes().end()};
}

/// Within what the quantisation of quality 95 may change.
void expect_halves(const char* base64, const Bytes& left, const Bytes& right) {
  const Image image = decode_image(decoded_base64(base64), "x.jpg");
  ASSERT_EQ(image.width, 16);
  ASSERT_EQ(image.height, 8);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    const Bytes& expected = i / 4 % 16 < 8 ? left : right;
    ASSERT_NEAR(image.rgba[i], expected[i % 4], 3) << "byte " << i;
  }
}

TEST(DecodeJpeg, Grey) { expect_halves(kGrey, {40, 40, 40, 255}, {200, 200, 200, 255}); }
TEST(DecodeJpeg, Color) { expect_halves(kRgb, {200, 100, 50, 255}, {30, 60, 220, 255}); }
TEST(DecodeJpeg, Progressive) { expect_halves(kProgressive, {200, 100, 50, 255}, {30, 60, 220, 255}); }
TEST(DecodeJpeg, CmykOfAdobe) { expect_halves(kCmykAdobe, {163, 82, 41, 255}, {51, 153, 255, 255}); }
TEST(DecodeJpeg, CmykPlain) { expect_halves(kCmykPlain, {163, 82, 41, 255}, {51, 153, 255, 255}); }
TEST(DecodeJpeg, Ycck) { expect_halves(kYcck, {163, 82, 41, 255}, {51, 153, 255, 255}); }

TEST(DecodeJpeg, EveryTruncationIsRefused) {
  for (const char* base64 : {kGrey, kRgb, kProgressive, kYcck}) {
    const Bytes jpeg = decoded_base64(base64);
    for (std::size_t size = 0; size + 2 < jpeg.size(); ++size) {
      EXPECT_THROW(decode_image(std::span(jpeg).first(size), "cut.jpg"), InputError) << size;
    }
  }
}

TEST(DecodeJpeg, ScansWithoutEndAreRefused) {
  Bytes jpeg = decoded_base64(kProgressive);
  // The last start-of-scan marker up to the end-of-image marker, again and again.
  const std::uint8_t marker[] = {0xff, 0xda};
  const auto last = std::find_end(jpeg.begin(), jpeg.end(), std::begin(marker), std::end(marker));
  const Bytes scan(last, jpeg.end() - 2);
  Bytes bomb(jpeg.begin(), jpeg.end() - 2);
  for (int i = 0; i < 200; ++i) bomb.insert(bomb.end(), scan.begin(), scan.end());
  bomb.insert(bomb.end(), {0xff, 0xd9});
  EXPECT_EQ(message_of([&] { decode_image(bomb, "bomb.jpg"); }),
            "bomb.jpg: damaged JPEG: it has too many scans");
}

TEST(DecodeJpeg, LimitsAreKept) {
  const Bytes jpeg = decoded_base64(kRgb);
  EXPECT_EQ(message_of([&] {
              decode_image(jpeg, "a.jpg", {15, 1000});
            }),
            "a.jpg: 16 × 8 pixels: a side may have at most 15");
}

TEST(DecodeJpeg, DamagedBytesNeverCrash) {
  const std::vector<Bytes> originals{decoded_base64(kRgb), decoded_base64(kProgressive),
                                     decoded_base64(kYcck),
                                     encode_jpeg({40, 40, noise_rgba(40, 40, true, 5), {}})};
  Noise noise(2);
  for (int round = 0; round < 2000; ++round) {
    Bytes jpeg = originals[static_cast<std::size_t>(round) % originals.size()];
    for (int i = 0; i < 3; ++i) jpeg[noise.next() % jpeg.size()] = noise.byte();
    try {
      decode_image(jpeg, "damaged.jpg", {4096, 1 << 20});
    } catch (const InputError&) {
    }
  }
}

TEST(EncodeJpeg, KeepsColorsNearlyAndComposesOverBlack) {
  Bytes rgba;
  for (int i = 0; i < 32 * 32; ++i) {
    rgba.insert(rgba.end(), {200, static_cast<std::uint8_t>(i / 8), 40, 255});
  }
  for (const int quality : {75, 92}) {
    WriteOptions options;
    options.jpeg_quality = quality;
    const Image image = decode_image(encode_jpeg({32, 32, rgba, {}}, options), "x.jpg");
    for (std::size_t i = 0; i < rgba.size(); ++i) ASSERT_NEAR(image.rgba[i], rgba[i], 8);
  }
  for (std::size_t i = 3; i < rgba.size(); i += 4) rgba[i] = 0;
  const Image black = decode_image(encode_jpeg({32, 32, rgba, {}}), "x.jpg");
  for (std::size_t i = 0; i < rgba.size(); ++i) ASSERT_EQ(black.rgba[i], i % 4 == 3 ? 255 : 0);
}

TEST(EncodeJpeg, LowerQualityIsSmaller) {
  const Bytes rgba = noise_rgba(64, 64, true, 9);
  WriteOptions low, high;
  low.jpeg_quality = 30;
  high.jpeg_quality = 95;
  EXPECT_LT(encode_jpeg({64, 64, rgba, {}}, low).size(), encode_jpeg({64, 64, rgba, {}}, high).size());
}

TEST(EncodeJpeg, TooLargeForTheFormatIsAnError) {
  const Bytes rgba(std::size_t{70000} * 4);
  EXPECT_THROW(encode_jpeg({70000, 1, rgba, {}}), InputError);
}

}  // namespace
}  // namespace barrido::scene::test
