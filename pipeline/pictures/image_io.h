// Pictures in and out. PNG and JPEG are handled here with libspng and libjpeg-turbo; every other format goes
// through OpenImageIO in a module of its own that is loaded on first need, because linking it would cost
// every process 0.2 s, 130 MB, GL and X.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "pipeline/files/budget.h"
#include "pipeline/files/error.h"
#include "pipeline/pictures/image.h"

namespace barrido::scene {

/// What may be read. 2^26 pixels (8192²) are 256 MiB of RGBA8: a small file of zeros that unpacks to more is
/// refused by its header.
struct ImageLimits {
  int max_side = 16384;
  std::uint64_t max_pixels = std::uint64_t{1} << 26;
  Budget* budget = nullptr;         ///< The picture is put down in it before memory is taken; null: in none.
  std::uint64_t bytes_a_pixel = 4;  ///< That this will take, where the reader does not know better.
};

/// Decodes PNG, JPEG, WebP or plain KTX2 (told apart by their first bytes). The header is checked before
/// memory is taken.
/// @throws InputError naming `name`.
Image decode_image(std::span<const std::uint8_t> bytes, const std::string& name,
                   const ImageLimits& limits = {});

/// Reads PNG, JPEG, TIFF, BMP or TGA, and EXR or HDR clamped to [0, 1] and encoded as sRGB.
/// @throws InputError.
Image read_image(const std::filesystem::path& path, const ImageLimits& limits = {});

/// Reads the same formats as linear floats; 8-bit colours are decoded from sRGB. Pictures that hold floats
/// may have half the pixels that `limits` allows. @throws InputError.
FloatImage read_float_image(const std::filesystem::path& path, const ImageLimits& limits = {});

/// A picture to be written: 8-bit always, floats where the file's format can hold them (exr, hdr, tif).
struct ImageView {
  int width = 0;
  int height = 0;
  std::span<const std::uint8_t> rgba8;  ///< Straight RGBA, top row first.
  std::span<const float> rgba_float;    ///< Straight RGBA, linear, top row first; may be empty.
};

struct WriteOptions {
  int png_compression = 1;   ///< 0..9; low is fast
  int jpeg_quality = 92;     ///< 1..100; from 90 on colour keeps its full resolution
  bool half_floats = false;  ///< exr: 16-bit floats
  /// False, or a format without alpha (jpg, hdr, bmp, ppm): composed over black as the colours stand.
  bool write_alpha = true;
};

/// Whether the extension of `path` names a format that write_image knows; loads nothing.
bool is_writable_format(const std::filesystem::path& path);

/// Encodes PNG in memory: RGB where every pixel is opaque, else RGBA. @throws InputError.
std::vector<std::uint8_t> encode_png(const ImageView& image, const WriteOptions& options = {});

/// Encodes JPEG (baseline) in memory. @throws InputError.
std::vector<std::uint8_t> encode_jpeg(const ImageView& image, const WriteOptions& options = {});

/// Encodes in memory what write_image would write to a file with this extension ("exr" or ".exr"); for
/// standard output. @throws InputError.
std::vector<std::uint8_t> encode_image(const std::string& extension, const ImageView& image,
                                       const WriteOptions& options = {});

/// Writes by extension (png, jpg, tif, exr, hdr …) to a temporary name beside `path`, then renames it, so
/// that no half picture is ever seen under the final name. @throws InputError.
void write_image(const std::filesystem::path& path, const ImageView& image, const WriteOptions& options = {});

}  // namespace barrido::scene
