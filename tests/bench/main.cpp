// barrido-bench: times Barrido beside OSMesa in one process and prints tables: the workloads, scaling runs,
// real models; and, by Google Benchmark, the pieces.
#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include <tbb/global_control.h>
#include <CLI/CLI.hpp>

#include "raster/base/simd_target.h"
#include "tests/bench/json_report.h"
#include "tests/bench/machine.h"
#include "tests/bench/models.h"
#include "tests/bench/peer.h"
#include "tests/bench/pieces.h"
#include "tests/bench/scaling.h"

namespace barrido::bench {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

void check_workloads(const std::vector<std::string>& ids) {
  std::vector<std::string> known;
  for (const Workload& workload : workloads()) known.push_back(workload.id);
  for (const std::string& id : ids) {
    if (std::find(known.begin(), known.end(), id) == known.end()) {
      throw std::invalid_argument("--only: there is no workload '" + id + "'; there are " + joined(known));
    }
  }
}

void choose_simd(const std::string& name) {
  std::vector<std::string> known{"auto"};
  for (const raster::SimdTarget target : raster::available_simd_targets()) {
    known.emplace_back(raster::name_of(target));
    if (known.back() == name) raster::set_simd_target(target);
  }
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    throw std::invalid_argument("--simd: '" + name + "' is not to be had here; there are " + joined(known));
  }
}

Measurement measure(const Workload& workload, const Options& options, const Limits& limits) {
  const ScenePair scene = workload.build(options.scale);
  Measurement row = measure(scene, options);
  row.id = workload.id;
  row.title = workload.title;
  row.goal = workload.goal;
  std::size_t triangles = 0;
  for (const DrawCall& draw : scene.draws) triangles += draw.mesh.element_count() / 3;
  if (workload.unit == Unit::triangles) {
    row.millions = 1e-6 * static_cast<double>(triangles);
    row.unit = "Mtri/s";
  } else {
    const std::size_t layers = std::max<std::size_t>(1, scene.draws.size());
    row.millions = 1e-6 * scene.width * scene.height * static_cast<double>(layers);
    row.unit = "Mpix/s";
    row.limit_ms = scene.draws.empty() ? limits.memset_ms : limits.store_ms(row.millions);
  }
  return row;
}

Table run_workloads(const Options& options, const Limits& limits) {
  Table table{"workloads", "Workloads (M/s: millions of pixels or triangles a second)", {}};
  print_header(table);
  for (const Workload& workload : workloads()) {
    const auto& only = options.only;
    if (!only.empty() && std::find(only.begin(), only.end(), workload.id) == only.end()) continue;
    table.rows.push_back(measure(workload, options, limits));
    print_row(table.rows.back());
  }
  print_total(table);
  return table;
}

void run(const Options& options) {
  check_workloads(options.only);
  if (!options.json.empty()) check_writable(options.json);
  choose_simd(options.simd);
  set_peer_threads(options.threads);
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(options.threads));
  const Limits limits = measure_limits(options.scale.width, options.scale.height, options.harness);
  std::printf("%s, %u threads; %d used, %s\n", processor_model().c_str(), processor_threads(),
              options.threads, std::string(raster::name_of(raster::simd_target())).c_str());
  std::printf("peer: %s\n", options.no_peer ? "not asked for" : peer_description().c_str());
  std::printf("%dx%d; memset of colour and depth %.2f ms, store in a cached tile %.1f Gpix/s\n",
              options.scale.width, options.scale.height, limits.memset_ms, limits.store_mpix_per_s * 1e-3);

  std::vector<Table> tables;
  if (options.run_workloads) tables.push_back(run_workloads(options, limits));
  for (const std::string& name : scaling_names()) {
    if (options.scaling != name && options.scaling != "all") continue;
    for (Table& table : run_scaling(name, options)) tables.push_back(std::move(table));
  }
  if (options.run_models) tables.push_back(run_models(options));
  if (!options.json.empty()) write_text(options.json, json_report(tables, limits, options));
}

void add_options(CLI::App& app, Options& options) {
  app.add_option("--threads", options.threads, "Threads of both renderers. Default 1")
      ->check(CLI::Range(1, 256));
  app.add_option("--only", options.only, "Workloads, e.g. W1,W5. Default: all")->delimiter(',');
  app.add_option("--simd", options.simd, "auto, scalar, sse4, avx2, avx512 or neon");
  app.add_option("--seconds", options.harness.seconds, "For each row. Default 2")
      ->check(CLI::Range(0.0, 1e4));
  app.add_flag("--no-peer", options.no_peer, "Barrido alone");
  app.add_option_function<std::vector<int>>(
         "--resolution",
         [&options](const std::vector<int>& sides) {
           options.scale = {sides[0], sides[1]};
         },
         "W,H of the workloads. Default 1920,1080")
      ->delimiter(',')
      ->expected(2)
      ->check(CLI::Range(1, 16384));
  std::vector<std::string> series = scaling_names();
  series.emplace_back("all");
  app.add_option("--scaling", options.scaling, "Scaling runs in place of the workloads: " + joined(series))
      ->expected(0, 1)
      ->default_str("all")
      ->check(CLI::IsMember(series));
  app.add_option("--models", options.models,
                 "Real models in place of the workloads: the project's and those of a folder, by default "
                 "../shared/assets/models")
      ->expected(0, 1)
      ->default_str(options.models);
  app.add_option("--json", options.json,
                 "Also write the tables, and the machine they are from, to this file");
}

}  // namespace
}  // namespace barrido::bench

int main(int argc, char** argv) {
  using namespace barrido::bench;
  Options options;
  CLI::App app{"Times Barrido beside OSMesa's llvmpipe", "barrido-bench"};
  add_options(app, options);
  bool pieces = false;  // decided before the options are parsed; here for --help
  app.add_flag("--pieces", pieces,
               "The pieces, by Google Benchmark, which takes the other options (--benchmark_…)");
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]) == "--pieces") return run_pieces(argc, argv);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  options.run_models = app.count("--models") > 0;
  options.run_workloads = app.count("--scaling") == 0 && !options.run_models;
  try {
    run(options);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "barrido-bench: %s\n", error.what());
    return 2;
  }
}
