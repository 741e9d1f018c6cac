// One HTML file with the whole run and its pictures inside; nothing is fetched when it is read.
#pragma once

#include <filesystem>
#include <vector>

#include "viewer/compare/spool.h"
#include "viewer/compare/viewer_data.h"

namespace barrido::compare {

class HtmlReport {
 public:
  /// The report will be `folder`/index.html; folders that are missing are made. @throws scene::InputError.
  explicit HtmlReport(std::filesystem::path folder);

  /// Keeps the pictures of the next result of the run. @throws scene::InputError.
  void add(const ComparedPair& pair);
  /// Writes the report; before, and when this fails, an older report stays as it was. @throws
  /// scene::InputError.
  void write(const Run& run);

 private:
  std::filesystem::path folder_;
  Spool pictures_;
  std::vector<Shown> shown_;
};

}  // namespace barrido::compare
