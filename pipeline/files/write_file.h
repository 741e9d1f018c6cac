// Files that appear whole or not at all. Enters: a path and either bytes or somebody who writes them. Must
// not know: formats.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>

namespace barrido::scene {

/// Calls `write` with the name of an empty file beside `path`, then renames that file to `path`; on any
/// failure the file is removed and `path` is as it was. Where `path` is a device or a pipe, `write` gets the
/// path itself. @throws InputError naming `path`, with the system's reason; passes on what `write` throws.
void write_atomically(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path&)>& write);

/// The same for bytes in memory. @throws InputError.
void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

}  // namespace barrido::scene
