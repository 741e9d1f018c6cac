// SHA-256 (FIPS 180-4) of bytes: the name of a frame's pixels that two machines can compare. None of the
// libraries in use offers it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace barrido::sheet {

std::array<std::uint8_t, 32> sha256(std::span<const std::uint8_t> bytes);

/// The same as 64 lower-case hexadecimal digits.
std::string sha256_hex(std::span<const std::uint8_t> bytes);

}  // namespace barrido::sheet
