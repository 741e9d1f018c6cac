// Makes what came out what is expected: the only part of a comparison that changes a user's pictures.
#pragma once

#include <filesystem>
#include <vector>

#include "viewer/compare/run.h"

namespace barrido::compare {

/// What became of the expected pictures.
struct Blessed {
  std::vector<std::filesystem::path> replaced, added;
  std::vector<std::filesystem::path> kept;  ///< Only among the expected pictures: nothing is ever deleted.
};

/// Copies the actual picture of each pair that differs or is new over the expected one, whole or not at all,
/// and makes missing folders. A pair within the thresholds stays as it is; one whose actual picture cannot be
/// read, too.
/// @throws scene::InputError; what was copied before stays.
Blessed bless(const Run& run);

}  // namespace barrido::compare
