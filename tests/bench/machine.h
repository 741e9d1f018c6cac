// The machine that figures come from, and its own limits for what a rasterizer cannot do without.
#pragma once

#include <string>

#include "tests/bench/harness.h"

namespace barrido::bench {

/// "AMD EPYC 9R14", from /proc/cpuinfo; "unknown" elsewhere.
std::string processor_model();
unsigned processor_threads();

struct Limits {
  double memset_ms = 0;         ///< Colour and depth of the whole frame, one thread.
  double store_mpix_per_s = 0;  ///< Depth test, colour and depth stored, in a tile that stays cached.
  double store_ms(double mpix) const { return mpix / store_mpix_per_s * 1e3; }
};

Limits measure_limits(int width, int height, const HarnessOptions& options);

}  // namespace barrido::bench
