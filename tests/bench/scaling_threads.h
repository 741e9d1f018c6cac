// The workloads with 1, 2, 4 … threads. The peer reads its number of threads once in a process, so that every
// number is measured by a process of its own: this program with --threads and --json.
#pragma once

#include "tests/bench/measure.h"

namespace barrido::bench {

/// Measures `options.only`, or W3 to W9 and W14, with every number of threads up to the processor's.
/// @throws std::runtime_error when a process fails.
Table scaling_by_threads(const Options& options);

}  // namespace barrido::bench
