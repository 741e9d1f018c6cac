#include "viewer/compare/find_pairs.h"

#include <map>
#include <system_error>

#include "pipeline/files/error.h"
#include "pipeline/pictures/format.h"

namespace barrido::compare {
namespace {

namespace fs = std::filesystem;

bool is_picture_name(const fs::path& path) {
  const scene::FormatTraits* format = scene::format_by_extension(path);
  return format != nullptr && format->is_read;
}

bool is_hidden(const fs::path& path) { return path.filename().string().starts_with('.'); }

/// Calls `visit` with each picture below `folder`.
template <class Visit>
void walk(const fs::path& folder, Visit visit) {
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, error);
  const fs::recursive_directory_iterator end;
  while (!error && entry != end) {
    std::error_code ignored;
    const bool folder_inside = entry->is_directory(ignored);
    if (is_hidden(entry->path())) {
      if (folder_inside) entry.disable_recursion_pending();
    } else if (!folder_inside && is_picture_name(entry->path())) {
      visit(entry->path());
    }
    entry.increment(error);
  }
  if (error) throw scene::InputError(folder.string(), "", "cannot be read: " + error.message());
}

fs::file_status status_of(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    const std::string reason = error ? error.message() : "No such file or directory";
    throw scene::InputError(path.string(), "", "cannot be read: " + reason);
  }
  return status;
}

}  // namespace

std::vector<Pair> find_pairs(const fs::path& expected, const fs::path& actual, MissingExpected missing) {
  std::error_code ignored;
  const bool nothing_yet =
      missing == MissingExpected::is_empty && !fs::exists(fs::symlink_status(expected, ignored));
  const bool actual_is_folder = fs::is_directory(status_of(actual));
  const bool expected_is_folder = nothing_yet ? actual_is_folder : fs::is_directory(status_of(expected));
  if (expected_is_folder != actual_is_folder) {
    const fs::path& folder = expected_is_folder ? expected : actual;
    const fs::path& file = expected_is_folder ? actual : expected;
    throw scene::InputError(folder.string(), "",
                            "is a folder and cannot be compared with the file " + file.string());
  }
  if (!expected_is_folder) {
    return {{actual.filename().string(), nothing_yet ? fs::path() : expected, actual, expected}};
  }

  std::map<std::string, Pair> pairs;
  const auto name_in = [](const fs::path& path, const fs::path& folder) {
    return path.lexically_relative(folder).generic_string();
  };
  if (!nothing_yet)
    walk(expected, [&](const fs::path& path) { pairs[name_in(path, expected)].expected = path; });
  walk(actual, [&](const fs::path& path) { pairs[name_in(path, actual)].actual = path; });
  if (pairs.empty()) {
    throw scene::InputError(expected.string(), "", "holds no pictures, and neither does " + actual.string());
  }
  std::vector<Pair> sorted;
  for (auto& [name, pair] : pairs) {
    pair.name = name;
    pair.target = expected / fs::path(name);
    sorted.push_back(std::move(pair));
  }
  return sorted;
}

}  // namespace barrido::compare
