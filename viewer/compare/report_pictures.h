// What the report shows of a pair: pictures of bytes, whatever the files hold. Must not know: HTML.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "viewer/compare/compare_pair.h"

namespace barrido::compare {

/// A picture as PNG; empty where there is none to show.
using Png = std::vector<std::uint8_t>;

struct ReportPictures {
  Png expected, actual;
  Png difference;  ///< |expected − actual| times `amplification`.
  Png flip;        ///< False colours: black 0, through violet, red and orange, to pale yellow 1.
  int amplification = 1;
  double exposure = 0.0;  ///< Floats are shown brightened by so many stops, then encoded as sRGB.
};

/// Pictures of a pair whose pixels are at hand; nothing of pairs that are equal.
ReportPictures report_pictures(const ComparedPair& pair);

}  // namespace barrido::compare
