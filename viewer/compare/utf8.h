// Names of files as text: they may hold any bytes, reports only UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace barrido::compare {

/// `text` with U+FFFD in place of each byte that is not part of a well-formed character, and of U+FFFE and
/// U+FFFF, which XML cannot hold (RFC 3629, section 4).
std::string valid_utf8(std::string_view text);

}  // namespace barrido::compare
