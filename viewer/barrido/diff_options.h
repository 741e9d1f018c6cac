// The options of `barrido diff`: what may be said, in the order of the help, and what was said, checked.
#pragma once

#include <span>
#include <string>

#include "viewer/barrido/arguments.h"
#include "viewer/barrido/call_limits.h"
#include "viewer/compare/compare_pair.h"
#include "viewer/compare/difference_picture.h"

namespace barrido::cli {

struct DiffOptions {
  bool help = false;
  bool quiet = false;
  bool bless = false;
  std::string expected, actual;
  std::string output;             ///< Difference picture; empty: none.
  std::string html, junit, json;  ///< Reports; empty: none. "-" is standard output (not for html).
  int threads = 0;                ///< 0: all
  LimitOptions limits;
  compare::Settings settings;
  compare::DifferenceOptions difference;
};

std::span<const OptionSyntax> diff_syntax();

/// Options of more than one letter may begin with one dash, as idiff's do. @throws UsageError.
DiffOptions parse_diff_options(std::span<const std::string> words);

}  // namespace barrido::cli
