// Pictures that the OpenImageIO module reads and writes. The module is found and loaded on first need and
// stays loaded. Must not know: OpenImageIO.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <variant>

#include "pipeline/pictures/format.h"
#include "pipeline/pictures/image_io.h"
#include "pipeline/pictures/stored_picture.h"

namespace barrido::scene {

/// A picture as its file holds it: bytes as they are, or linear floats.
using Picture = std::variant<Image, FloatImage>;

/// Reads `path`, which format_by_content has found to be of `format`. Straight alpha.
/// @throws InputError, also when there is no module.
Picture read_with_module(const std::filesystem::path& path, const FormatTraits& format,
                         const ImageLimits& limits);

/// Reads the same as StoredPicture. @throws InputError, also when there is no module.
StoredPicture read_stored_with_module(const std::filesystem::path& path, const FormatTraits& format,
                                      const ImageLimits& limits);

/// Interleaved pixels ready for a file: 3 or 4 channels, either bytes or floats.
struct PackedPicture {
  int width = 0;
  int height = 0;
  int channels = 3;
  std::span<const std::uint8_t> bytes;
  std::span<const float> floats;
};

/// Writes to `file`; messages name `target`. @throws InputError, also when there is no module.
void write_with_module(const std::filesystem::path& file, const std::filesystem::path& target,
                       const FormatTraits& format, const PackedPicture& picture, bool half_floats);

}  // namespace barrido::scene
