// The pieces of a frame one by one, timed by Google Benchmark.
#pragma once

namespace barrido::bench {

/// Takes the program's arguments: "--pieces" and options of Google Benchmark's, e.g. --benchmark_filter=png.
/// @return the program's exit status.
int run_pieces(int argc, char** argv);

}  // namespace barrido::bench
