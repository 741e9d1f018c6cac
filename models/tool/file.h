// Whole files in and out.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace barrido::models {

/// @throws std::runtime_error naming the file.
std::vector<std::uint8_t> read_file(const std::filesystem::path& path);
/// Makes the folder when there is none. @throws std::runtime_error naming the file.
void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

}  // namespace barrido::models
