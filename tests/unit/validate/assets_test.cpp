// The reference validator's own test files, sample models, and files made to do harm. What differs from the
// reference is listed in docs/validate.md, and nowhere else.
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "tests/unit/validate/validate_support.h"

namespace barrido::scene::test {
namespace {

namespace fs = std::filesystem;

std::string read_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The cells of a line between tabulators or, in a table of Markdown, bars.
std::vector<std::string> cells_of(const std::string& line, char separator) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, separator);) {
    const std::size_t first = cell.find_first_not_of(" `"), last = cell.find_last_not_of(" `");
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
  }
  return cells;
}

/// The first cell of every row below a heading of docs/validate.md.
std::set<std::string> listed_below(const std::string& heading) {
  std::istringstream doc(read_text(fs::path(BARRIDO_SOURCE_DIR) / "docs/validate.md"));
  std::set<std::string> rows;
  bool below = false;
  for (std::string line; std::getline(doc, line);) {
    if (line.starts_with("#")) below = line == heading;
    if (below && line.starts_with("| `")) rows.insert(cells_of(line, '|').at(1));
  }
  return rows;
}

struct Expected {
  std::string file;
  std::size_t errors, warnings;
  std::string error_codes;
};

std::vector<Expected> expected_of_reference() {
  std::vector<Expected> all;
  std::istringstream table(read_text(assets_folder() / "validator/EXPECTED.tsv"));
  std::string line;
  std::getline(table, line);
  while (std::getline(table, line)) {
    auto cells = cells_of(line, '\t');
    cells.resize(4);
    all.push_back({cells[0], std::stoul(cells[1]), std::stoul(cells[2]), cells[3]});
  }
  return all;
}

std::string error_codes(const ValidationReport& report) {
  std::set<std::string> codes;
  for (const Issue& issue : report.issues.list()) {
    if (issue.severity == Severity::error) codes.insert(std::string(issue.code));
  }
  std::string text;
  for (const std::string& code : codes) text += (text.empty() ? "" : ",") + code;
  return text;
}

std::vector<std::string> reference_lines(const fs::path& report_path) {
  std::vector<std::string> lines;
  const json report = json::parse(read_text(report_path));
  for (const json& message : report["issues"]["messages"]) {
    const std::string place =
        message.contains("offset") ? "@" + message["offset"].dump() : message["pointer"].get<std::string>();
    lines.push_back(message["code"].get<std::string>() + " " + place);
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

class ValidateAssets : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(assets_folder())) GTEST_SKIP() << "needs the test assets in " << assets_folder();
  }
};

TEST_F(ValidateAssets, VerdictCodesAndCountsAreThoseOfTheReference) {
  const std::vector<Expected> files = expected_of_reference();
  EXPECT_EQ(files.size(), 246u);
  for (const Expected& expected : files) {
    const ValidationReport report = validate_gltf(assets_folder() / "validator" / expected.file);
    EXPECT_EQ(report.issues.count(Severity::error), expected.errors) << expected.file;
    EXPECT_EQ(report.issues.count(Severity::warning), expected.warnings) << expected.file;
    EXPECT_EQ(error_codes(report), expected.error_codes) << expected.file;
  }
}

TEST_F(ValidateAssets, EveryFindingIsThatOfTheReferenceButForTheListedFiles) {
  std::set<std::string> differing;
  for (const Expected& expected : expected_of_reference()) {
    const fs::path path = assets_folder() / "validator" / expected.file;
    if (lines_of(validate_gltf(path)) != reference_lines(path.string() + ".report.json"))
      differing.insert(expected.file);
  }
  EXPECT_EQ(differing, listed_below("## Where the findings differ"));
}

TEST_F(ValidateAssets, WhatHasNoErrorIsDrawnButForTheListedFiles) {
  std::set<std::string> refused;
  for (const Expected& expected : expected_of_reference()) {
    if (expected.errors > 0) continue;
    try {
      import_gltf(assets_folder() / "validator" / expected.file);
    } catch (const InputError&) {
      refused.insert(expected.file);
    }
  }
  EXPECT_EQ(refused, listed_below("## What has no error and is not drawn"));
}

std::vector<fs::path> models_below(const fs::path& folder) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path extension = entry.path().extension();
    if (extension == ".gltf" || extension == ".glb") paths.push_back(entry.path());
  }
  return paths;
}

TEST_F(ValidateAssets, SampleModelsHaveNoErrors) {
  for (const char* folder : {"models", "generator/Positive"}) {
    for (const fs::path& path : models_below(assets_folder() / folder)) {
      EXPECT_EQ(lines_of(validate_gltf(path), Severity::error), std::vector<std::string>{}) << path;
    }
  }
}

TEST_F(ValidateAssets, ModelsWithoutPositionsAreWarnedOfAndNotDrawn) {
  const auto paths = models_below(assets_folder() / "generator/Negative");
  EXPECT_EQ(paths.size(), 2u);
  for (const fs::path& path : paths) {
    const auto lines = lines_of(validate_gltf(path), Severity::warning);
    EXPECT_EQ(lines,
              std::vector<std::string>{"MESH_PRIMITIVE_NO_POSITION /meshes/0/primitives/0/attributes"});
    const Scene scene = import_gltf(path);
    EXPECT_EQ(scene.warnings, std::vector<std::string>{"a primitive without positions is not drawn"});
    for (const Mesh& mesh : scene.meshes) EXPECT_TRUE(mesh.primitives.empty());
  }
}

TEST_F(ValidateAssets, HostileFilesHaveReports) {
  const auto paths = models_below(assets_folder() / "hostile");
  EXPECT_GE(paths.size(), 60u);
  for (const fs::path& path : paths) {
    SCOPED_TRACE(path);
    const ValidationReport report = validate_gltf(path);
    EXPECT_LE(report.issues.list().size(), 100u);
  }
}

TEST(ValidateModels, TheProjectsOwnHaveNoErrors) {
  for (const fs::path& path : models_below(fs::path(BARRIDO_SOURCE_DIR) / "models")) {
    EXPECT_EQ(lines_of(validate_gltf(path), Severity::error), std::vector<std::string>{}) << path;
  }
}

}  // namespace
}  // namespace barrido::scene::test
