// What an image says of itself before its pixels: format and size. Decodes nothing.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace barrido::scene::validation {

struct ImageProbe {
  enum class State : std::uint8_t { fine, unrecognized, cut_off, broken };
  State state = State::unrecognized;
  std::string_view mime_type;  ///< Empty where the format is not recognized.
  std::uint32_t width = 0, height = 0;
  const char* problem = "";  ///< Of a broken image.
};

/// "image/png" …; empty where the first bytes are of no format that glTF knows.
std::string_view detect_mime_type(std::span<const std::uint8_t> bytes);

/// `steps`: chunks or segments looked at; the image counts as cut off behind them.
ImageProbe probe_image(std::span<const std::uint8_t> bytes, std::size_t steps = 10000);

}  // namespace barrido::scene::validation
