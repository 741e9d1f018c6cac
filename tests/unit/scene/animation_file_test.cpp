// Animations, read back by the libraries' own readers: sizes, times, and the pixels of every frame.
#include "pipeline/pictures/animation.h"

#include <gif_lib.h>
#include <gtest/gtest.h>
#include <webp/demux.h>

#include <cstring>

namespace barrido::scene {
namespace {

constexpr int kWidth = 31, kHeight = 17;

/// Frame n of pictures of few colours, all different.
std::vector<std::uint8_t> pixels_of(int n) {
  std::vector<std::uint8_t> rgba;
  for (int i = 0; i < kWidth * kHeight; ++i) {
    rgba.insert(rgba.end(),
                {static_cast<std::uint8_t>((i * (n + 3)) % 200), static_cast<std::uint8_t>(n * 40),
                 static_cast<std::uint8_t>(i % kWidth == n ? 255 : 0), 255});
  }
  return rgba;
}

std::vector<std::uint8_t> encode(AnimationFormat format, int frames, double frames_per_second) {
  AnimationEncoder encoder(format, "film", frames_per_second);
  for (int n = 0; n < frames; ++n) {
    const std::vector<std::uint8_t> rgba = pixels_of(n);
    encoder.add(prepare_frame(format, {kWidth, kHeight, rgba, {}}));
  }
  return encoder.finish();
}

struct Bytes {
  std::span<const std::uint8_t> rest;
};

int read_bytes(GifFileType* file, GifByteType* into, int count) {
  auto& bytes = static_cast<Bytes*>(file->UserData)->rest;
  const std::size_t got = std::min(bytes.size(), static_cast<std::size_t>(count));
  std::memcpy(into, bytes.data(), got);
  bytes = bytes.subspan(got);
  return static_cast<int>(got);
}

TEST(AnimationFile, AGifHasTheFramesAndTheirTimes) {
  const std::vector<std::uint8_t> file = encode(AnimationFormat::gif, 5, 30.0);
  Bytes bytes{file};
  int error = 0;
  GifFileType* gif = DGifOpen(&bytes, read_bytes, &error);
  ASSERT_NE(gif, nullptr) << error;
  ASSERT_EQ(DGifSlurp(gif), GIF_OK);
  EXPECT_EQ(gif->SWidth, kWidth);
  EXPECT_EQ(gif->SHeight, kHeight);
  ASSERT_EQ(gif->ImageCount, 5);
  const int delays[] = {3, 4, 3, 3, 4};  // 1/30 s, rounded so that the sum stays right
  for (int n = 0; n < 5; ++n) {
    GraphicsControlBlock control{};
    ASSERT_EQ(DGifSavedExtensionToGCB(gif, n, &control), GIF_OK);
    EXPECT_EQ(control.DelayTime, delays[n]) << n;
    EXPECT_EQ(control.TransparentColor, NO_TRANSPARENT_COLOR);
    const SavedImage& image = gif->SavedImages[n];
    const std::vector<std::uint8_t> expected = pixels_of(n);
    for (int i = 0; i < kWidth * kHeight; ++i) {
      const GifColorType& color = image.ImageDesc.ColorMap->Colors[image.RasterBits[i]];
      const std::uint8_t* rgb = &expected[static_cast<std::size_t>(4 * i)];
      ASSERT_TRUE(color.Red == rgb[0] && color.Green == rgb[1] && color.Blue == rgb[2]) << n << " " << i;
    }
  }
  EXPECT_EQ(DGifCloseFile(gif, &error), GIF_OK);
}

TEST(AnimationFile, AWebpHasTheFramesAndTheirTimes) {
  const std::vector<std::uint8_t> file = encode(AnimationFormat::webp, 4, 25.0);
  const WebPData data{file.data(), file.size()};
  WebPAnimDecoderOptions options;
  ASSERT_NE(WebPAnimDecoderOptionsInit(&options), 0);
  options.color_mode = MODE_RGBA;
  WebPAnimDecoder* decoder = WebPAnimDecoderNew(&data, &options);
  ASSERT_NE(decoder, nullptr);
  WebPAnimInfo info;
  ASSERT_NE(WebPAnimDecoderGetInfo(decoder, &info), 0);
  EXPECT_EQ(info.canvas_width, static_cast<unsigned>(kWidth));
  EXPECT_EQ(info.canvas_height, static_cast<unsigned>(kHeight));
  EXPECT_EQ(info.frame_count, 4u);
  EXPECT_EQ(info.loop_count, 0u);
  for (int n = 0; n < 4; ++n) {
    std::uint8_t* rgba = nullptr;
    int end_ms = 0;
    ASSERT_NE(WebPAnimDecoderGetNext(decoder, &rgba, &end_ms), 0);
    EXPECT_EQ(end_ms, 40 * (n + 1));
    EXPECT_EQ(std::memcmp(rgba, pixels_of(n).data(), static_cast<std::size_t>(4 * kWidth * kHeight)), 0) << n;
  }
  WebPAnimDecoderDelete(decoder);
}

TEST(AnimationFile, FramesOfTwoSizesAreRefused) {
  for (const AnimationFormat format : {AnimationFormat::gif, AnimationFormat::webp}) {
    AnimationEncoder encoder(format, "film", 30.0);
    const std::vector<std::uint8_t> rgba = pixels_of(0);
    encoder.add(prepare_frame(format, {kWidth, kHeight, rgba, {}}));
    EXPECT_THROW(encoder.add(prepare_frame(format, {kHeight, kWidth, rgba, {}})), InputError);
  }
}

TEST(AnimationFile, FormatsAreKnownByTheirExtension) {
  EXPECT_EQ(animation_format("a/b.GIF"), AnimationFormat::gif);
  EXPECT_EQ(animation_format("b.webp"), AnimationFormat::webp);
  EXPECT_EQ(animation_format("gif"), std::nullopt);
  EXPECT_EQ(animation_format("a.png"), std::nullopt);
}

}  // namespace
}  // namespace barrido::scene
