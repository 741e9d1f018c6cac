// Faults in the numbers, and what keeps the validator from reading them for ever.
#include <limits>

#include "tests/unit/validate/validate_support.h"

namespace barrido::scene::test {
namespace {

const std::string kAttributes = "/meshes/0/primitives/0/attributes/";

/// A sound triangle whose attribute holds these numbers.
template <typename T>
auto attribute(const char* name, const std::vector<T>& values, ComponentType component_type,
               const char* type) {
  return [=](Model& m) {
    const int index = m.add_accessor(m.add_view(values), component_type, type, 3);
    primitive(m)["attributes"][name] = index;
  };
}

auto indices(const std::vector<std::uint16_t>& values) {
  return [=](Model& m) {
    const int view = m.add_view(values);
    m.document["bufferViews"][static_cast<std::size_t>(view)]["target"] = 34963;
    primitive(m)["indices"] = m.add_accessor(view, kU16, "SCALAR", values.size());
  };
}

TEST(ValidateData, Attributes) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  expect_found({
      {"minimum",
       [](Model& m) {
         m.document["accessors"][0]["min"] = {0, 0.25, -1};
       },
       {"ACCESSOR_ELEMENT_OUT_OF_MIN_BOUND /accessors/0/min/1", "ACCESSOR_MIN_MISMATCH /accessors/0/min/1",
        "ACCESSOR_MIN_MISMATCH /accessors/0/min/2"}},
      {"maximum",
       [](Model& m) {
         m.document["accessors"][0]["max"] = {0.5, 1, 0};
       },
       {"ACCESSOR_ELEMENT_OUT_OF_MAX_BOUND /accessors/0/max/0", "ACCESSOR_MAX_MISMATCH /accessors/0/max/0"}},
      {"NaN",
       attribute<float>("_OWN", {0, kNan, 0}, kF32, "SCALAR"),
       {"ACCESSOR_INVALID_FLOAT /accessors/2"}},
      {"normals",
       attribute<float>("NORMAL", {0, 0, 1, 0, 2, 0, 1, 0, 0}, kF32, "VEC3"),
       {"ACCESSOR_VECTOR3_NON_UNIT " + kAttributes + "NORMAL"}},
      {"colour",
       attribute<float>("COLOR_0", {0, 0, 1, 0, 1.5, 0, 1, 0, 0}, kF32, "VEC3"),
       {"ACCESSOR_NON_CLAMPED " + kAttributes + "COLOR_0"}},
      {"index", indices({0, 1, 3}), {"ACCESSOR_INDEX_OOB /meshes/0/primitives/0/indices"}},
      {"restart",
       indices({0, 1, 65535}),
       {"ACCESSOR_INDEX_OOB /meshes/0/primitives/0/indices",
        "ACCESSOR_INDEX_PRIMITIVE_RESTART /meshes/0/primitives/0/indices"}},
      {"degenerate triangles are no fault", indices({0, 1, 1}), {}},
  });
}

TEST(ValidateData, SparseElementsCount) {
  const auto sparse = [](const std::vector<std::uint16_t>& indices, const std::vector<float>& values) {
    return [=](Model& m) {
      m.document["accessors"][0]["sparse"] = {
          {"count", indices.size()},
          {"indices", {{"bufferView", m.add_view(indices)}, {"componentType", 5123}}},
          {"values", {{"bufferView", m.add_view(values)}}}};
    };
  };
  expect_found({
      {"sound", sparse({1}, {1, 0, 0}), {}},
      {"past the maximum",
       sparse({1}, {9, 0, 0}),
       {"ACCESSOR_ELEMENT_OUT_OF_MAX_BOUND /accessors/0/max/0", "ACCESSOR_MAX_MISMATCH /accessors/0/max/0"}},
      {"past the end", sparse({7}, {1, 0, 0}), {"ACCESSOR_SPARSE_INDEX_OOB /accessors/0/sparse"}},
      {"backwards",
       sparse({2, 1}, {0, 1, 0, 1, 0, 0}),
       {"ACCESSOR_SPARSE_INDICES_NON_INCREASING /accessors/0/sparse"}},
  });
}

/// A mesh with a skin of two joints, nodes 1 and 2.
void add_skin(Model& m, const std::vector<std::uint8_t>& joints, const std::vector<float>& weights) {
  attribute("JOINTS_0", joints, kU8, "VEC4")(m);
  attribute("WEIGHTS_0", weights, kF32, "VEC4")(m);
  m.document["skins"] = {{{"joints", {1, 2}}}};
  m.append("nodes", {{"children", {2}}});
  m.append("nodes", json::object());
  m.document["nodes"][0]["skin"] = 0;
  m.document["scenes"][0]["nodes"] = {0, 1};
}

TEST(ValidateData, JointsAndWeights) {
  const std::vector<std::uint8_t> joints = {0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0};
  const std::vector<float> weights = {0.5, 0.5, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  const auto with = [](auto values, std::size_t at, auto value) {
    values[at] = value;
    return values;
  };
  expect_found({
      {"sound", [&](Model& m) { add_skin(m, joints, weights); }, {}},
      {"sum",
       [&](Model& m) { add_skin(m, joints, with(weights, 0, 0.75f)); },
       {"ACCESSOR_WEIGHTS_NON_NORMALIZED " + kAttributes + "WEIGHTS_0"}},
      {"joint",
       [&](Model& m) { add_skin(m, with(joints, 2, std::uint8_t{2}), weights); },
       {"ACCESSOR_JOINTS_INDEX_OOB " + kAttributes + "JOINTS_0"}},
      {"unused joint",
       [&](Model& m) { add_skin(m, with(joints, 2, std::uint8_t{1}), weights); },
       {"ACCESSOR_JOINTS_USED_ZERO_WEIGHT " + kAttributes + "JOINTS_0"}},
      {"joint twice",
       [&](Model& m) { add_skin(m, with(joints, 1, std::uint8_t{0}), weights); },
       {"ACCESSOR_JOINTS_INDEX_DUPLICATE " + kAttributes + "JOINTS_0",
        "ACCESSOR_WEIGHTS_NON_NORMALIZED " + kAttributes + "WEIGHTS_0"}},
      {"negative",
       [&](Model& m) { add_skin(m, joints, with(weights, 0, -0.5f)); },
       {"ACCESSOR_WEIGHTS_NEGATIVE " + kAttributes + "WEIGHTS_0",
        "ACCESSOR_WEIGHTS_NON_NORMALIZED " + kAttributes + "WEIGHTS_0"}},
  });
}

TEST(ValidateData, FindingsAreCountedBeyondWhatIsKept) {
  Model model = sound_triangle();
  attribute("_OWN", std::vector<float>(3, std::numeric_limits<float>::infinity()), kF32, "SCALAR")(model);
  const ValidationReport report = validate(model, {.max_issues = 2});
  EXPECT_EQ(report.issues.count(Severity::error), 3u);
  EXPECT_EQ(report.issues.list().size(), 2u);
  EXPECT_TRUE(report.issues.truncated());
}

TEST(ValidateData, WhatIsNotLookedAtIsSaid) {
  const Model model = sound_triangle();
  EXPECT_EQ(lines_of(validate(model, {.max_numbers = 13})), std::vector<std::string>{"DATA_NOT_CHECKED "});
  EXPECT_EQ(lines_of(validate(model, {.max_numbers = 15})), std::vector<std::string>{});
}

/// 2,000 accessors of 10,000 numbers in one view, 2,000 skins over a chain of 10,000 nodes: a few megabytes
/// that ask for hundreds of millions of steps.
TEST(ValidateData, ManyUsesOfTheSameBytesComeToAnEnd) {
  Model model = sound_triangle();
  const int view = model.add_view(std::vector<float>(10'000));
  for (int i = 0; i < 2'000; ++i) model.add_accessor(view, kF32, "SCALAR", 10'000);
  const std::size_t first = model.document["nodes"].size();
  for (std::size_t i = 0; i < 10'000; ++i) model.append("nodes", {{"children", {first + i + 1}}});
  model.append("nodes", json::object());
  for (std::size_t i = 0; i < 2'000; ++i)
    model.append("skins", {{"joints", {first, first + 10'000, first + 9'000}}});
  const ValidationReport report = validate(model, {.max_numbers = 1'000'000});
  EXPECT_EQ(lines_of(report, Severity::warning), std::vector<std::string>{"DATA_NOT_CHECKED "});
}

}  // namespace
}  // namespace barrido::scene::test
