// The picture formats Barrido knows: how their names and first bytes tell them apart, and what each can hold.
// Must not know: pixels, codecs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

namespace barrido::scene {

enum class ImageFormat : std::uint8_t { png, jpeg, exr, hdr, tiff, webp, bmp, tga, pnm };

/// What a format can hold, and who reads and writes it.
struct FormatTraits {
  ImageFormat format;
  std::string_view name;         ///< For messages: "EXR".
  const char* openimageio_name;  ///< Its reader and writer there; null: PNG and JPEG, which are built in.
  bool has_alpha;                ///< As Barrido writes it.
  bool holds_floats;
  bool associated_alpha;  ///< Colours are stored multiplied by alpha.
  bool is_read;
};

const FormatTraits& traits_of(ImageFormat format);

/// By extension ("x.PNG" or ".png", either case); null where it names no format that is written.
const FormatTraits* format_by_extension(const std::filesystem::path& path);

/// By the first bytes, and for TGA, which has no mark of its own, by extension. Null: none that is read.
const FormatTraits* format_by_content(std::span<const std::uint8_t> bytes, const std::filesystem::path& path);

}  // namespace barrido::scene
