// A run for programs: as JSON, and as JUnit XML, which CI systems show as a list of tests.
#pragma once

#include <string>
#include <string_view>

#include "viewer/compare/run.h"

namespace barrido::compare {

/// Ends in a line feed. Figures that JSON cannot hold (the PSNR of equal pictures, infinite differences) are
/// null.
std::string json_report(const Run& run);

/// XML 1.0 in UTF-8, one test case a pair. Pairs that differ, are missing or are added are failures; files
/// that cannot be read, errors.
std::string junit_report(const Run& run);

/// `text` for an attribute or for text of XML; what XML 1.0 cannot hold (control characters, bytes that are
/// no UTF-8) becomes U+FFFD.
std::string escape_xml(std::string_view text);

}  // namespace barrido::compare
