#include "viewer/compare/bless.h"

#include <fstream>
#include <iterator>
#include <system_error>

#include "pipeline/files/error.h"
#include "pipeline/files/write_file.h"

namespace barrido::compare {
namespace {

namespace fs = std::filesystem;

std::vector<std::uint8_t> read_bytes(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw scene::InputError(path.string(), "", "cannot be read");
  return bytes;
}

void make_folder_of(const fs::path& path) {
  std::error_code error;
  if (!path.has_parent_path()) return;
  fs::create_directories(path.parent_path(), error);
  if (error) throw scene::InputError(path.parent_path().string(), "", "cannot be made: " + error.message());
}

bool should_be_copied(const Result& result) {
  const bool differs = result.outcome == Outcome::different || result.outcome == Outcome::added ||
                       result.outcome == Outcome::error;
  return differs && result.actual.has_value();
}

}  // namespace

Blessed bless(const Run& run) {
  Blessed blessed;
  for (const Result& result : run.results) {
    if (result.outcome == Outcome::missing) blessed.kept.push_back(result.pair.expected);
    if (!should_be_copied(result)) continue;
    const fs::path& target = result.pair.target;
    if (target.extension() != result.pair.actual.extension()) {
      throw scene::InputError(target.string(), "",
                              "cannot become a copy of " + result.pair.actual.string() + ": another format");
    }
    make_folder_of(target);
    scene::write_file(target, read_bytes(result.pair.actual));
    (result.pair.expected.empty() ? blessed.added : blessed.replaced).push_back(target);
  }
  return blessed;
}

}  // namespace barrido::compare
