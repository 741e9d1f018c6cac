// Compares a parsed JSON document with the tables of schema.h before anything is read from it.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "pipeline/gltf/report.h"

namespace barrido::scene::gltf {

/// Afterwards every property that drawing reads has its type and number of items, and the range that drawing
/// needs, required ones are there, and every index is below the size of the array it refers to. Whole numbers
/// written as 3.0 become integers. @throws InputError naming the first property that is wrong.
void check_document(Report& report, nlohmann::json& document);

}  // namespace barrido::scene::gltf
