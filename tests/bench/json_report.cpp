#include "tests/bench/json_report.h"

#include <unistd.h>

#include <filesystem>

#include <nlohmann/json.hpp>

#include "pipeline/files/error.h"
#include "pipeline/files/write_file.h"
#include "raster/base/simd_target.h"
#include "tests/bench/peer.h"

namespace barrido::bench {
namespace {

using nlohmann::json;

json to_json(const Measurement& m) {
  json entry{{"id", m.id},
             {"title", m.title},
             {"barrido_ms", m.barrido.median_ms},
             {"barrido_best_ms", m.barrido.best_ms}};
  if (m.peer) {
    entry["osmesa_ms"] = m.peer->median_ms;
    entry["osmesa_best_ms"] = m.peer->best_ms;
    entry["ratio"] = m.ratio();
  }
  if (m.unlike) {
    entry["difference"] = {{"largest_of_255", m.unlike->largest},
                           {"mean_of_255", m.unlike->mean},
                           {"far_ppm", m.unlike->far_ppm}};
  }
  if (m.goal > 0) entry["goal"] = m.goal;
  if (m.millions > 0) entry[m.unit == "Mpix/s" ? "mpix_per_s" : "mtri_per_s"] = m.throughput();
  if (m.limit_ms > 0) entry["limit_ms"] = m.limit_ms;
  return entry;
}

json machine(const Limits& limits, const Options& options) {
  return {
      {"processor", processor_model()},
      {"processor_threads", processor_threads()},
      {"threads", options.threads},
      {"simd", raster::name_of(raster::simd_target())},
      {"peer", options.no_peer ? "not asked for" : peer_description()},
      {"resolution", {options.scale.width, options.scale.height}},
      {"limits",
       {{"memset_of_frame_ms", limits.memset_ms}, {"store_in_tile_mpix_per_s", limits.store_mpix_per_s}}}};
}

}  // namespace

std::string json_report(const std::vector<Table>& tables, const Limits& limits, const Options& options) {
  json report{{"machine", machine(limits, options)}, {"workloads", json::array()}};
  for (const Table& table : tables) {
    json rows = json::array();
    for (const Measurement& row : table.rows) rows.push_back(to_json(row));
    const bool has_own_key = table.name == "workloads" || table.name == "models";
    (has_own_key ? report[table.name] : report["scaling"][table.name]) = std::move(rows);
    if (table.name == "workloads" && geometric_mean(table.rows) > 0) {
      report["geometric_mean_ratio"] = geometric_mean(table.rows);
    }
  }
  return report.dump(2) + '\n';
}

void write_text(const std::string& path, const std::string& text) {
  scene::write_file(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

void check_writable(const std::string& path) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(path).parent_path();
  if (fs::is_directory(path)) throw scene::InputError(path, "", "is a folder");
  if (!folder.empty() && !fs::is_directory(folder))
    throw scene::InputError(path, "", "its folder does not exist");
  if (::access(folder.empty() ? "." : folder.c_str(), W_OK) != 0) {
    throw scene::InputError(path, "", "its folder cannot be written to");
  }
}

}  // namespace barrido::bench
