// What has to be known of a .gltf or .glb file before any parser sees it: where its JSON and its binary chunk
// are, and that the JSON does not nest deeper than a recursive parser can bear.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "pipeline/gltf/report.h"

namespace barrido::scene::gltf {

struct Container {
  std::string_view json;
  std::optional<std::span<const std::uint8_t>> binary_chunk;  ///< Absent in .gltf and in a GLB without one.
};

/// Splits a file by its content, not its name: GLB when it begins with "glTF", else JSON (glTF 2.0, section
/// 4.4). The results view `file`. @throws InputError when lengths, version or chunk types are wrong.
Container split_container(Report& report, std::span<const std::uint8_t> file);

/// How much there is in a JSON text, before it is parsed.
struct JsonShape {
  std::uint64_t objects = 0;
  std::uint64_t values = 0;  ///< Objects and arrays too; at least as many as there are.
};

/// @throws InputError when arrays and objects nest deeper than `max_depth`.
JsonShape check_json_depth(const Report& report, std::string_view json, int max_depth);

}  // namespace barrido::scene::gltf
