// PNG chunks up to the first of the pixels, JPEG segments up to the frame header, and WebP's first chunk.
#include "pipeline/validate/image_probe.h"

#include <algorithm>

namespace barrido::scene::validation {
namespace {

using Bytes = std::span<const std::uint8_t>;

std::uint32_t big_endian(Bytes bytes, std::size_t offset, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value = value << 8 | bytes[offset + i];
  return value;
}

std::uint32_t little_endian(Bytes bytes, std::size_t offset, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = count; i-- > 0;) value = value << 8 | bytes[offset + i];
  return value;
}

bool begins_with(Bytes bytes, std::size_t offset, std::string_view text) {
  return bytes.size() >= offset + text.size() &&
         std::equal(text.begin(), text.end(), bytes.begin() + static_cast<std::ptrdiff_t>(offset),
                    [](char c, std::uint8_t byte) { return static_cast<std::uint8_t>(c) == byte; });
}

ImageProbe broken(ImageProbe probe, const char* problem) {
  probe.state = ImageProbe::State::broken;
  probe.problem = problem;
  return probe;
}

/// PNG (third edition), section 5: length, type, data, and 4 bytes of CRC a chunk.
ImageProbe probe_png(Bytes bytes, std::size_t steps) {
  ImageProbe probe{ImageProbe::State::cut_off, "image/png"};
  bool has_header = false;
  for (std::size_t at = 8; steps-- > 0 && bytes.size() - at >= 8;) {
    const std::uint32_t length = big_endian(bytes, at, 4);
    if (begins_with(bytes, at + 4, "IDAT")) {
      if (!has_header) return broken(probe, "there is no header before the pixels");
      probe.state = ImageProbe::State::fine;
      return probe;
    }
    if (begins_with(bytes, at + 4, "IHDR")) {
      if (length != 13) return broken(probe, "its header has a wrong length");
      if (bytes.size() - at < 8 + 13) return probe;
      probe.width = big_endian(bytes, at + 8, 4);
      probe.height = big_endian(bytes, at + 12, 4);
      has_header = true;
    }
    if (bytes.size() - at - 8 < std::uint64_t{length} + 4) return probe;
    at += 8 + std::size_t{length} + 4;
  }
  return probe;
}

/// Start-of-frame markers are C0 to CF but for tables (C4, CC) and the reserved C8 (ISO/IEC 10918-1, table
/// B.1).
bool is_frame(std::uint8_t marker) {
  return (marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc) ||
         marker == 0xde;
}

bool has_length(std::uint8_t marker) {
  return !(marker == 0x01 || (marker >= 0xd0 && marker <= 0xd9) || marker == 0xff);
}

ImageProbe probe_jpeg(Bytes bytes, std::size_t steps) {
  ImageProbe probe{ImageProbe::State::cut_off, "image/jpeg"};
  for (std::size_t at = 2; steps-- > 0 && bytes.size() - at >= 2;) {
    if (bytes[at] != 0xff) return broken(probe, "a segment does not begin with a marker");
    const std::uint8_t marker = bytes[at + 1];
    if (!has_length(marker)) {
      at += marker == 0xff ? 1 : 2;
      continue;
    }
    if (bytes.size() - at < 4) return probe;
    const std::size_t length = big_endian(bytes, at + 2, 2);
    if (length < 2) return broken(probe, "a segment has a wrong length");
    if (bytes.size() - at < 2 + length) return probe;
    if (is_frame(marker)) {
      if (length < 8) return broken(probe, "its frame header is too short");
      const std::uint8_t channels = bytes[at + 9];
      if (channels != 1 && channels != 3) return broken(probe, "it has neither one nor three channels");
      probe.height = big_endian(bytes, at + 5, 2);
      probe.width = big_endian(bytes, at + 7, 2);
      probe.state = ImageProbe::State::fine;
      return probe;
    }
    at += 2 + length;
  }
  return probe;
}

/// RFC 9649, section 2: the first chunk is VP8X, VP8L or VP8 and has the size at a place of its own.
ImageProbe probe_webp(Bytes bytes) {
  ImageProbe probe{ImageProbe::State::cut_off, "image/webp"};
  if (bytes.size() < 30) return probe;
  probe.state = ImageProbe::State::fine;
  if (begins_with(bytes, 12, "VP8X")) {
    probe.width = little_endian(bytes, 24, 3) + 1;
    probe.height = little_endian(bytes, 27, 3) + 1;
  } else if (begins_with(bytes, 12, "VP8L")) {
    const std::uint32_t bits = little_endian(bytes, 21, 4);
    probe.width = (bits & 0x3fffu) + 1;
    probe.height = (bits >> 14 & 0x3fffu) + 1;
  } else if (begins_with(bytes, 12, "VP8 ")) {
    probe.width = little_endian(bytes, 26, 2) & 0x3fffu;
    probe.height = little_endian(bytes, 28, 2) & 0x3fffu;
  } else {
    return broken(probe, "its first chunk is unknown");
  }
  return probe;
}

}  // namespace

std::string_view detect_mime_type(Bytes bytes) {
  constexpr std::size_t kLeastBytes = 14;
  if (bytes.size() < kLeastBytes) return {};
  if (begins_with(bytes, 0, "\xff\xd8\xff")) return "image/jpeg";
  if (begins_with(bytes, 0, "\x89PNG\r\n\x1a\n")) return "image/png";
  if (begins_with(bytes, 0, "RIFF") && begins_with(bytes, 8, "WEBPVP")) return "image/webp";
  return {};
}

ImageProbe probe_image(Bytes bytes, std::size_t steps) {
  const std::string_view mime_type = detect_mime_type(bytes);
  if (mime_type.empty()) return {};
  const ImageProbe probe = mime_type == "image/png"    ? probe_png(bytes, steps)
                           : mime_type == "image/jpeg" ? probe_jpeg(bytes, steps)
                                                       : probe_webp(bytes);
  const bool is_empty = probe.state == ImageProbe::State::fine && (probe.width == 0 || probe.height == 0);
  return is_empty ? broken(probe, "its width or height is 0") : probe;
}

}  // namespace barrido::scene::validation
