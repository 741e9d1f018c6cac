// Bytes as the text that reports can hold.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace barrido::compare {

/// `text` with U+FFFD in place of each byte that is not part of a well-formed character, and of U+FFFE and
/// U+FFFF, which XML cannot hold (RFC 3629, section 4). Names of files may hold any bytes, reports only
/// UTF-8.
std::string valid_utf8(std::string_view text);

/// RFC 4648, section 4.
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace barrido::compare
