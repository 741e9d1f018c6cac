// The GLB container's numbers (glTF 2.0, section 4.4), which are little-endian. Knows no rules.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace barrido::scene::glb {

inline constexpr std::uint32_t kMagic = 0x46546c67;        // "glTF"
inline constexpr std::uint32_t kJsonChunk = 0x4e4f534a;    // "JSON"
inline constexpr std::uint32_t kBinaryChunk = 0x004e4942;  // "BIN\0"
inline constexpr std::size_t kHeaderBytes = 12;
inline constexpr std::size_t kChunkHeaderBytes = 8;

/// The four bytes from `offset` on, which must be there.
inline std::uint32_t read_u32(std::span<const std::uint8_t> bytes, std::size_t offset) {
  return static_cast<std::uint32_t>(bytes[offset]) | static_cast<std::uint32_t>(bytes[offset + 1]) << 8 |
         static_cast<std::uint32_t>(bytes[offset + 2]) << 16 |
         static_cast<std::uint32_t>(bytes[offset + 3]) << 24;
}

}  // namespace barrido::scene::glb
