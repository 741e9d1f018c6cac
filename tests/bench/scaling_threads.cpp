#include "tests/bench/scaling_threads.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "tests/bench/machine.h"

namespace barrido::bench {
namespace {

using nlohmann::json;

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ",") + word;
  return text;
}

/// Runs this program silently. @throws std::runtime_error unless it ends well.
void run_self(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "barrido-bench");
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t process = 0;
  const int failed = posix_spawn(&process, "/proc/self/exe", &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  if (failed != 0 || waitpid(process, &status, 0) != process || status != 0) {
    throw std::runtime_error("a process for another number of threads failed");
  }
}

json measure_with(int threads, const Options& options, const std::string& file) {
  std::vector<std::string> only = options.only;
  if (only.empty()) only = {"W3", "W4", "W5", "W6", "W7", "W8", "W9", "W14"};
  std::vector<std::string> arguments{
      "--threads",    std::to_string(threads),
      "--simd",       options.simd,
      "--only",       joined(only),
      "--resolution", std::to_string(options.scale.width) + "," + std::to_string(options.scale.height),
      "--seconds",    std::to_string(options.harness.seconds),
      "--json",       file};
  if (options.no_peer) arguments.emplace_back("--no-peer");
  run_self(std::move(arguments));
  return json::parse(std::ifstream(file));
}

Measurement row_of(const json& entry, int threads) {
  Measurement row;
  row.id = entry.at("id").get<std::string>() + ", " + std::to_string(threads) +
           (threads == 1 ? " thread" : " threads");
  row.title = entry.at("title").get<std::string>();
  row.barrido = {entry.at("barrido_ms").get<double>(), entry.at("barrido_best_ms").get<double>()};
  if (entry.contains("osmesa_ms")) {
    row.peer = Timing{entry.at("osmesa_ms").get<double>(), entry.at("osmesa_best_ms").get<double>()};
  }
  return row;
}

}  // namespace

Table scaling_by_threads(const Options& options) {
  Table table{"threads", "Threads", {}};
  print_header(table);
  const std::string file =
      (std::filesystem::temp_directory_path() / ("barrido-bench-" + std::to_string(getpid()) + ".json"))
          .string();
  const int most = static_cast<int>(std::max(1u, processor_threads()));
  for (int threads = 1; threads <= most; threads = std::max(threads + 1, std::min(threads * 2, most))) {
    const json report = measure_with(threads, options, file);
    for (const json& entry : report.at("workloads")) {
      table.rows.push_back(row_of(entry, threads));
      print_row(table.rows.back());
    }
  }
  std::filesystem::remove(file);
  return table;
}

}  // namespace barrido::bench
