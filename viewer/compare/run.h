// All results of one call, in numbers, and their order in reports. Must not know: formats of reports.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "viewer/compare/compare_pair.h"

namespace barrido::compare {

struct Run {
  std::string expected, actual;  ///< As the caller named them.
  Settings settings;
  std::vector<Result> results;  ///< By name.
};

/// How many results of each outcome.
struct Totals {
  std::array<std::size_t, 6> counts{};

  std::size_t operator[](Outcome outcome) const { return counts[static_cast<std::size_t>(outcome)]; }
  std::size_t all() const;
  /// Neither the same nor a warning.
  std::size_t failed() const;
};

Totals totals_of(const Run& run);

/// Indices into the results, worst first: by outcome, then by FLIP or, without it, the root mean square, then
/// by name.
std::vector<std::size_t> worst_first(const Run& run);

/// "3 pairs: 1 different, 2 same"; what there is none of is left out.
std::string totals_text(const Totals& totals);

}  // namespace barrido::compare
