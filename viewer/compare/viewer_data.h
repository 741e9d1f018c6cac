// What the report's viewer is told of each pair, as JSON inside the page. Must not know: HTML around it,
// pixels.
#pragma once

#include <string>
#include <vector>

#include "viewer/compare/run.h"

namespace barrido::compare {

/// Which pictures of a pair the report holds, as the names of the elements they stand in; empty: none.
struct Shown {
  std::string expected, actual, difference, flip;
  int amplification = 1;
  double exposure = 0.0;
};

/// A JSON array, worst first, without "<", so that nothing in it can end the element around it.
std::string viewer_data(const Run& run, const std::vector<Shown>& shown);

}  // namespace barrido::compare
