// Small sins of files: properties that glTF 2.0 lets be absent, of a kind or a value that it does not allow.
// They are taken out with a warning, so that the rest is drawn. Knows nothing of what the properties do.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "pipeline/gltf/report.h"

namespace barrido::scene::gltf {

/// Before any other look at the document, which may hold anything.
void forgive_small_sins(Report& report, nlohmann::json& document);

}  // namespace barrido::scene::gltf
