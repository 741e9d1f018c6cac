// The report of `barrido info --validate`: findings as text for people, and as JSON in the form of the
// Khronos validator's reports. Finds nothing itself.
#pragma once

#include <string>

#include "pipeline/validate/validate.h"

namespace barrido::cli {

/// Whether `barrido render` takes the file.
struct DrawingVerdict {
  bool drawn = true;
  std::string reason;  ///< Where it is refused.
};

/// One line a finding; those that differ in their numbers only are one line with their count. Ends in a line
/// feed.
std::string validation_text(const scene::ValidationReport& report, const DrawingVerdict& verdict);
/// A JSON object on several lines, ending in a line feed.
std::string validation_json(const scene::ValidationReport& report, const DrawingVerdict& verdict);

}  // namespace barrido::cli
