#include <cmath>

#include "image_test_support.h"
#include "pipeline/pictures/codecs.h"

namespace barrido::scene::test {
namespace {

/// Any sample of a picture, the same for encoder and expectation.
std::uint32_t sample_at(std::uint32_t x, std::uint32_t y, int c, int bit_depth) {
  const std::uint32_t mixed =
      (x * 2654435761u + y * 40503u + static_cast<std::uint32_t>(c) * 977u) * 2246822519u;
  return mixed >> (32 - bit_depth);
}

std::uint8_t to_byte(std::uint32_t sample, int bit_depth) {
  const double max = static_cast<double>((1u << bit_depth) - 1);
  return static_cast<std::uint8_t>(std::floor(sample / max * 255.0 + 0.5));
}

struct Kind {
  std::uint8_t color_type, bit_depth;
};
const std::vector<Kind> kKinds{{0, 1},  {0, 2}, {0, 4},  {0, 8}, {0, 16}, {2, 8},
                               {2, 16}, {4, 8}, {4, 16}, {6, 8}, {6, 16}};

PngFile file_of(const Kind& kind, bool interlaced) {
  PngFile file;
  file.width = 13;
  file.height = 11;
  file.color_type = kind.color_type;
  file.bit_depth = kind.bit_depth;
  file.interlaced = interlaced;
  file.sample = [depth = kind.bit_depth](std::uint32_t x, std::uint32_t y, int c) {
    return sample_at(x, y, c, depth);
  };
  return file;
}

std::array<std::uint8_t, 4> expected_pixel(const Kind& kind, std::uint32_t x, std::uint32_t y) {
  const auto value = [&](int c) { return to_byte(sample_at(x, y, c, kind.bit_depth), kind.bit_depth); };
  switch (kind.color_type) {
    case 0:
      return {value(0), value(0), value(0), 255};
    case 2:
      return {value(0), value(1), value(2), 255};
    case 4:
      return {value(0), value(0), value(0), value(1)};
    default:
      return {value(0), value(1), value(2), value(3)};
  }
}

TEST(DecodePng, EveryColorTypeAndDepthRounded) {
  for (const Kind& kind : kKinds) {
    for (const bool interlaced : {false, true}) {
      SCOPED_TRACE(testing::Message() << "colour type " << int{kind.color_type} << ", " << int{kind.bit_depth}
                                      << " bits, interlaced " << interlaced);
      const Image image = decode_image(file_of(kind, interlaced).build(), "x.png");
      ASSERT_EQ(image.width, 13);
      ASSERT_EQ(image.height, 11);
      for (std::uint32_t y = 0; y < 11; ++y) {
        for (std::uint32_t x = 0; x < 13; ++x) {
          const auto expected = expected_pixel(kind, x, y);
          for (std::size_t c = 0; c < 4; ++c) ASSERT_EQ(image.rgba[(y * 13 + x) * 4 + c], expected[c]);
        }
      }
    }
  }
}

/// Two decoders, one for the usual kind of file and one for all, must agree.
TEST(DecodePng, EveryFilterIsUndone) {
  for (const std::uint8_t color_type : {0, 2, 4, 6}) {
    for (const int data_chunks : {1, 3}) {
      SCOPED_TRACE(testing::Message() << "colour type " << int{color_type} << ", chunks " << data_chunks);
      PngFile file = file_of({color_type, 8}, false);
      file.filters = {4, 1, 2, 3, 4, 0, 3, 1, 4, 4, 2};  // the first row has nothing above it
      file.data_chunks = data_chunks;
      const Bytes png = file.build();
      const Image image = decode_image(png, "x.png");
      const Samples16 exact = decode_png_16(png, "x.png", {});
      ASSERT_EQ(image.rgba.size(), exact.rgba.size());
      for (std::size_t i = 0; i < image.rgba.size(); ++i) ASSERT_EQ(image.rgba[i] * 257, exact.rgba[i]) << i;
    }
  }
}

TEST(DecodePng, WrongFiltersAndChecksumsAreRefused) {
  PngFile file = file_of({6, 8}, false);
  file.filters = {0, 5};
  EXPECT_NE(message_of([&] { decode_image(file.build(), "x.png"); }).find("damaged PNG"), std::string::npos);
  file.filters = {1};
  Bytes png = file.build();
  png[png.size() - 12 - 4 - 1] ^= 1;  // the last byte of IDAT's data, under its own checksum
  EXPECT_NE(message_of([&] { decode_image(png, "x.png"); }).find("damaged PNG"), std::string::npos);
}

TEST(DecodePng, PalettesOfEveryDepthWithTransparency) {
  for (const std::uint8_t depth : {1, 2, 4, 8}) {
    PngFile file;
    file.width = 7;
    file.height = 3;
    file.color_type = 3;
    file.bit_depth = depth;
    const std::uint32_t colors = 1u << depth;
    for (std::uint32_t i = 0; i < colors; ++i) {
      for (const std::uint32_t value : {i * 7 + 3, 255 - i, i * 91}) {
        file.palette.push_back(static_cast<std::uint8_t>(value));
      }
    }
    file.transparency = {10, 200};  // the rest is opaque
    file.sample = [depth](std::uint32_t x, std::uint32_t y, int) { return sample_at(x, y, 0, depth); };
    const Image image = decode_image(file.build(), "x.png");
    for (std::uint32_t i = 0; i < 21; ++i) {
      const std::uint32_t index = sample_at(i % 7, i / 7, 0, depth);
      for (std::uint32_t c = 0; c < 3; ++c) ASSERT_EQ(image.rgba[i * 4 + c], file.palette[index * 3 + c]);
      ASSERT_EQ(image.rgba[i * 4 + 3], index == 0 ? 10 : index == 1 ? 200 : 255);
    }
  }
}

TEST(DecodePng, OneColorOfATrueColorPictureMayBeTransparent) {
  PngFile file;
  file.width = 2;
  file.color_type = 2;
  file.transparency = {0, 9, 0, 8, 0, 7};
  file.sample = [](std::uint32_t x, std::uint32_t, int c) {
    return x == 0 ? 9u - static_cast<unsigned>(c) : 50u;
  };
  const Image image = decode_image(file.build(), "x.png");
  EXPECT_EQ(pixels(image), (Bytes{9, 8, 7, 0, 50, 50, 50, 255}));
}

TEST(DecodePng, EveryTruncationIsRefused) {
  const Bytes png = file_of({6, 8}, false).build();
  const std::size_t trailer = 12 + 4;  // IEND, and the checksum of IDAT before it, hold no pixels
  for (std::size_t size = 0; size + trailer < png.size(); ++size) {
    EXPECT_THROW(decode_image(std::span(png).first(size), "cut.png"), InputError) << size;
  }
}

TEST(DecodePng, HeaderThatTheFileCannotFillIsRefusedBeforeMemoryIsTaken) {
  PngFile file = file_of({6, 8}, false);
  file.claimed_side = 8192;
  const Bytes png = file.build();
  EXPECT_EQ(message_of([&] { decode_image(png, "bomb.png"); }),
            "bomb.png: damaged PNG: " + std::to_string(png.size()) + " bytes cannot hold 8192 × 8192 pixels");
}

TEST(DecodePng, LimitsAreKept) {
  const Bytes png = file_of({6, 8}, false).build();
  EXPECT_EQ(message_of([&] {
              decode_image(png, "a.png", {12, 1000});
            }),
            "a.png: 13 × 11 pixels: a side may have at most 12");
  EXPECT_EQ(message_of([&] {
              decode_image(png, "a.png", {13, 142});
            }),
            "a.png: 13 × 11 pixels: a picture may have at most 142");
  EXPECT_NO_THROW(decode_image(png, "a.png", {13, 143}));
}

TEST(DecodePng, DamagedBytesNeverCrash) {
  const std::vector<Bytes> originals{file_of({6, 8}, false).build(), file_of({2, 16}, true).build(),
                                     encode_png({32, 32, noise_rgba(32, 32, true, 5), {}})};
  Noise noise(1);
  for (int round = 0; round < 2000; ++round) {
    Bytes png = originals[static_cast<std::size_t>(round) % originals.size()];
    for (int i = 0; i < 4; ++i) png[noise.next() % png.size()] = noise.byte();
    try {
      decode_image(png, "damaged.png");
    } catch (const InputError&) {
    }
  }
}

TEST(EncodePng, KeepsEveryPixel) {
  for (const bool opaque : {false, true}) {
    for (const int level : {0, 1, 6, 9}) {
      const Bytes rgba = noise_rgba(61, 47, opaque, 3);
      WriteOptions options;
      options.png_compression = level;
      const Image image = decode_image(encode_png({61, 47, rgba, {}}, options), "x.png");
      EXPECT_EQ(image.width, 61);
      EXPECT_EQ(image.height, 47);
      EXPECT_EQ(pixels(image), rgba) << "opaque " << opaque << ", level " << level;
    }
  }
}

TEST(EncodePng, GradientsAreFilteredAndKept) {
  Bytes rgba;
  for (int i = 0; i < 256 * 256; ++i) {
    const int x = i % 256, y = i / 256;
    rgba.insert(rgba.end(), {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y),
                             static_cast<std::uint8_t>((x + y) / 2), 255});
  }
  const Bytes png = encode_png({256, 256, rgba, {}});
  EXPECT_LT(png.size(), rgba.size() / 40);
  EXPECT_EQ(pixels(decode_image(png, "x.png")), rgba);
}

TEST(EncodePng, WithoutAlphaIsComposedOverBlack) {
  const Bytes rgba{200, 100, 50, 130, 255, 255, 255, 0, 9, 8, 7, 255};
  WriteOptions options;
  options.write_alpha = false;
  const Image image = decode_image(encode_png({3, 1, rgba, {}}, options), "x.png");
  EXPECT_EQ(pixels(image), (Bytes{102, 51, 25, 255, 0, 0, 0, 255, 9, 8, 7, 255}));
}

TEST(EncodePng, SameBytesEveryTime) {
  const Bytes rgba = noise_rgba(300, 200, true, 8);
  EXPECT_EQ(encode_png({300, 200, rgba, {}}), encode_png({300, 200, rgba, {}}));
}

TEST(EncodePng, WrongSizeIsAProgrammersError) {
  const Bytes rgba(16);
  EXPECT_THROW(encode_png({3, 1, rgba, {}}), std::invalid_argument);
  EXPECT_THROW(encode_png({0, 0, {}, {}}), std::invalid_argument);
}

}  // namespace
}  // namespace barrido::scene::test
