// Buffer views that hold compressed bytes (EXT_meshopt_compression, KHR_meshopt_compression).
#pragma once

#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "pipeline/gltf/document.h"

namespace barrido::scene::gltf {

/// The extension's object of a buffer view, null where it is not compressed.
const nlohmann::json* compression_of(const nlohmann::json& buffer_view);

/// The decoded bytes of every compressed view, byteLength of each at least. A view that cannot be decoded
/// keeps the bytes of its own buffer, with a warning, or gets a problem. @throws LimitError.
std::map<int, ByteBlock> decode_compressed_views(Report& report, const Document& document,
                                                 std::vector<std::optional<Problem>>& problems);

}  // namespace barrido::scene::gltf
