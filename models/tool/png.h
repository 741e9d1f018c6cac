// Small PNG files for the pictures the tool draws: palette where the colours allow it, and the filter that
// makes the smallest file. Enters: 8-bit RGB, top row first.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace barrido::models {

struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  ///< width × height × 3
};

/// @throws std::runtime_error when the encoder refuses.
std::vector<std::uint8_t> encode_small_png(const Picture& picture);

/// The colours of a PNG file as RGB, alpha dropped. @throws std::runtime_error naming the file.
Picture read_png(const std::filesystem::path& path);

}  // namespace barrido::models
