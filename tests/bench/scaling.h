// How times grow: with triangles, lights, pixels, texels, threads. Each series is a table.
#pragma once

#include <string>
#include <vector>

#include "tests/bench/measure.h"

namespace barrido::bench {

/// "triangles", "lights", "resolution", "texture", "threads".
const std::vector<std::string>& scaling_names();

/// Measures and prints the tables of one series. @throws std::invalid_argument for an unknown name.
std::vector<Table> run_scaling(const std::string& name, const Options& options);

}  // namespace barrido::bench
