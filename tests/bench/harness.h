// Times drawers side by side: in every round each draws once, so that whatever else the machine does meets
// all of them alike. Compares their pictures before any clock runs.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tests/bench/peer.h"
#include "tests/bench/workloads.h"

namespace barrido::bench {

/// How unlike two frames are.
struct Unlikeness {
  int largest = 0;     ///< Largest difference of a channel, in 1/255.
  double mean = 0;     ///< Mean over all channels, in 1/255.
  double far_ppm = 0;  ///< Pixels with a channel that differs by more than 8/255, parts per million.
};

Unlikeness compare(const crosscheck::Picture& a, const crosscheck::Picture& b);

struct Timing {
  double median_ms = 0;
  double best_ms = 0;
};

struct HarnessOptions {
  double seconds = 2.0;  ///< A workload is repeated for about this long, …
  int least_rounds = 7;  ///< … and at least so often.
  int most_rounds = 200;
};

/// One Timing a drawer, from interleaved rounds; null drawers give zeros.
std::vector<Timing> time_interleaved(std::span<Drawer* const> drawers, const HarnessOptions& options);

/// Milliseconds of the machine's own limit for clearing a frame of this size: memset of colour and depth.
Timing time_memset(int width, int height, const HarnessOptions& options);

}  // namespace barrido::bench
