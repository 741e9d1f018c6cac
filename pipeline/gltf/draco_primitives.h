// Primitives compressed by Draco (KHR_draco_mesh_compression).
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "pipeline/gltf/document.h"

namespace barrido::scene::gltf {

/// The elements of every accessor that a compressed primitive fills. The accessors of one that cannot be
/// decoded keep those of their buffer views, with a warning, or get a problem. @throws LimitError.
std::map<int, DecodedAccessor> decode_draco_primitives(Report& report, const Document& document,
                                                       std::vector<std::optional<Problem>>& problems);

}  // namespace barrido::scene::gltf
