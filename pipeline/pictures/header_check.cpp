#include "pipeline/pictures/header_check.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "pipeline/pictures/codecs.h"

namespace barrido::scene {
namespace {

/// A reader makes a table with an entry for each tile before it looks whether there are any.
constexpr std::uint64_t kMaxTiles = std::uint64_t{1} << 20;

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

/// The attributes of an OpenEXR header one after the other (OpenEXR File Layout, "Structure of the header").
class ExrAttributes {
 public:
  ExrAttributes(std::span<const std::uint8_t> bytes, const std::string& name) : rest_(bytes), name_(name) {}

  struct Attribute {
    std::string_view name, type;
    std::span<const std::uint8_t> value;
  };

  /// False at the end of a header, which is taken as well.
  bool next(Attribute& attribute) {
    attribute.name = take_text();
    if (attribute.name.empty()) return false;
    attribute.type = take_text();
    attribute.value = take(little_endian(take(4), 0, 4));
    return true;
  }

  /// Whether another header of a file with several parts follows.
  bool at_header() const { return !rest_.empty() && rest_[0] != 0; }

 private:
  std::span<const std::uint8_t> take(std::size_t count) {
    if (count > rest_.size()) throw InputError(name_, "", "damaged EXR: the header is cut off");
    const auto taken = rest_.first(count);
    rest_ = rest_.subspan(count);
    return taken;
  }
  std::string_view take_text() {
    const auto end = std::find(rest_.begin(), rest_.end(), std::uint8_t{0});
    const auto text = take(static_cast<std::size_t>(end - rest_.begin()));
    take(1);  // the zero
    return {reinterpret_cast<const char*>(text.data()), text.size()};
  }

  std::span<const std::uint8_t> rest_;
  const std::string& name_;
};

/// One header: the data window and the number of tiles.
void check_exr_part(ExrAttributes& attributes, const std::string& name, const ImageLimits& limits) {
  std::uint64_t width = 0, height = 0, tile_width = 0, tile_height = 0, chunks = 0;
  ExrAttributes::Attribute attribute;
  while (attributes.next(attribute)) {
    const auto value = attribute.value;
    if (attribute.name == "dataWindow" && value.size() == 16) {  // smallest x and y, largest x and y
      const auto side = [&value](std::size_t low) {
        const auto first = static_cast<std::int32_t>(little_endian(value, low, 4));
        const auto last = static_cast<std::int32_t>(little_endian(value, low + 8, 4));
        return last < first ? 0 : static_cast<std::uint64_t>(std::int64_t{last} - first + 1);
      };
      width = side(0);
      height = side(4);
    } else if (attribute.name == "tiles" && value.size() == 9) {
      tile_width = std::max(little_endian(value, 0, 4), 1u);
      tile_height = std::max(little_endian(value, 4, 4), 1u);
    } else if (attribute.name == "chunkCount" && value.size() == 4) {
      chunks = little_endian(value, 0, 4);
    }
  }
  check_image_size(width, height, name, limits);
  const std::uint64_t tiles =
      tile_width == 0 ? 0
                      : ((width + tile_width - 1) / tile_width) * ((height + tile_height - 1) / tile_height);
  if (tiles > kMaxTiles || chunks > kMaxTiles) throw InputError(name, "", "it has too many tiles");
}

void check_exr(std::span<const std::uint8_t> bytes, const std::string& name, const ImageLimits& limits) {
  constexpr std::size_t kMagicAndVersion = 8;
  constexpr std::uint32_t kSeveralParts = 0x1000;
  if (bytes.size() < kMagicAndVersion) throw InputError(name, "", "damaged EXR: the header is cut off");
  const bool several = (little_endian(bytes, 4, 4) & kSeveralParts) != 0;
  ExrAttributes attributes(bytes.subspan(kMagicAndVersion), name);
  do {
    check_exr_part(attributes, name, limits);
  } while (several && attributes.at_header());
}

/// The first directory of a TIFF file (TIFF 6.0, section 2), whose reader divides by the sizes of tiles.
class TiffDirectory {
 public:
  TiffDirectory(std::span<const std::uint8_t> bytes, const std::string& name)
      : bytes_(bytes), name_(name), big_endian_(!bytes.empty() && bytes[0] == 'M') {
    if (number(2, 2) != 42) throw InputError(name, "", "of TIFF, only the classic kind is read");
    first_ = std::size_t{number(4, 4)} + 2;
    count_ = number(first_ - 2, 2);
  }

  /// The one number of an entry; `otherwise` where there is no such entry, or it has several.
  std::uint32_t value(std::uint32_t tag, std::uint32_t otherwise) const {
    constexpr std::uint32_t kShort = 3, kLong = 4;
    for (std::size_t i = 0; i < count_; ++i) {
      const std::size_t entry = first_ + 12 * i;
      if (number(entry, 2) != tag) continue;
      const std::uint32_t type = number(entry + 2, 2);
      if ((type != kShort && type != kLong) || number(entry + 4, 4) != 1) return otherwise;
      return number(entry + 8, type == kShort ? 2 : 4);
    }
    return otherwise;
  }

 private:
  std::uint32_t number(std::size_t at, std::size_t size) const {
    if (at > bytes_.size() || size > bytes_.size() - at) {
      throw InputError(name_, "", "damaged TIFF: its directory is cut off");
    }
    std::uint32_t result = 0;
    for (std::size_t i = 0; i < size; ++i) {
      result |= std::uint32_t{bytes_[at + i]} << (8 * (big_endian_ ? size - 1 - i : i));
    }
    return result;
  }

  std::span<const std::uint8_t> bytes_;
  const std::string& name_;
  bool big_endian_;
  std::size_t first_ = 0, count_ = 0;
};

void check_tiff(std::span<const std::uint8_t> bytes, const std::string& name, const ImageLimits& limits) {
  constexpr std::uint32_t kWidth = 256, kHeight = 257, kCompression = 259, kSamples = 277, kTileWidth = 322,
                          kTileHeight = 323;
  constexpr std::array<std::uint32_t, 6> kCompressions{1, 5, 7, 8, 32773, 32946};
  constexpr std::uint32_t kMostSamples = 64, kMostOfATile = 4096;
  const TiffDirectory directory(bytes, name);
  check_image_size(directory.value(kWidth, 0), directory.value(kHeight, 0), name, limits);
  const std::uint32_t compression = directory.value(kCompression, 1);
  if (std::find(kCompressions.begin(), kCompressions.end(), compression) == kCompressions.end()) {
    throw InputError(name, "", "TIFF's compression " + std::to_string(compression) + " is not read");
  }
  if (directory.value(kSamples, 1) > kMostSamples) throw InputError(name, "", "it has too many channels");
  constexpr std::uint32_t kAbsent = 16;
  for (const std::uint32_t side :
       {directory.value(kTileWidth, kAbsent), directory.value(kTileHeight, kAbsent)}) {
    if (side == 0 || side > kMostOfATile || side % 16 != 0) {
      throw InputError(name, "", "damaged TIFF: tiles of " + std::to_string(side) + " pixels a side");
    }
  }
}

}  // namespace

void check_header(std::span<const std::uint8_t> bytes, const FormatTraits& format, const std::string& name,
                  const ImageLimits& asked) {
  ImageLimits limits = asked;
  limits.budget = nullptr;  // The reader will put it down.
  if (format.format == ImageFormat::exr) check_exr(bytes, name, limits);
  if (format.format == ImageFormat::bmp) check_bmp(bytes, name, limits);
  if (format.format == ImageFormat::tga) check_tga(bytes, name, limits);
  if (format.format == ImageFormat::tiff) check_tiff(bytes, name, limits);
}

}  // namespace barrido::scene
