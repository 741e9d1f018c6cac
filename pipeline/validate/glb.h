// The GLB container (glTF 2.0, section 4.4), chunk by chunk, with everything that is wrong with it. The
// importer stops at the first fault (gltf/container.h); this goes on as far as there are bytes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "pipeline/validate/issues.h"

namespace barrido::scene::validation {

struct Chunks {
  std::string_view json;
  bool has_json = false;  ///< Not where nothing follows an empty one: it is not begun to be read.
  std::optional<std::span<const std::uint8_t>> binary;  ///< The BIN chunk.
};

/// The results view `file`. Nothing of a file whose header is wrong or that ends too early.
Chunks read_glb(Issues& issues, std::span<const std::uint8_t> file);

}  // namespace barrido::scene::validation
