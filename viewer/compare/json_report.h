// A run as JSON, for programs.
#pragma once

#include <string>

#include "viewer/compare/run.h"

namespace barrido::compare {

/// Ends in a line feed. Figures that JSON cannot hold (the PSNR of equal pictures, infinite differences) are
/// null.
std::string json_report(const Run& run);

}  // namespace barrido::compare
