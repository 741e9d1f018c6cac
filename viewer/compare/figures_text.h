// Results as people read them, line by line as idiff prints them.
#pragma once

#include <string>

#include "viewer/compare/compare_pair.h"

namespace barrido::compare {

/// Six significant digits, as idiff: "0.0509804", "inf".
std::string figure(double value);

/// Three significant digits: "0.051", "12.5".
std::string short_figure(double value);

/// `part` of `whole` in percent.
double percent(std::uint64_t part, std::uint64_t whole);

/// "0.1, 0.2, 0.3": the values of the channels that were compared, in eight digits.
std::string values_text(const std::array<float, 4>& values, int channels);

/// The figures over several lines, each ending in a line feed, beginning with the note; empty when there are
/// none.
std::string figures_text(const Result& result, const Thresholds& thresholds);

/// One line: "different: max 0.2 at (12, 34), 3.1 % of the pixels, FLIP 0.012".
std::string headline(const Result& result);

}  // namespace barrido::compare
