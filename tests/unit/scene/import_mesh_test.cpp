// Primitives: which attributes are taken, in which form, and what is wrong with others.
#include <cmath>

#include "import_support.h"

namespace barrido::scene::test {
namespace {

Primitive import_primitive(const Model& model) { return model.import().meshes.at(0).primitives.at(0); }

/// Adds an attribute of three vertices to the triangle.
template <typename T>
void add_attribute(Model& model, const char* name, const std::vector<T>& numbers, int component_type,
                   const char* type, bool normalized = false, std::size_t count = 3) {
  const int view = model.add_view(numbers);
  primitive(model)["attributes"][name] = model.add_accessor(view, component_type, type, count, normalized);
}

TEST(ImportMesh, AllPrimitiveModesInOpenGLsOrder) {
  for (int mode = 0; mode <= 6; ++mode) {
    Model model = triangle();
    primitive(model)["mode"] = mode;
    EXPECT_EQ(import_primitive(model).mode, static_cast<pipeline::PrimitiveMode>(mode));
  }
  Model model = triangle();
  EXPECT_EQ(import_primitive(model).mode, pipeline::PrimitiveMode::triangles);
}

TEST(ImportMesh, IndicesOfEveryWidth) {
  const std::vector<std::uint32_t> expected = {2, 0, 1};
  Model bytes = triangle();
  primitive(bytes)["indices"] =
      bytes.add_accessor(bytes.add_view(std::vector<std::uint8_t>{2, 0, 1}), kU8, "SCALAR", 3);
  EXPECT_EQ(values(import_primitive(bytes).indices), expected);
  Model shorts = triangle();
  primitive(shorts)["indices"] =
      shorts.add_accessor(shorts.add_view(std::vector<std::uint16_t>{2, 0, 1}), kU16, "SCALAR", 3);
  EXPECT_EQ(values(import_primitive(shorts).indices), expected);
  Model ints = triangle();
  primitive(ints)["indices"] =
      ints.add_accessor(ints.add_view(std::vector<std::uint32_t>{2, 0, 1}), kU32, "SCALAR", 3);
  EXPECT_EQ(values(import_primitive(ints).indices), expected);
  Model unaligned = triangle();
  primitive(unaligned)["indices"] = unaligned.add_accessor(
      unaligned.add_view(std::vector<std::uint32_t>{2, 0, 1}, 0, 2), kU32, "SCALAR", 3);
  EXPECT_EQ(values(import_primitive(unaligned).indices), expected);
}

TEST(ImportMesh, IndexBeyondTheVerticesIsAnError) {
  for (const std::uint16_t bad : {3, 60000, 65535}) {
    Model model = triangle();
    primitive(model)["indices"] =
        model.add_accessor(model.add_view(std::vector<std::uint16_t>{0, 1, bad}), kU16, "SCALAR", 3);
    EXPECT_CONTAINS(import_error(model), "meshes[0].primitives[0].indices: index " + std::to_string(bad) +
                                             " where there are only 3 vertices");
  }
}

TEST(ImportMesh, ColorsAlwaysHaveFourComponents) {
  const std::vector<float> opaque = {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1};
  Model floats = triangle();
  add_attribute(floats, "COLOR_0", std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 1}, kF32, "VEC3");
  EXPECT_EQ(values(import_primitive(floats).colors), opaque);
  Model bytes = triangle();
  add_attribute(bytes, "COLOR_0", std::vector<std::uint8_t>{255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255},
                kU8, "VEC4", true);
  EXPECT_EQ(values(import_primitive(bytes).colors), opaque);
  Model shorts = triangle();
  add_attribute(shorts, "COLOR_0", std::vector<std::uint16_t>{65535, 0, 0, 0, 65535, 0, 0, 0, 65535}, kU16,
                "VEC3", true);
  EXPECT_EQ(values(import_primitive(shorts).colors), opaque);
}

TEST(ImportMesh, QuantizedPositionsNormalsAndTexcoords) {
  Model model = triangle();
  add_attribute(model, "POSITION", std::vector<std::int16_t>{0, 0, 0, 100, 0, 0, 0, -100, 0}, kI16, "VEC3");
  add_attribute(model, "NORMAL", std::vector<std::int8_t>{0, 0, 127, 0, 0, 127, 0, 0, -128}, kI8, "VEC3",
                true);
  add_attribute(model, "TEXCOORD_1", std::vector<std::uint16_t>{0, 0, 65535, 0, 0, 65535}, kU16, "VEC2",
                true);
  const Primitive made = import_primitive(model);
  EXPECT_EQ(values(made.positions), (std::vector<float>{0, 0, 0, 100, 0, 0, 0, -100, 0}));
  EXPECT_EQ(values(made.normals), (std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, -1}));
  EXPECT_EQ(values(made.texcoords[1]), (std::vector<float>{0, 0, 1, 0, 0, 1}));
  EXPECT_TRUE(made.texcoords[0].empty());
}

TEST(ImportMesh, NormalsBecomeUnitLength) {
  Model model = triangle();
  add_attribute(model, "NORMAL", std::vector<float>{0, 0, 5, 3e20f, 4e20f, 0, 0, 0, 0}, kF32, "VEC3");
  EXPECT_EQ(values(import_primitive(model).normals), (std::vector<float>{0, 0, 1, 0.6f, 0.8f, 0, 0, 0, 0}));
}

TEST(ImportMesh, WrongFormatsAreErrors) {
  struct {
    const char* name;
    int component_type;
    const char* type;
    bool normalized;
  } const kWrong[] = {{"POSITION", kF32, "VEC2", false}, {"POSITION", kU32, "VEC3", false},
                      {"NORMAL", kU8, "VEC3", true},     {"NORMAL", kI8, "VEC3", false},
                      {"TANGENT", kF32, "VEC3", false},  {"TEXCOORD_0", kF32, "VEC3", false},
                      {"COLOR_0", kU8, "VEC4", false},   {"COLOR_0", kF32, "MAT2", false},
                      {"JOINTS_0", kF32, "VEC4", false}, {"JOINTS_0", kU8, "VEC4", true},
                      {"WEIGHTS_0", kU16, "VEC4", false}};
  for (const auto& wrong : kWrong) {
    Model model = triangle();
    add_attribute(model, wrong.name, std::vector<float>(48), wrong.component_type, wrong.type,
                  wrong.normalized);
    EXPECT_CONTAINS(import_error(model), std::string("attributes.") + wrong.name + ": accessors[2] with ");
  }
  Model model = triangle();
  primitive(model)["indices"] = 0;
  EXPECT_CONTAINS(import_error(model), "primitives[0].indices: accessors[0] with 3 components of type float");
}

TEST(ImportMesh, AttributesMustHaveAsManyElementsAsPositions) {
  Model model = triangle();
  add_attribute(model, "TEXCOORD_0", std::vector<float>(4), kF32, "VEC2", false, 2);
  EXPECT_CONTAINS(import_error(model), "TEXCOORD_0: accessors[2] has 2 elements where 3 are due");
}

TEST(ImportMesh, PrimitiveWithoutPositionsIsLeftOutWithAWarning) {
  Model model = triangle();
  model.document["meshes"][0]["primitives"].push_back({{"attributes", json::object()}});
  const Scene scene = model.import();
  EXPECT_EQ(scene.meshes[0].primitives.size(), 1u);
  EXPECT_EQ(scene.warnings, std::vector<std::string>{"a primitive without positions is not drawn"});
}

TEST(ImportMesh, WeightsAreMadeToSumOneAndUnusedJointsToBeZero) {
  Model model = triangle();
  add_attribute(model, "JOINTS_0", std::vector<std::uint16_t>{1, 9, 9, 9, 0, 1, 0, 0, 1, 0, 0, 0}, kU16,
                "VEC4");
  add_attribute(model, "WEIGHTS_0", std::vector<float>{4, 0, 0, 0, 1, 3, 0, 0, 0, 0, 0, 0}, kF32, "VEC4");
  add_attribute(model, "JOINTS_1", std::vector<std::uint16_t>(12), kU16, "VEC4");
  const Scene scene = model.import();
  const Primitive& made = scene.meshes[0].primitives[0];
  EXPECT_EQ(values(made.weights), (std::vector<float>{1, 0, 0, 0, 0.25f, 0.75f, 0, 0, 1, 0, 0, 0}));
  using Joints = std::array<std::uint16_t, 4>;
  EXPECT_EQ(made.joints, (std::vector<Joints>{{1, 0, 0, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}}));
  EXPECT_EQ(scene.warnings.size(), 1u);
}

TEST(ImportMesh, WeightsAsNormalizedBytes) {
  Model model = triangle();
  add_attribute(model, "JOINTS_0", std::vector<std::uint8_t>(12), kU8, "VEC4");
  add_attribute(model, "WEIGHTS_0", std::vector<std::uint8_t>{255, 0, 0, 0, 51, 204, 0, 0, 255, 0, 0, 0}, kU8,
                "VEC4", true);
  EXPECT_EQ(values(import_primitive(model).weights),
            (std::vector<float>{1, 0, 0, 0, 0.2f, 0.8f, 0, 0, 1, 0, 0, 0}));
}

TEST(ImportMesh, MorphTargetsWithWeights) {
  Model model = triangle();
  const int moved = model.add_accessor(model.add_view(std::vector<float>(9, 2.0f)), kF32, "VEC3", 3);
  primitive(model)["targets"] = {{{"POSITION", moved}}, {{"NORMAL", moved}}};
  model.document["meshes"][0]["weights"] = {0.5, 0.25};
  model.document["nodes"][0]["weights"] = {1, 0};
  const Scene scene = model.import();
  const Primitive& made = scene.meshes[0].primitives[0];
  ASSERT_EQ(made.morph_targets.size(), 2u);
  EXPECT_EQ(values(made.morph_targets[0].positions), std::vector<float>(9, 2.0f));
  EXPECT_TRUE(made.morph_targets[0].normals.empty());
  EXPECT_EQ(values(made.morph_targets[1].normals), std::vector<float>(9, 2.0f));
  EXPECT_EQ(scene.meshes[0].morph_weights, (std::vector<float>{0.5f, 0.25f}));
  EXPECT_EQ(scene.nodes[0].morph_weights, (std::vector<float>{1, 0}));
}

TEST(ImportMesh, MorphTargetOfAnotherLengthIsAnError) {
  Model model = triangle();
  const int moved = model.add_accessor(model.add_view(std::vector<float>(6)), kF32, "VEC3", 2);
  primitive(model)["targets"] = {{{"POSITION", moved}}};
  EXPECT_CONTAINS(import_error(model),
                  "meshes[0].primitives[0].targets[0].POSITION: accessors[2] has 2 elements");
}

TEST(ImportMesh, VertexLimit) {
  ImportOptions options;
  options.max_vertices = 5;
  Model model = triangle();
  EXPECT_NO_THROW(model.import(options));
  model.document["meshes"].push_back(model.document["meshes"][0]);
  EXPECT_CONTAINS(input_error([&] { model.import(options); }),
                  "meshes[1].primitives[0]: the file has more than 5");
}

}  // namespace
}  // namespace barrido::scene::test
