// The tables of a run as JSON, with the facts without which they mean nothing.
#pragma once

#include <string>
#include <vector>

#include "tests/bench/machine.h"
#include "tests/bench/measure.h"

namespace barrido::bench {

/// The tables under their names; "workloads" is a list, and so is "models"; the others are in "scaling".
std::string json_report(const std::vector<Table>& tables, const Limits& limits, const Options& options);

/// Writes under a temporary name, then renames. @throws scene::InputError, which names the file.
void write_text(const std::string& path, const std::string& text);

/// @throws scene::InputError when no file can be made there; called before anything is measured.
void check_writable(const std::string& path);

}  // namespace barrido::bench
