// What is fuzzed, by name. A target takes any bytes at all; it returns when the program did what it promises
// with them, and ends the process when not. Must not know who makes the bytes: libFuzzer, or the test that
// replays the corpus.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace barrido::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// Changes data[0, size) at will; at most `capacity` bytes afterwards. The same seed does the same.
/// @return the new size.
using Mutator = std::size_t (*)(std::uint8_t* data, std::size_t size, std::size_t capacity, unsigned seed);

struct Target {
  std::string_view name;
  void (*run)(Bytes bytes);
};

void run_gltf(Bytes bytes);   ///< The text of a .gltf file: imported, then drawn.
void run_glb(Bytes bytes);    ///< A .glb file likewise.
void run_image(Bytes bytes);  ///< A PNG or JPEG file: decoded, and what came out encoded and decoded again.
void run_accessor(Bytes bytes);  ///< Choices: buffers, views and accessors, read in every way.
void run_scene(Bytes bytes);     ///< Choices: draws, by the renderer and by the scalar reference.
void run_validate(Bytes bytes);  ///< A .gltf or .glb file, checked against the standard.
void run_draco(Bytes bytes);     ///< Counts and a stream of Draco, imported.
void run_meshopt(Bytes bytes);   ///< Counts, mode and filter, and a stream of meshoptimizer, imported.
void run_webp(Bytes bytes);      ///< A WebP file, decoded.
void run_diff(Bytes bytes);      ///< Choices: two pictures and thresholds, compared and reported.

inline constexpr Target kTargets[] = {
    {"gltf", run_gltf},         {"glb", run_glb},     {"validate", run_validate}, {"image", run_image},
    {"accessor", run_accessor}, {"scene", run_scene}, {"diff", run_diff},         {"draco", run_draco},
    {"meshopt", run_meshopt},   {"webp", run_webp}};

/// Ends the process, with the message on standard error, unless `holds`.
void require(bool holds, const std::string& message);

}  // namespace barrido::fuzz
