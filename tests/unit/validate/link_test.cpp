// Faults between objects: views, accessors, primitives, nodes, skins, animations.
#include "tests/unit/validate/validate_support.h"

namespace barrido::scene::test {
namespace {

json& accessor(Model& model) { return model.document["accessors"][0]; }
json& view(Model& model) { return model.document["bufferViews"][0]; }
json& attributes(Model& model) { return primitive(model)["attributes"]; }
const std::string kPrimitive = "/meshes/0/primitives/0";

int add_floats(Model& model, const std::vector<float>& values, const char* type, std::size_t count) {
  return model.add_accessor(model.add_view(values), kF32, type, count);
}

TEST(ValidateLink, ViewsAndAccessors) {
  expect_found({
      {"view too long",
       [](Model& m) { view(m)["byteLength"] = 100; },
       {"BUFFER_VIEW_TOO_LONG /bufferViews/0/byteLength"}},
      {"view outside",
       [](Model& m) { view(m)["byteOffset"] = 1000; },
       {"BUFFER_VIEW_TOO_LONG /bufferViews/0/byteOffset"}},
      {"offsets wrap",
       [](Model& m) { view(m)["byteOffset"] = 18446744073709551612u; },
       {"BUFFER_VIEW_TOO_LONG /bufferViews/0/byteOffset"}},
      {"accessor too long", [](Model& m) { accessor(m)["count"] = 4; }, {"ACCESSOR_TOO_LONG /accessors/0"}},
      {"count overflows",
       [](Model& m) { accessor(m)["count"] = 1537228672809129302u; },
       {"ACCESSOR_TOO_LONG /accessors/0"}},
      {"accessor outside",
       [](Model& m) { accessor(m)["byteOffset"] = 400; },
       {"ACCESSOR_TOO_LONG /accessors/0/byteOffset"}},
      {"odd offset",
       [](Model& m) {
         m.document["accessors"][1]["byteOffset"] = 1;
         m.document["accessors"][1]["count"] = 2;
       },
       {"ACCESSOR_OFFSET_ALIGNMENT /accessors/1/byteOffset", "ACCESSOR_TOTAL_OFFSET_ALIGNMENT /accessors/1",
        "MESH_PRIMITIVE_INCOMPATIBLE_MODE /meshes/0/primitives/0"}},
      {"small stride",
       [](Model& m) { view(m)["byteStride"] = 8; },
       {"ACCESSOR_SMALL_BYTESTRIDE /accessors/0"}},
      {"no buffer", [](Model& m) { view(m)["buffer"] = 3; }, {"UNRESOLVED_REFERENCE /bufferViews/0/buffer"}},
      {"sparse count",
       [](Model& m) {
         const int indices = m.add_view(std::vector<std::uint16_t>{0, 1, 2, 3}),
                   values = m.add_view(std::vector<float>(12, 0.0f));
         accessor(m)["sparse"] = {{"count", 4},
                                  {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                                  {"values", {{"bufferView", values}}}};
       },
       {"ACCESSOR_SPARSE_COUNT_OUT_OF_RANGE /accessors/0/sparse/count"}},
      {"image in vertices",
       [](Model& m) {
         m.document["images"] = {{{"bufferView", 0}, {"mimeType", "image/png"}}};
       },
       {"BUFFER_VIEW_TARGET_OVERRIDE /images/0/bufferView", "IMAGE_UNRECOGNIZED_FORMAT /images/0"}},
  });
}

TEST(ValidateLink, Primitives) {
  expect_found({
      {"no bounds",
       [](Model& m) { accessor(m).erase("max"); },
       {"MESH_PRIMITIVE_POSITION_ACCESSOR_WITHOUT_BOUNDS " + kPrimitive + "/attributes/POSITION"}},
      {"no positions",
       [](Model& m) {
         attributes(m) = {{"_OWN", 0}};
       },
       {"MESH_PRIMITIVE_NO_POSITION " + kPrimitive + "/attributes"}},
      {"name",
       [](Model& m) { attributes(m)["COLOUR_0"] = 0; },
       {"MESH_PRIMITIVE_INVALID_ATTRIBUTE " + kPrimitive + "/attributes/COLOUR_0"}},
      {"gap",
       [](Model& m) {
         attributes(m)["TEXCOORD_1"] = add_floats(m, std::vector<float>(6, 0.0f), "VEC2", 3);
         m.document["bufferViews"][2]["target"] = 34962;
       },
       {"MESH_PRIMITIVE_INDEXED_SEMANTIC_CONTINUITY " + kPrimitive + "/attributes"}},
      {"joints alone",
       [](Model& m) {
         attributes(m)["JOINTS_0"] =
             m.add_accessor(m.add_view(std::vector<std::uint8_t>(12, 0)), kU8, "VEC4", 3);
       },
       {"MESH_PRIMITIVE_JOINTS_WEIGHTS_MISMATCH " + kPrimitive + "/attributes"}},
      {"format",
       [](Model& m) {
         accessor(m)["type"] = "VEC2";
         accessor(m)["min"] = {0, 0};
         accessor(m)["max"] = {1, 1};
       },
       {"ACCESSOR_MAX_MISMATCH /accessors/0/max/0",
        "MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_INVALID_FORMAT " + kPrimitive + "/attributes/POSITION"}},
      {"counts",
       [](Model& m) { attributes(m)["TEXCOORD_0"] = add_floats(m, std::vector<float>(4, 0.0f), "VEC2", 2); },
       {"MESH_PRIMITIVE_UNEQUAL_ACCESSOR_COUNT " + kPrimitive + "/attributes/TEXCOORD_0"}},
      {"unaligned",
       [](Model& m) {
         attributes(m)["_OWN"] =
             m.add_accessor(m.add_view(std::vector<std::uint8_t>(3, 0)), kU8, "SCALAR", 3);
       },
       {"MESH_PRIMITIVE_ACCESSOR_UNALIGNED " + kPrimitive + "/attributes/_OWN"}},
      {"shared view",
       [](Model& m) { attributes(m)["_OWN"] = m.add_accessor(0, kF32, "SCALAR", 3); },
       {"MESH_PRIMITIVE_ACCESSOR_WITHOUT_BYTESTRIDE " + kPrimitive + "/attributes/_OWN"}},
      {"indices of floats",
       [](Model& m) {
         primitive(m)["indices"] = add_floats(m, {0, 1, 2}, "SCALAR", 3);
       },
       {"MESH_PRIMITIVE_INDICES_ACCESSOR_INVALID_FORMAT " + kPrimitive + "/indices"}},
      {"indices as positions",
       [](Model& m) { primitive(m)["indices"] = 0; },
       {"ACCESSOR_USAGE_OVERRIDE " + kPrimitive + "/indices",
        "BUFFER_VIEW_TARGET_OVERRIDE " + kPrimitive + "/indices",
        "MESH_PRIMITIVE_INDICES_ACCESSOR_INVALID_FORMAT " + kPrimitive + "/indices"}},
      {"texture coordinates",
       [](Model& m) {
         m.document["textures"] = json::array({json::object()});
         m.document["materials"] = {{{"emissiveTexture", {{"index", 0}}}}};
         primitive(m)["material"] = 0;
       },
       {"MESH_PRIMITIVE_TOO_FEW_TEXCOORDS " + kPrimitive + "/material"}},
      {"target without base",
       [](Model& m) {
         primitive(m)["targets"] = {{{"NORMAL", 0}}};
       },
       {"MESH_PRIMITIVE_MORPH_TARGET_NO_BASE_ACCESSOR " + kPrimitive + "/targets/0/NORMAL"}},
      {"weights",
       [](Model& m) { m.document["meshes"][0]["weights"] = {1}; },
       {"MESH_INVALID_WEIGHTS_COUNT /meshes/0/weights"}},
      {"tangents",
       [](Model& m) {
         m.document["textures"] = json::array({json::object()});
         m.document["materials"] = {{{"normalTexture", {{"index", 0}}}}};
         primitive(m)["material"] = 0;
       },
       {"MESH_PRIMITIVE_GENERATED_TANGENT_SPACE " + kPrimitive + "/material",
        "MESH_PRIMITIVE_TOO_FEW_TEXCOORDS " + kPrimitive + "/material"}},
  });
}

TEST(ValidateLink, NodesAndSkins) {
  expect_found({
      {"loop",
       [](Model& m) {
         m.document["nodes"] = {{{"children", {1}}}, {{"children", {2}}}, {{"children", {1}}}, {{"mesh", 0}}};
         m.document["scenes"][0]["nodes"] = {3};
       },
       {"NODE_LOOP /nodes/1", "NODE_LOOP /nodes/2", "NODE_PARENT_OVERRIDE /nodes/2/children/0"}},
      {"scene of a child",
       [](Model& m) {
         m.append("nodes", {{"children", {0}}});
       },
       {"SCENE_NON_ROOT_NODE /scenes/0/nodes/0"}},
      {"joints apart",
       [](Model& m) {
         m.document["skins"] = {{{"joints", {1, 2}}}};
         m.append("nodes", json::object());
         m.append("nodes", json::object());
       },
       {"SKIN_NO_COMMON_ROOT /skins/0/joints"}},
      {"skeleton",
       [](Model& m) {
         m.document["skins"] = {{{"joints", {1}}, {"skeleton", 0}}};
         m.append("nodes", json::object());
       },
       {"SKIN_SKELETON_INVALID /skins/0/skeleton"}},
      {"few matrices",
       [](Model& m) {
         m.document["skins"] = {
             {{"joints", {1, 2}},
              {"inverseBindMatrices",
               add_floats(m, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, "MAT4", 1)}}};
         m.append("nodes", {{"children", {2}}});
         m.append("nodes", json::object());
       },
       {"INVALID_IBM_ACCESSOR_COUNT /skins/0/inverseBindMatrices"}},
      {"no joints in the mesh",
       [](Model& m) {
         m.document["skins"] = {{{"joints", {1}}}};
         m.append("nodes", json::object());
         m.document["nodes"][0]["skin"] = 0;
         m.document["scenes"][0]["nodes"] = {0, 1};
       },
       {"NODE_SKIN_WITH_NON_SKINNED_MESH /nodes/0"}},
      {"joints in no scene",
       [](Model& m) {
         m.document["skins"] = {{{"joints", {1}}}};
         m.append("nodes", json::object());
         m.document["nodes"][0]["skin"] = 0;
       },
       {"NODE_SKIN_NO_SCENE /nodes/0", "NODE_SKIN_WITH_NON_SKINNED_MESH /nodes/0"}},
  });
}

TEST(ValidateLink, Animations) {
  const auto animation = [](const char* path, const std::vector<float>& outputs, const char* type,
                            std::size_t count, const json& sampler = {}) {
    return [=](Model& m) {
      const int input = add_floats(m, {0, 1}, "SCALAR", 2);
      m.document["accessors"][2]["min"] = {0};
      m.document["accessors"][2]["max"] = {1};
      json full = {{"input", input}, {"output", add_floats(m, outputs, type, count)}};
      full.update(sampler.is_null() ? json::object() : sampler);
      m.document["animations"] = {
          {{"samplers", {full}},
           {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}}}};
    };
  };
  const std::vector<float> two_points(6, 0.0f);
  const std::string channel = "/animations/0/channels/0/";
  expect_found({
      {"sound", animation("translation", two_points, "VEC3", 2), {}},
      {"count",
       animation("translation", {0, 0, 0}, "VEC3", 1),
       {"ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_COUNT " + channel + "sampler"}},
      {"format",
       animation("translation", {0, 0}, "SCALAR", 2),
       {"ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_FORMAT " + channel + "sampler"}},
      {"path", animation("colour", two_points, "VEC3", 2), {"VALUE_NOT_IN_LIST " + channel + "target/path"}},
      {"no morphs",
       animation("weights", {0, 0}, "SCALAR", 2),
       {"ANIMATION_CHANNEL_TARGET_NODE_WEIGHTS_NO_MORPHS " + channel + "target"}},
      {"not unit",
       animation("rotation", {0, 0, 0, 1, 0, 0, 0, 2}, "VEC4", 2),
       {"ACCESSOR_ANIMATION_SAMPLER_OUTPUT_NON_NORMALIZED_QUATERNION " + channel + "sampler"}},
      {"input of vectors",
       animation("translation", two_points, "VEC3", 2, {{"input", 0}}),
       {"ACCESSOR_USAGE_OVERRIDE /animations/0/samplers/0/input",
        "ANIMATION_SAMPLER_INPUT_ACCESSOR_INVALID_FORMAT /animations/0/samplers/0/input",
        "ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_COUNT " + channel + "sampler",
        "BUFFER_VIEW_TARGET_OVERRIDE /animations/0/samplers/0/input"}},
  });
}

/// As text, since json objects lose the order.
std::vector<std::string> lines_with_attributes(const std::string& attributes) {
  return lines_of(
      validate_text(R"({"asset":{"version":"2.0"},"accessors":[)"
                    R"({"type":"VEC3","componentType":5126,"count":3,"min":[0,0,0],"max":[0,0,0]},)"
                    R"({"type":"VEC4","componentType":5126,"count":4}],)"
                    R"("meshes":[{"primitives":[{"attributes":)" +
                    attributes + R"(}]}],"nodes":[{"mesh":0}]})"),
      Severity::warning);
}

TEST(ValidateLink, TheFirstAttributeOfTheFileCountsTheVertices) {
  EXPECT_EQ(lines_with_attributes(R"({"POSITION":0,"COLOR_0":1})"),
            std::vector<std::string>{"MESH_PRIMITIVE_UNEQUAL_ACCESSOR_COUNT " + kPrimitive +
                                     "/attributes/COLOR_0"});
  EXPECT_EQ(lines_with_attributes(R"({"COLOR_0":1,"POSITION":0})"),
            (std::vector<std::string>{
                "MESH_PRIMITIVE_INCOMPATIBLE_MODE " + kPrimitive,
                "MESH_PRIMITIVE_UNEQUAL_ACCESSOR_COUNT " + kPrimitive + "/attributes/POSITION"}));
}

}  // namespace
}  // namespace barrido::scene::test
