// PNG from bytes to straight RGBA8 with libspng. Enters: a whole file in memory. Must not know: paths,
// scenes.
#include <spng.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>

#include "pipeline/pictures/codecs.h"

namespace barrido::scene {
namespace {

constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

/// Bytes of ancillary chunks (profiles, comments) that libspng may keep.
constexpr std::size_t kMaxChunkBytes = std::size_t{16} << 20;

/// Deflate never makes more than 1032 bytes of one (a match of 258 in two bits).
constexpr std::uint64_t kMaxDeflateRatio = 1032;

struct ContextDeleter {
  void operator()(spng_ctx* context) const { spng_ctx_free(context); }
};
using Context = std::unique_ptr<spng_ctx, ContextDeleter>;

void check(int status, const std::string& name) {
  if (status != SPNG_OK) throw InputError(name, "", std::string("damaged PNG: ") + spng_strerror(status));
}

int channel_count(const spng_ihdr& header) {
  switch (header.color_type) {
    case SPNG_COLOR_TYPE_TRUECOLOR:
      return 3;
    case SPNG_COLOR_TYPE_GRAYSCALE_ALPHA:
      return 2;
    case SPNG_COLOR_TYPE_TRUECOLOR_ALPHA:
      return 4;
    default:
      return 1;
  }
}

/// A short file cannot hold a large picture: found out before the picture's memory is taken.
void check_plausible(const spng_ihdr& header, std::size_t file_bytes, const std::string& name) {
  const std::uint64_t bits =
      std::uint64_t{header.width} * header.bit_depth * static_cast<std::uint64_t>(channel_count(header));
  const std::uint64_t raw_bytes = (bits / 8) * header.height;
  if (raw_bytes / kMaxDeflateRatio > file_bytes) {
    throw InputError(name, "",
                     "damaged PNG: " + std::to_string(file_bytes) + " bytes cannot hold " +
                         std::to_string(header.width) + " × " + std::to_string(header.height) + " pixels");
  }
}

std::uint8_t to_8_bits(std::uint16_t value) {
  return static_cast<std::uint8_t>((std::uint32_t{value} + 128) / 257);
}

/// 16-bit channels are rounded (libspng would cut them off), row by row so that the picture is never held
/// twice.
void decode_16_bits(spng_ctx* context, const spng_ihdr& header, const std::string& name, Image& image) {
  constexpr std::array<std::uint32_t, 7> kFirst{0, 4, 0, 2, 0, 1, 0};  // Adam7's columns
  constexpr std::array<std::uint32_t, 7> kStep{8, 8, 4, 4, 2, 2, 1};
  check(spng_decode_image(context, nullptr, 0, SPNG_FMT_RGBA16, SPNG_DECODE_TRNS | SPNG_DECODE_PROGRESSIVE),
        name);
  std::vector<std::uint16_t> row(std::size_t{header.width} * 4);
  int status = SPNG_OK;
  while (status == SPNG_OK) {
    spng_row_info info{};
    status = spng_get_row_info(context, &info);
    if (status == SPNG_EOI) break;  // Of the smallest interlaced pictures only here
    check(status, name);
    status = spng_decode_row(context, row.data(), row.size() * sizeof(std::uint16_t));
    if (status != SPNG_OK && status != SPNG_EOI) check(status, name);
    const bool interlaced = header.interlace_method == SPNG_INTERLACE_ADAM7;
    const std::uint32_t first = interlaced ? kFirst[static_cast<std::size_t>(info.pass)] : 0;
    const std::uint32_t step = interlaced ? kStep[static_cast<std::size_t>(info.pass)] : 1;
    std::uint8_t* out = image.rgba.data() + std::size_t{info.row_num} * header.width * 4;
    for (std::uint32_t x = first; x < header.width; x += step) {
      for (std::size_t c = 0; c < 4; ++c) out[x * 4 + c] = to_8_bits(row[x * 4 + c]);
    }
  }
}

/// The header is checked before anything else is read.
Context open_png(std::span<const std::uint8_t> bytes, const std::string& name, const ImageLimits& limits,
                 spng_ihdr& header) {
  Context context(spng_ctx_new(0));
  if (!context) throw InputError(name, "", "not enough memory to decode it");
  check(spng_set_chunk_limits(context.get(), kMaxChunkBytes, kMaxChunkBytes), name);
  check(spng_set_png_buffer(context.get(), bytes.data(), bytes.size()), name);
  check(spng_get_ihdr(context.get(), &header), name);
  check_image_size(header.width, header.height, name, limits);
  check_plausible(header, bytes.size(), name);
  return context;
}

/// Whether the file is of the usual kind, and what stands before its data in order.
bool is_plain(spng_ctx* context, const spng_ihdr& header) {
  spng_trns transparency{};
  return header.bit_depth == 8 && header.interlace_method == SPNG_INTERLACE_NONE &&
         header.color_type != SPNG_COLOR_TYPE_INDEXED &&
         spng_get_trns(context, &transparency) == SPNG_ECHUNKAVAIL;
}

/// Of the colours a file can show: a palette's are three, and a transparent colour is an alpha.
int stored_channels(spng_ctx* context, const spng_ihdr& header) {
  spng_trns transparency{};
  const bool has_transparency = spng_get_trns(context, &transparency) == SPNG_OK;
  const int channels = header.color_type == SPNG_COLOR_TYPE_INDEXED ? 3 : channel_count(header);
  return has_transparency ? channels + 1 : channels;
}

}  // namespace

bool is_png(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= kSignature.size() &&
         std::memcmp(bytes.data(), kSignature.data(), kSignature.size()) == 0;
}

Image decode_png(std::span<const std::uint8_t> bytes, const std::string& name, const ImageLimits& limits) {
  spng_ihdr header{};
  const Context context = open_png(bytes, name, limits, header);
  Image image;
  image.name = name;
  image.width = static_cast<int>(header.width);
  image.height = static_cast<int>(header.height);
  image.rgba.resize(std::size_t{header.width} * header.height * 4);
  if (is_plain(context.get(), header) && decode_plain_png(bytes, channel_count(header), image)) return image;
  if (header.bit_depth == 16) {
    decode_16_bits(context.get(), header, name, image);
  } else {
    check(spng_decode_image(context.get(), image.rgba.data(), image.rgba.size(), SPNG_FMT_RGBA8,
                            SPNG_DECODE_TRNS),
          name);
  }
  return image;
}

Samples16 decode_png_16(std::span<const std::uint8_t> bytes, const std::string& name,
                        const ImageLimits& limits) {
  spng_ihdr header{};
  const Context context = open_png(bytes, name, limits, header);
  Samples16 samples;
  samples.width = static_cast<int>(header.width);
  samples.height = static_cast<int>(header.height);
  samples.channels = stored_channels(context.get(), header);
  samples.rgba.resize(std::size_t{header.width} * header.height * 4);
  check(spng_decode_image(context.get(), samples.rgba.data(), samples.rgba.size() * sizeof(std::uint16_t),
                          SPNG_FMT_RGBA16, SPNG_DECODE_TRNS),
        name);
  return samples;
}

}  // namespace barrido::scene
