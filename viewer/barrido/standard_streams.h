// Standard output and error as file descriptors: every byte is written or the failure is known, which
// buffered streams only tell at the end, if at all.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace barrido::cli {

inline constexpr int kStandardOutput = 1;
inline constexpr int kStandardError = 2;

/// To be called first in main: a closed pipe becomes an error of the write instead of a signal that kills the
/// program, and standard descriptors that are closed are occupied, so that no file gets their numbers.
void prepare_standard_streams();

/// Writes all of `bytes`. @return 0, or errno of the write that failed.
int write_all(int descriptor, std::span<const std::uint8_t> bytes);

/// @throws scene::InputError "standard output: Broken pipe".
void write_standard_output(std::span<const std::uint8_t> bytes);

/// The bytes of a text.
std::span<const std::uint8_t> bytes_of(std::string_view text);

/// `text` with control characters, which would break or recolour lines, written as \n or \x1b.
std::string on_one_line(std::string_view text);

}  // namespace barrido::cli
