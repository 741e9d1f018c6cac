// KTX 2.0 without compression (Khronos' KTX File Format Specification, version 2.0, section 3): the first
// level of a plain 2D picture with 8 bits a channel. BasisLZ and UASTC, which KHR_texture_basisu is about,
// need a transcoder. Enters: the bytes of a whole file. Must not know: paths.
#include <algorithm>
#include <array>

#include "pipeline/pictures/codecs.h"

namespace barrido::scene {
namespace {

constexpr std::array<std::uint8_t, 12> kMagic{0xab, 'K',  'T',  'X',  ' ',  '2',
                                              '0',  0xbb, 0x0d, 0x0a, 0x1a, 0x0a};
constexpr std::size_t kHeaderBytes = 80, kLevelBytes = 24;

struct Format {
  std::uint32_t vulkan_format;
  int channels;
  bool blue_first;
};
/// VK_FORMAT_R8…, in UNORM and SRGB: both hold bytes as PNG does.
constexpr std::array<Format, 10> kFormats{{{9, 1, false},
                                           {15, 1, false},
                                           {16, 2, false},
                                           {22, 2, false},
                                           {23, 3, false},
                                           {29, 3, false},
                                           {37, 4, false},
                                           {43, 4, false},
                                           {44, 4, true},
                                           {50, 4, true}}};

std::uint64_t little_endian(std::span<const std::uint8_t> bytes, std::size_t at, std::size_t size) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < size; ++i) number |= std::uint64_t{bytes[at + i]} << (8 * i);
  return number;
}

/// Missing green and blue are 0 as in Vulkan, a missing alpha is opaque.
void widen(const std::uint8_t* in, const Format& format, std::size_t pixels, std::uint8_t* rgba) {
  const auto channels = static_cast<std::size_t>(format.channels);
  for (std::size_t i = 0; i < pixels; ++i, in += channels, rgba += 4) {
    for (std::size_t c = 0; c < 4; ++c) rgba[c] = c < channels ? in[c] : c == 3 ? 255 : 0;
    if (format.blue_first) std::swap(rgba[0], rgba[2]);
  }
}

}  // namespace

bool is_ktx2(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= kMagic.size() && std::equal(kMagic.begin(), kMagic.end(), bytes.begin());
}

Image decode_ktx2(std::span<const std::uint8_t> bytes, const std::string& name, const ImageLimits& limits) {
  const auto fail = [&](const std::string& reason) { throw InputError(name, "", reason); };
  if (bytes.size() < kHeaderBytes + kLevelBytes) fail("damaged KTX2: the header is cut off");
  const auto word = [&](std::size_t at) { return static_cast<std::uint32_t>(little_endian(bytes, at, 4)); };
  const std::uint32_t vulkan_format = word(12), width = word(20), height = word(24), depth = word(28),
                      layers = word(32), faces = word(36), scheme = word(44);
  if (scheme == 1 || vulkan_format == 0) {
    fail("KTX2 compressed for Basis Universal (BasisLZ or UASTC) is not read");
  }
  const auto* format = std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& known) {
    return known.vulkan_format == vulkan_format;
  });
  if (scheme != 0 || format == kFormats.end()) {
    fail("of KTX2, only 8 bits a channel without compression is read");
  }
  if (depth > 1 || layers > 1 || faces != 1) fail("of KTX2, only plain 2D pictures are read");
  check_image_size(width, height, name, limits);
  const std::uint64_t offset = little_endian(bytes, kHeaderBytes, 8), length = little_endian(bytes, 88, 8);
  const std::uint64_t pixels = std::uint64_t{width} * height;
  const std::uint64_t due = pixels * static_cast<std::uint64_t>(format->channels);
  if (length < due || offset > bytes.size() || due > bytes.size() - offset) {
    fail("damaged KTX2: its pixels are cut off");
  }
  Image image{name, static_cast<int>(width), static_cast<int>(height), {}};
  image.rgba.resize(static_cast<std::size_t>(pixels) * 4);
  widen(bytes.data() + offset, *format, static_cast<std::size_t>(pixels), image.rgba.data());
  return image;
}

}  // namespace barrido::scene
