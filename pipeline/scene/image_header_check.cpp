#include "pipeline/scene/image_header_check.h"

#include <algorithm>

#include "pipeline/scene/image_codecs.h"

namespace barrido::scene {
namespace {

std::uint32_t little_endian(std::span<const std::uint8_t> bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value |= std::uint32_t{bytes[at + i]} << (8 * i);
  return value;
}

/// BITMAPFILEHEADER and BITMAPINFOHEADER (Windows GDI): signed width and height; negative heights store the
/// top row first.
void check_bmp(std::span<const std::uint8_t> bytes, const std::string& name, const ImageLimits& limits) {
  if (bytes.size() < 54) throw InputError(name, "", "damaged BMP: the header is cut off");
  if (little_endian(bytes, 14, 4) < 40) throw InputError(name, "", "BMP files of OS/2 are not read");
  const auto width = static_cast<std::int32_t>(little_endian(bytes, 18, 4));
  const std::int64_t height = static_cast<std::int32_t>(little_endian(bytes, 22, 4));
  const std::uint64_t rows = static_cast<std::uint64_t>(height < 0 ? -height : height);
  check_image_size(static_cast<std::uint64_t>(std::max(width, 0)), rows, name, limits);
  const std::uint32_t bits = little_endian(bytes, 28, 2);
  const std::uint32_t compression = little_endian(bytes, 30, 4);
  if ((bits != 24 && bits != 32) || (compression != 0 && compression != 3)) {
    throw InputError(name, "", "of BMP, only true colour without compression is read");
  }
}

/// Truevision TGA 2.0, table of the header: colour map type at 1, image type at 2, width at 12, height at 14,
/// bits a pixel at 16.
void check_tga(std::span<const std::uint8_t> bytes, const std::string& name, const ImageLimits& limits) {
  if (bytes.size() < 18) throw InputError(name, "", "damaged TGA: the header is cut off");
  check_image_size(little_endian(bytes, 12, 2), little_endian(bytes, 14, 2), name, limits);
  const std::uint8_t type = bytes[2];
  const std::uint8_t bits = bytes[16];
  const bool color = (type == 2 || type == 10) && (bits == 24 || bits == 32);
  const bool grey = (type == 3 || type == 11) && bits == 8;
  if (bytes[1] != 0 || !(color || grey)) {
    throw InputError(name, "", "of TGA, only true colour and grey of 8 bits a channel are read");
  }
}

}  // namespace

void check_header(std::span<const std::uint8_t> bytes, const FormatTraits& format, const std::string& name,
                  const ImageLimits& limits) {
  if (format.format == ImageFormat::bmp) check_bmp(bytes, name, limits);
  if (format.format == ImageFormat::tga) check_tga(bytes, name, limits);
}

}  // namespace barrido::scene
