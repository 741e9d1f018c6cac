// The document against the tables: types, ranges, counts, required properties, indices.

#include "import_support.h"

namespace barrido::scene::test {
namespace {

/// A change to a complete model (JSON pointer, new value) and what the message must hold.
struct BadChange {
  const char* pointer;
  const char* value;
  const char* message;
};

void PrintTo(const BadChange& change, std::ostream* out) { *out << change.pointer << " = " << change.value; }

/// Has at least one of everything that the tables know.
Model complete_model() {
  Model model = triangle();
  const int matrix = model.add_accessor(
      model.add_view(std::vector<float>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}), kF32, "MAT4", 1);
  const int time = model.add_accessor(model.add_view(std::vector<float>{0}), kF32, "SCALAR", 1);
  const int move = model.add_accessor(model.add_view(std::vector<float>{0, 0, 0}), kF32, "VEC3", 1);
  model.document["nodes"].push_back(
      {{"camera", 0}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}, {"children", {2}}});
  model.document["nodes"].push_back({{"rotation", {0, 0, 0, 1}}});
  model.document["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}, {"zfar", 2}}}}};
  model.document["skins"] = {{{"joints", {2}}, {"inverseBindMatrices", matrix}}};
  model.document["extensionsUsed"] = {"KHR_lights_punctual"};
  model.document["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "spot"}, {"spot", json::object()}}};
  model.document["samplers"] = {{{"wrapS", 10497}}};
  model.document["textures"] = {{{"sampler", 0}}};
  model.document["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  model.document["animations"] = {
      {{"samplers", {{{"input", time}, {"output", move}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", 2}, {"path", "translation"}}}}}}}};
  primitive(model)["material"] = 0;
  model.document["nodes"][0]["skin"] = 0;
  model.document["scenes"][0]["nodes"] = {0, 1};
  return model;
}

std::string warnings_of(const Model& model) {
  std::string text;
  for (const std::string& warning : model.import().warnings) text += warning + '\n';
  return text;
}

class DocumentCheck : public testing::TestWithParam<BadChange> {};

TEST_P(DocumentCheck, NamesPlaceAndReason) {
  Model model = complete_model();
  const json::json_pointer pointer(GetParam().pointer);
  model.document[pointer] = json::parse(GetParam().value);
  // An animation that is broken is none.
  const bool is_warning = std::string(GetParam().pointer).starts_with("/animations/");
  EXPECT_CONTAINS(is_warning ? warnings_of(model) : import_error(model), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Types, DocumentCheck,
    testing::Values(
        BadChange{"/meshes", "{}", "meshes: must be an array"},
        BadChange{"/meshes/0", "[]", "meshes[0]: must be an object"},
        BadChange{"/asset", "7", "asset: must be an object"},
        BadChange{"/accessors/0/normalized", "1", "accessors[0].normalized: must be true or false"},
        BadChange{"/accessors/0/count", "2.5", "accessors[0].count: must be a whole number"},
        BadChange{"/accessors/0/count", "\"3\"", "accessors[0].count: must be a whole number"},
        BadChange{"/accessors/0/type", "\"VEC5\"", "accessors[0].type: is \"VEC5\"; known are SCALAR, VEC2"},
        BadChange{"/extensionsUsed", "[1]", "extensionsUsed[0]: must be a string"},
        BadChange{"/nodes/2/rotation/1", "null", "nodes[2].rotation[1]: must be a number"},
        BadChange{"/meshes/0/primitives/0/attributes", "[]", "attributes: must be an object"}));

INSTANTIATE_TEST_SUITE_P(
    Ranges, DocumentCheck,
    testing::Values(
        BadChange{"/accessors/0/count", "0", "accessors[0].count: is 0, but must be at least 1"},
        BadChange{"/accessors/0/byteOffset", "-4", "accessors[0].byteOffset: is -4, but must be at least 0"},
        BadChange{"/accessors/0/componentType", "5130", "componentType: is 5130, but must be at most 5126"},
        BadChange{"/accessors/0/componentType", "5124", "componentType 5124 is none of glTF's"},
        BadChange{"/bufferViews/0/byteStride", "-12", "byteStride: is -12"},
        BadChange{"/bufferViews/0/byteStride", "14", "byteStride: must be a multiple of 4"},
        BadChange{"/meshes/0/primitives/0/mode", "7", "mode: is 7, but must be at most 6"},
        BadChange{"/cameras/0/perspective/znear", "0", "znear: is 0, but must be greater than 0"},
        BadChange{"/cameras/0/perspective/yfov", "-1", "yfov: is -1, but must be greater than 0"},
        BadChange{"/cameras/0/perspective/zfar", "0.5", "zfar must be greater than znear"},
        BadChange{"/asset/version", "\"1.0\"", "asset.version: glTF 1.0 is not supported"},
        BadChange{"/asset/minVersion", "\"2.1\"", "asset.minVersion: glTF 2.1"}));

INSTANTIATE_TEST_SUITE_P(
    Counts, DocumentCheck,
    testing::Values(
        BadChange{"/nodes/2/rotation", "[0,1]", "nodes[2].rotation: must have 4 elements, not 2"},
        BadChange{"/nodes/2/matrix", "[]", "nodes[2].matrix: must have 16 elements, not 0"},
        BadChange{"/materials/0/emissiveFactor", "[1,1,1,1]", "emissiveFactor: must have 3 elements"},
        BadChange{"/nodes/0/weights", "[1]", "nodes[0].weights: there are 1 weights, but 0 morph targets"},
        BadChange{"/meshes/0/weights", "[1]", "meshes[0].weights: there are 1 weights"}));

INSTANTIATE_TEST_SUITE_P(
    Indices, DocumentCheck,
    testing::Values(
        BadChange{"/scene", "1", "scene: refers to scenes[1], but there is 1"},
        BadChange{"/scene", "-1", "scene: refers to scenes[-1]"},
        BadChange{"/scenes/0/nodes/0", "9", "scenes[0].nodes[0]: refers to nodes[9], but there are 3"},
        BadChange{"/nodes/0/mesh", "1", "nodes[0].mesh: refers to meshes[1]"},
        BadChange{"/nodes/0/skin", "1", "nodes[0].skin: refers to skins[1]"},
        BadChange{"/nodes/1/camera", "1", "nodes[1].camera: refers to cameras[1]"},
        BadChange{"/nodes/1/children/0", "3", "nodes[1].children[0]: refers to nodes[3]"},
        BadChange{"/nodes/1/extensions/KHR_lights_punctual/light", "1", "light: refers to lights[1]"},
        BadChange{"/meshes/0/primitives/0/material", "1", "material: refers to materials[1]"},
        BadChange{"/meshes/0/primitives/0/indices", "99", "indices: refers to accessors[99]"},
        BadChange{"/meshes/0/primitives/0/attributes/POSITION", "-2147483648",
                  "attributes.POSITION: refers to accessors[-2147483648]"},
        BadChange{"/meshes/0/primitives/0/targets", "[{\"POSITION\":99}]",
                  "targets[0].POSITION: refers to accessors[99]"},
        BadChange{"/accessors/0/bufferView", "77", "accessors[0].bufferView: refers to bufferViews[77]"},
        BadChange{"/bufferViews/0/buffer", "1", "bufferViews[0].buffer: refers to buffers[1]"},
        BadChange{"/textures/0/source", "0", "textures[0].source: refers to images[0], but there are none"},
        BadChange{"/textures/0/sampler", "1", "textures[0].sampler: refers to samplers[1]"},
        BadChange{"/materials/0/pbrMetallicRoughness/baseColorTexture/index", "1",
                  "materials[0].pbrMetallicRoughness.baseColorTexture.index: refers to textures[1]"},
        BadChange{"/skins/0/joints/0", "3", "skins[0].joints[0]: refers to nodes[3]"},
        BadChange{"/skins/0/inverseBindMatrices", "99", "inverseBindMatrices: refers to accessors[99]"},
        BadChange{"/animations/0/channels/0/target/node", "3", "target.node: refers to nodes[3]"},
        BadChange{"/animations/0/samplers/0/input", "99", "samplers[0].input: refers to accessors[99]"}));

TEST(DocumentCheck, SmallSinsAreWarnings) {
  struct Sin {
    const char *pointer, *value, *warning;
  };
  const Sin sins[] = {
      {"/nodes/0/name", "[]", "nodes[0].name: must be a string; it is ignored"},
      {"/asset/generator", "7", "asset.generator: must be a string; it is ignored"},
      {"/animations/0/samplers/0/interpolation", "0",
       "animations[0].samplers[0].interpolation: must be LINEAR, STEP or CUBICSPLINE; it is ignored"},
      {"/materials/0/doubleSided", "\"yes\"",
       "materials[0].doubleSided: must be true or false; it is ignored"},
      {"/materials/0/alphaCutoff", "null", "materials[0].alphaCutoff: must be a number; it is ignored"}};
  for (const Sin& sin : sins) {
    Model model = complete_model();
    const std::size_t before = model.import().warnings.size();
    model.document[json::json_pointer(sin.pointer)] = json::parse(sin.value);
    const std::vector<std::string> warnings = model.import().warnings;
    ASSERT_EQ(warnings.size(), before + 1) << sin.pointer;
    EXPECT_EQ(std::count(warnings.begin(), warnings.end(), sin.warning), 1) << warnings[0];
  }
}

TEST(DocumentCheck, AnotherVersionIsToldFirst) {
  Model model;
  model.document["asset"]["version"] = "1.0";
  model.document["meshes"] = json::object();
  EXPECT_CONTAINS(import_error(model), "asset.version: glTF 1.0 is not supported; only 2.x is");
  model.document.erase("asset");
  EXPECT_CONTAINS(import_error(model), "looks like glTF 1.0");
}

TEST(DocumentCheck, CompleteModelIsFine) { EXPECT_NO_THROW(complete_model().import()); }

TEST(DocumentCheck, RequiredPropertiesAreMissed) {
  Model model = triangle();
  model.document["accessors"][0].erase("componentType");
  EXPECT_CONTAINS(import_error(model), "accessors[0]: \"componentType\" is missing");
  EXPECT_CONTAINS(import_error([] {
                    Model no_asset;
                    no_asset.document.erase("asset");
                    no_asset.document["nodes"] = json::array();
                    return no_asset;
                  }()),
                  "\"asset\" is missing");
}

TEST(DocumentCheck, WholeNumbersMayBeWrittenWithAPoint) {
  Model model = triangle();
  model.document["accessors"][0]["count"] = 3.0;
  model.document["nodes"][0]["mesh"] = 0.0;
  model.document["scene"] = 0.0;
  const Scene scene = model.import();
  EXPECT_EQ(scene.meshes[0].primitives[0].vertex_count, 3u);
  EXPECT_EQ(scene.nodes[0].mesh, 0);
}

TEST(DocumentCheck, JsonErrorsSayWhere) {
  const TemporaryFolder folder;
  const auto error = [&](const std::string& text) {
    return input_error([&] { import_gltf(folder.write("model.gltf", text)); });
  };
  EXPECT_CONTAINS(error("{\"asset\":\n{\"version\":\"2.0\",}}"), "model.gltf: JSON: parse error at line 2");
  EXPECT_CONTAINS(error("{\"asset\":{\"version\":NaN}}"), "JSON: parse error");
  EXPECT_CONTAINS(error("{\"asset\":{\"version\":\"2.\xff\"}}"), "ill-formed UTF-8");
  EXPECT_CONTAINS(error("{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{\"scale\":[1e999,1,1]}]}"), "JSON");
}

TEST(Unused, BrokenElementsAreWarnings) {
  const struct {
    const char* array;
    const char* element;
    const char* message;
  } cases[] = {{"nodes", R"({"mesh": 99})",
                "nodes[3].mesh: refers to meshes[99], but there is 1; nothing that is drawn"},
               {"meshes", R"({"primitives": [{"attributes": {"POSITION": 99}}]})",
                "meshes[1].primitives[0].attributes.POSITION: refers to accessors[99]"},
               {"materials", R"({"normalTexture": {"index": 99}})",
                "materials[1].normalTexture.index: refers to textures"},
               {"textures", R"({"sampler": 99})", "textures[1].sampler: refers to samplers[99]"},
               {"cameras", R"({"type": "fisheye"})", "cameras[1].type: is \"fisheye\""},
               {"skins", R"({"joints": [99]})", "skins[1].joints[0]: refers to nodes[99]"},
               {"animations", R"({"samplers": []})", "animations[1]: \"channels\" is missing"}};
  for (const auto& [array, element, message] : cases) {
    Model model = complete_model();
    model.append(array, json::parse(element));
    EXPECT_CONTAINS(warnings_of(model), message);
    EXPECT_EQ(model.import().meshes[0].primitives[0].vertex_count, 3u) << array;
    // The same where it is drawn ends the import.
    if (std::string(array) != "nodes") continue;
    model.document["scenes"][0]["nodes"].push_back(3);
    EXPECT_CONTAINS(import_error(model), "nodes[3].mesh: refers to meshes[99]");
  }
}

TEST(Extensions, RequiredOnesThatAreNotSupportedEndTheImport) {
  Model model = triangle();
  model.document["extensionsRequired"] = {"ABC_other_triangles"};
  EXPECT_CONTAINS(import_error(model), "extensionsRequired: ABC_other_triangles is not supported");
  model.document["extensionsRequired"] = {"KHR_mesh_quantization", "KHR_materials_unlit"};
  EXPECT_NO_THROW(model.import());
}

TEST(Extensions, UsedOnesThatAreNotSupportedAreOneWarning) {
  Model model = triangle();
  model.document["extensionsUsed"] = {"EXT_a", "KHR_materials_unlit", "EXT_b"};
  const Scene scene = model.import();
  EXPECT_EQ(scene.warnings, std::vector<std::string>{"not supported and ignored: EXT_a, EXT_b"});
  ASSERT_GE(scene.features.size(), 3u);
  EXPECT_EQ(scene.features[0].support, Feature::Support::ignored);
  EXPECT_EQ(scene.features[1].support, Feature::Support::exact);
}

}  // namespace
}  // namespace barrido::scene::test
