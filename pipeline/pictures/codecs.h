// The formats of textures, from bytes to pixels: PNG and JPEG, which every process can read and write, WebP
// by a module of its own, and plain KTX2. Enters: the bytes of a whole file. Leaves: straight RGBA8, top row
// first. Must not know: paths.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "pipeline/pictures/image_io.h"

struct BarridoWebpFunctions;

namespace barrido::scene {

bool is_png(std::span<const std::uint8_t> bytes);
bool is_jpeg(std::span<const std::uint8_t> bytes);
bool is_webp(std::span<const std::uint8_t> bytes);
bool is_ktx2(std::span<const std::uint8_t> bytes);

/// @throws InputError naming `name`.
Image decode_png(std::span<const std::uint8_t> bytes, const std::string& name, const ImageLimits& limits);
/// Fills `image`, whose size is set and whose pixels have been made room for, from a PNG of 8 bits a channel
/// in one pass, with `channels` 1 (grey), 2 (grey and alpha), 3 (RGB) or 4 (RGBA), without a transparent
/// colour.
/// @return false when anything is damaged or unusual; the pixels are then undefined.
bool decode_plain_png(std::span<const std::uint8_t> file, int channels, Image& image);
/// Pixels at their full precision, for comparisons: straight RGBA in 0..65535, top row first.
struct Samples16 {
  int width = 0;
  int height = 0;
  int channels = 4;  ///< That the file stores: 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA.
  std::vector<std::uint16_t> rgba;
};

/// The same without rounding: a sample v of n bits is v·65535/(2^n − 1), which is whole for n = 1, 2, 4, 8.
/// @throws InputError naming `name`.
Samples16 decode_png_16(std::span<const std::uint8_t> bytes, const std::string& name,
                        const ImageLimits& limits);
/// @throws InputError naming `name`.
Image decode_jpeg(std::span<const std::uint8_t> bytes, const std::string& name, const ImageLimits& limits);

/// @throws InputError naming `name`, also when there is no module.
Image decode_webp(std::span<const std::uint8_t> bytes, const std::string& name, const ImageLimits& limits);
/// The module of libwebp, for "reading WebP". @throws InputError naming `name` when there is none.
const BarridoWebpFunctions* webp_functions(const std::string& name, const std::string& purpose);
/// @throws InputError naming `name`, also for what is compressed.
Image decode_ktx2(std::span<const std::uint8_t> bytes, const std::string& name, const ImageLimits& limits);

/// Refuses a size outside the limits, and puts it down in their budget; called once, as soon as a header is
/// read, before memory is taken.
/// @throws InputError naming `name`.
void check_image_size(std::uint64_t width, std::uint64_t height, const std::string& name,
                      const ImageLimits& limits);

}  // namespace barrido::scene
