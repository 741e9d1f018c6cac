// What a run of barrido-bench was asked for. Plain data.
#pragma once

#include <string>
#include <vector>

#include "tests/bench/harness.h"
#include "tests/bench/workloads.h"

namespace barrido::bench {

struct Options {
  int threads = 1;
  std::string simd = "auto";
  bool no_peer = false;
  Scale scale;
  HarnessOptions harness;

  bool run_workloads = true;
  std::vector<std::string> only;  ///< Ids of workloads; empty: all.
  std::string scaling;            ///< A name of scaling_names(), "all", or empty: none.
  bool run_models = false;
  std::string models = "../shared/assets/models";  ///< Folder with models besides the project's own.

  std::string json;  ///< File to write; empty: none.
};

}  // namespace barrido::bench
