// Small faulty files for the validator's tests, and what it finds in them as short lines.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/validate/validate.h"
#include "tests/unit/scene/import_support.h"

namespace barrido::scene::test {

using validation::Issue;
using validation::Severity;

/// "ACCESSOR_TOO_LONG /accessors/0", or "GLB_EXTRA_DATA @112".
inline std::string line_of(const Issue& issue) {
  const std::string place = issue.offset ? "@" + std::to_string(*issue.offset) : issue.pointer;
  return std::string(issue.code) + " " + place;
}

/// All findings but those below `least`, sorted.
inline std::vector<std::string> lines_of(const ValidationReport& report, Severity least = Severity::hint) {
  std::vector<std::string> lines;
  for (const Issue& issue : report.issues.list()) {
    if (issue.severity <= least) lines.push_back(line_of(issue));
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

inline ValidationReport validate_text(const std::string& text, const std::string& name = "model.gltf",
                                      const ValidateOptions& options = {}) {
  const TemporaryFolder folder;
  return validate_gltf(folder.write(name, text), options);
}

/// triangle() with everything that is good style: bounds and targets.
inline Model sound_triangle() {
  Model model = triangle();
  model.document["accessors"][0]["min"] = {0, 0, 0};
  model.document["accessors"][0]["max"] = {1, 1, 0};
  model.document["bufferViews"][0]["target"] = 34962;
  model.document["bufferViews"][1]["target"] = 34963;
  return model;
}

inline ValidationReport validate(const Model& model, const ValidateOptions& options = {}) {
  const TemporaryFolder folder;
  return validate_gltf(model.write_gltf(folder), options);
}

/// One fault made in a sound triangle, and what is to be found then: errors and warnings, sorted.
struct Fault {
  const char* name;
  std::function<void(Model&)> make;
  std::vector<std::string> expected;
};

inline void expect_found(const std::vector<Fault>& faults) {
  for (const Fault& fault : faults) {
    SCOPED_TRACE(fault.name);
    Model model = sound_triangle();
    fault.make(model);
    EXPECT_EQ(lines_of(validate(model), Severity::warning), fault.expected);
  }
}

}  // namespace barrido::scene::test
