// barrido-bench: times the workloads, Barrido beside OSMesa in one process, and prints a table.
#include <cstdio>
#include <fstream>
#include <iostream>
#include <optional>
#include <set>

#include <tbb/global_control.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "raster/simd_target.h"
#include "tests/bench/harness.h"
#include "tests/bench/workloads.h"

namespace barrido::bench {
namespace {

struct Options {
  int threads = 1;
  std::vector<std::string> only;
  std::string simd = "auto";
  std::string json;
  bool no_peer = false;
  Scale scale;
  HarnessOptions harness;
};

struct Result {
  const Workload* workload;
  Timing barrido, peer;
  std::optional<Unlikeness> unlike;
  double limit_ms = 0;  ///< Of a clear; 0 elsewhere.
};

Result measure(const Workload& workload, const Options& options) {
  const ScenePair scene = workload.build(options.scale);
  const std::unique_ptr<Drawer> ours = make_barrido_drawer(scene);
  const std::unique_ptr<Drawer> theirs = options.no_peer ? nullptr : make_peer_drawer(scene);
  Result result{&workload, {}, {}, {}};
  ours->draw();
  if (theirs) {
    theirs->draw();
    result.unlike = compare(ours->picture(), theirs->picture());
  }
  Drawer* const drawers[] = {ours.get(), theirs.get()};
  const std::vector<Timing> timings = time_interleaved(drawers, options.harness);
  result.barrido = timings[0];
  result.peer = timings[1];
  if (scene.draws.empty()) {
    result.limit_ms = time_memset(scene.width, scene.height, options.harness).median_ms;
  }
  return result;
}

void print(const Result& r) {
  std::printf("%-4s %-34s %8.2f %8.2f", r.workload->id.c_str(), r.workload->title.c_str(),
              r.barrido.median_ms, r.barrido.best_ms);
  if (r.unlike) {
    std::printf(" %9.2f %7.2fx %6.0fx  %4d %6.3f %8.1f", r.peer.median_ms,
                r.peer.median_ms / r.barrido.median_ms, r.workload->goal, r.unlike->largest, r.unlike->mean,
                r.unlike->far_ppm);
  }
  if (r.limit_ms > 0) std::printf("   memset %.2f ms", r.limit_ms);
  std::printf("\n");
  std::fflush(stdout);
}

nlohmann::json to_json(const std::vector<Result>& results) {
  nlohmann::json list = nlohmann::json::array();
  for (const Result& r : results) {
    nlohmann::json entry{
        {"id", r.workload->id}, {"title", r.workload->title}, {"barrido_ms", r.barrido.median_ms}};
    if (r.unlike) {
      entry["osmesa_ms"] = r.peer.median_ms;
      entry["ratio"] = r.peer.median_ms / r.barrido.median_ms;
    }
    list.push_back(std::move(entry));
  }
  return {{"workloads", list}};
}

int run(const Options& options) {
  raster::SimdTarget target = raster::SimdTarget::automatic;
  for (raster::SimdTarget t : raster::available_simd_targets()) {
    if (raster::name_of(t) == options.simd) target = t;
  }
  raster::set_simd_target(target);
  set_peer_threads(options.threads);
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(options.threads));
  std::printf("peer: %s\n", options.no_peer ? "not asked for" : peer_description().c_str());
  std::printf("%d thread(s), %dx%d\n", options.threads, options.scale.width, options.scale.height);
  std::printf("%-4s %-34s %8s %8s %9s %8s %7s  %4s %6s %8s\n", "", "", "median", "best", "OSMesa", "ratio",
              "goal", "max", "mean", "far ppm");
  const std::set<std::string> only(options.only.begin(), options.only.end());
  std::vector<Result> results;
  for (const Workload& workload : workloads()) {
    if (!only.empty() && !only.contains(workload.id)) continue;
    results.push_back(measure(workload, options));
    print(results.back());
  }
  if (!options.json.empty()) std::ofstream(options.json) << to_json(results).dump(2) << '\n';
  return 0;
}

}  // namespace
}  // namespace barrido::bench

int main(int argc, char** argv) {
  using namespace barrido::bench;
  Options options;
  CLI::App app{"Times Barrido's workloads beside OSMesa's llvmpipe", "barrido-bench"};
  app.add_option("--threads", options.threads, "Threads of both renderers")->check(CLI::Range(1, 256));
  app.add_option("--only", options.only, "Workloads, e.g. W1,W5")->delimiter(',');
  app.add_option("--simd", options.simd, "auto, scalar, sse4, avx2, avx512 or neon");
  app.add_option("--json", options.json, "Also write the table to this file");
  app.add_option("--seconds", options.harness.seconds, "For each workload");
  app.add_flag("--no-peer", options.no_peer, "Barrido alone");
  CLI11_PARSE(app, argc, argv);
  try {
    return run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "barrido-bench: %s\n", error.what());
    return 2;
  }
}
