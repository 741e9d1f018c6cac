// What the schema says of single properties, one fault at a time.
#include "tests/unit/validate/validate_support.h"

namespace barrido::scene::test {
namespace {

json& accessor(Model& model) { return model.document["accessors"][0]; }
json& node(Model& model) { return model.document["nodes"][0]; }
void add_material(Model& model, const json& material) {
  model.document["materials"] = json::array({material});
}
void declare(Model& model, const char* extension) { model.document["extensionsUsed"].push_back(extension); }

TEST(ValidateShape, SoundTriangleHasNoFault) {
  EXPECT_EQ(lines_of(validate(sound_triangle())), std::vector<std::string>{});
}

TEST(ValidateShape, PropertiesOfTheDocument) {
  expect_found({
      {"unknown property", [](Model& m) { m.document["a/b"] = 1; }, {"UNEXPECTED_PROPERTY /a~1b"}},
      {"no asset", [](Model& m) { m.document.erase("asset"); }, {"UNDEFINED_PROPERTY /"}},
      {"version 1",
       [](Model& m) { m.document["asset"]["version"] = "1.0"; },
       {"UNKNOWN_ASSET_MAJOR_VERSION /asset/version"}},
      {"version 2.7",
       [](Model& m) { m.document["asset"]["version"] = "2.7"; },
       {"UNKNOWN_ASSET_MINOR_VERSION /asset/version"}},
      {"no version",
       [](Model& m) { m.document["asset"]["version"] = "two"; },
       {"PATTERN_MISMATCH /asset/version"}},
      {"minVersion",
       [](Model& m) { m.document["asset"]["minVersion"] = "2.1"; },
       {"ASSET_MIN_VERSION_GREATER_THAN_VERSION /asset/minVersion"}},
      {"empty array", [](Model& m) { m.document["cameras"] = json::array(); }, {"EMPTY_ENTITY /cameras"}},
      {"array of others",
       [](Model& m) {
         m.document["samplers"] = {json::object(), 3};
       },
       {"TYPE_MISMATCH /samplers/1"}},
      {"no array", [](Model& m) { m.document["skins"] = "skins"; }, {"TYPE_MISMATCH /skins"}},
      {"scene", [](Model& m) { m.document["scene"] = 7; }, {"UNRESOLVED_REFERENCE /scene"}},
      {"negative scene", [](Model& m) { m.document["scene"] = -1; }, {"INVALID_INDEX /scene"}},
      {"scene 0.5", [](Model& m) { m.document["scene"] = 0.5; }, {"TYPE_MISMATCH /scene"}},
      {"scene 0.0", [](Model& m) { m.document["scene"] = 0.0; }, {}},
      {"null",
       [](Model& m) { m.document["asset"]["generator"] = nullptr; },
       {"TYPE_MISMATCH /asset/generator"}},
  });
}

TEST(ValidateShape, Extensions) {
  expect_found({
      {"declared twice",
       [](Model& m) {
         m.document["extensionsUsed"] = {"A_b", "A_b"};
       },
       {"DUPLICATE_ELEMENTS /extensionsUsed/1"}},
      {"no texts",
       [](Model& m) {
         m.document["extensionsUsed"] = {"A_b", 3};
       },
       {"ARRAY_TYPE_MISMATCH /extensionsUsed/1"}},
      {"name", [](Model& m) { declare(m, "nameless"); }, {"INVALID_EXTENSION_NAME_FORMAT /extensionsUsed/0"}},
      {"required only",
       [](Model& m) { m.document["extensionsRequired"] = {"A_b"}; },
       {"UNSATISFIED_DEPENDENCY /extensionsRequired", "UNUSED_EXTENSION_REQUIRED /extensionsRequired/0"}},
      {"not required",
       [](Model& m) { declare(m, "KHR_mesh_quantization"); },
       {"NON_REQUIRED_EXTENSION /extensionsUsed/0"}},
      {"not declared",
       [](Model& m) { node(m)["extensions"]["A_b"] = json::object(); },
       {"UNDECLARED_EXTENSION /nodes/0/extensions/A_b"}},
      {"no object",
       [](Model& m) {
         declare(m, "A_b");
         node(m)["extensions"]["A_b"] = 1;
       },
       {"TYPE_MISMATCH /nodes/0/extensions/A_b"}},
      {"wrong place",
       [](Model& m) {
         declare(m, "KHR_materials_unlit");
         node(m)["extensions"]["KHR_materials_unlit"] = json::object();
       },
       {"UNEXPECTED_EXTENSION_OBJECT /nodes/0/extensions/KHR_materials_unlit"}},
      {"not alone",
       [](Model& m) {
         declare(m, "KHR_materials_unlit");
         declare(m, "KHR_materials_ior");
         add_material(m,
                      {{"extensions",
                        {{"KHR_materials_unlit", json::object()}, {"KHR_materials_ior", json::object()}}}});
       },
       {"MULTIPLE_EXTENSIONS /materials/0/extensions/KHR_materials_unlit"}},
      {"unknown inside",
       [](Model& m) {
         declare(m, "KHR_node_visibility");
         node(m)["extensions"]["KHR_node_visibility"] = {{"visible", true}, {"color", 1}};
       },
       {"UNEXPECTED_PROPERTY /nodes/0/extensions/KHR_node_visibility/color"}},
      {"no light",
       [](Model& m) {
         declare(m, "KHR_lights_punctual");
         node(m)["extensions"]["KHR_lights_punctual"]["light"] = 0;
       },
       {"UNSATISFIED_DEPENDENCY /nodes/0/extensions/KHR_lights_punctual"}},
      {"no light and none named",
       [](Model& m) {
         declare(m, "KHR_lights_punctual");
         node(m)["extensions"]["KHR_lights_punctual"] = json::object();
       },
       {"UNDEFINED_PROPERTY /nodes/0/extensions/KHR_lights_punctual",
        "UNSATISFIED_DEPENDENCY /nodes/0/extensions/KHR_lights_punctual"}},
      {"lights, but none named",
       [](Model& m) {
         declare(m, "KHR_lights_punctual");
         m.document["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
         node(m)["extensions"]["KHR_lights_punctual"] = json::object();
       },
       {"UNDEFINED_PROPERTY /nodes/0/extensions/KHR_lights_punctual"}},
      {"no variants, once for all of a mapping",
       [](Model& m) {
         declare(m, "KHR_materials_variants");
         add_material(m, json::object());
         primitive(m)["extensions"]["KHR_materials_variants"]["mappings"] = {
             {{"material", 0}, {"variants", {0, 1}}}};
       },
       {"UNSATISFIED_DEPENDENCY "
        "/meshes/0/primitives/0/extensions/KHR_materials_variants/mappings/0"}},
  });
}

TEST(ValidateShape, WhatAMappingWithoutVariantsNamesIsNotUsed) {
  Model model = sound_triangle();
  declare(model, "KHR_materials_variants");
  add_material(model, json::object());
  primitive(model)["extensions"]["KHR_materials_variants"]["mappings"] = {
      {{"material", 0}, {"variants", {0}}}};
  const auto lines = lines_of(validate(model));
  EXPECT_NE(std::find(lines.begin(), lines.end(), "UNUSED_OBJECT /materials/0"), lines.end());
}

TEST(ValidateShape, ANodeWithExtrasOfAnyKindIsNotEmpty) {
  const auto lines_with = [](const json& extras) {
    Model model = sound_triangle();
    model.append("nodes", {{"extras", extras}});
    model.document["scenes"] = {{{"nodes", {0, 1}}}};
    return lines_of(validate(model));
  };
  using Lines = std::vector<std::string>;
  EXPECT_EQ(lines_with(json::object()), Lines{});
  EXPECT_EQ(lines_with(false), Lines{"NON_OBJECT_EXTRAS /nodes/1/extras"});
  EXPECT_EQ(lines_with({1, 2}), Lines{"NON_OBJECT_EXTRAS /nodes/1/extras"});
  EXPECT_EQ(lines_with(nullptr), Lines{"NODE_EMPTY /nodes/1"});
}

TEST(ValidateShape, Values) {
  expect_found({
      {"range",
       [](Model& m) {
         add_material(m, {{"emissiveFactor", {0, 2, 0}}});
       },
       {"VALUE_NOT_IN_RANGE /materials/0/emissiveFactor/1"}},
      {"length",
       [](Model& m) {
         add_material(m, {{"emissiveFactor", {0, 0}}});
       },
       {"ARRAY_LENGTH_NOT_IN_LIST /materials/0/emissiveFactor"}},
      {"choice",
       [](Model& m) {
         add_material(m, {{"alphaMode", "GLASS"}});
       },
       {"VALUE_NOT_IN_LIST /materials/0/alphaMode"}},
      {"cutoff",
       [](Model& m) {
         add_material(m, {{"alphaCutoff", 0.5}});
       },
       {"MATERIAL_ALPHA_CUTOFF_INVALID_MODE /materials/0/alphaCutoff"}},
      {"boolean",
       [](Model& m) {
         add_material(m, {{"doubleSided", 1}});
       },
       {"TYPE_MISMATCH /materials/0/doubleSided"}},
      {"ior",
       [](Model& m) {
         declare(m, "KHR_materials_ior");
         add_material(m, {{"extensions", {{"KHR_materials_ior", {{"ior", 0.5}}}}}});
       },
       {"VALUE_NOT_IN_RANGE /materials/0/extensions/KHR_materials_ior/ior"}},
      {"ior 0",
       [](Model& m) {
         declare(m, "KHR_materials_ior");
         add_material(m, {{"extensions", {{"KHR_materials_ior", {{"ior", 0}}}}}});
       },
       {}},
      {"stride",
       [](Model& m) { m.document["bufferViews"][0]["byteStride"] = 14; },
       {"ACCESSOR_TOO_LONG /accessors/0", "VALUE_MULTIPLE_OF /bufferViews/0/byteStride"}},
      {"stride of indices",
       [](Model& m) { m.document["bufferViews"][1]["byteStride"] = 4; },
       {"ACCESSOR_TOO_LONG /accessors/1", "BUFFER_VIEW_INVALID_BYTE_STRIDE /bufferViews/1/byteStride",
        "MESH_PRIMITIVE_INDICES_ACCESSOR_WITH_BYTESTRIDE /meshes/0/primitives/0/indices"}},
      {"normalized",
       [](Model& m) { accessor(m)["normalized"] = true; },
       {"ACCESSOR_NORMALIZED_INVALID /accessors/0/normalized",
        "MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_INVALID_FORMAT /meshes/0/primitives/0/attributes/POSITION"}},
      {"bounds of integers",
       [](Model& m) { m.document["accessors"][1]["max"] = {70000}; },
       {"INVALID_GL_VALUE /accessors/1/max"}},
      {"offset without view",
       [](Model& m) {
         m.add_accessor(-1, kF32, "VEC3", 3);
         m.document["accessors"][2]["byteOffset"] = 4;
       },
       {"UNSATISFIED_DEPENDENCY /accessors/2/byteOffset"}},
      {"image of nothing",
       [](Model& m) { m.document["images"] = json::array({json::object()}); },
       {"ONE_OF_MISMATCH /images/0"}},
      {"children",
       [](Model& m) {
         node(m)["children"] = {1, 1, -1};
         m.append("nodes", json::object());
       },
       {"DUPLICATE_ELEMENTS /nodes/0/children/1", "INVALID_INDEX /nodes/0/children/2",
        "NODE_PARENT_OVERRIDE /nodes/0/children/1"}},
  });
}

TEST(ValidateShape, CamerasAndLights) {
  const auto camera = [](const json& value) {
    return [value](Model& m) { m.document["cameras"] = json::array({value}); };
  };
  const auto spot = [](const json& angles) {
    return [angles](Model& m) {
      declare(m, "KHR_lights_punctual");
      m.document["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "spot"}, {"spot", angles}}};
    };
  };
  expect_found({
      {"both kinds",
       camera({{"type", "perspective"},
               {"perspective", {{"yfov", 1}, {"znear", 1}}},
               {"orthographic", json::object()}}),
       {"ONE_OF_MISMATCH /cameras/0"}},
      {"planes",
       camera({{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 2}, {"zfar", 1}}}}),
       {"CAMERA_ZFAR_LEQUAL_ZNEAR /cameras/0/perspective"}},
      {"yfov",
       camera({{"type", "perspective"}, {"perspective", {{"yfov", 4}, {"znear", 1}}}}),
       {"CAMERA_YFOV_GEQUAL_PI /cameras/0/perspective"}},
      {"znear 0",
       camera({{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0}}}}),
       {"VALUE_NOT_IN_RANGE /cameras/0/perspective/znear"}},
      {"xmag 0",
       camera({{"type", "orthographic"},
               {"orthographic", {{"xmag", 0}, {"ymag", -1}, {"znear", 0}, {"zfar", 1}}}}),
       {"CAMERA_XMAG_YMAG_NEGATIVE /cameras/0/orthographic/ymag",
        "CAMERA_XMAG_YMAG_ZERO /cameras/0/orthographic/xmag"}},
      {"no lens", camera({{"type", "orthographic"}}), {"UNDEFINED_PROPERTY /cameras/0"}},
      {"spot",
       spot({{"innerConeAngle", 0.9}}),
       {"KHR_LIGHTS_PUNCTUAL_LIGHT_SPOT_ANGLES "
        "/extensions/KHR_lights_punctual/lights/0/spot/outerConeAngle"}},
      {"wide spot",
       spot({{"outerConeAngle", 2}}),
       {"VALUE_NOT_IN_RANGE /extensions/KHR_lights_punctual/lights/0/spot/outerConeAngle"}},
  });
}

TEST(ValidateShape, Nodes) {
  expect_found({
      {"rotation",
       [](Model& m) {
         node(m)["rotation"] = {0, 0, 0, 0.5};
       },
       {"ROTATION_NON_UNIT /nodes/0/rotation"}},
      {"matrix and scale",
       [](Model& m) {
         node(m)["matrix"] = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1};
         node(m)["scale"] = {1, 1, 1};
       },
       {"NODE_MATRIX_TRS /nodes/0/matrix"}},
      {"sheared matrix",
       [](Model& m) { node(m)["matrix"] = {1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}; },
       {"NODE_MATRIX_NON_TRS /nodes/0/matrix"}},
      {"projection",
       [](Model& m) { node(m)["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1}; },
       {"NODE_MATRIX_NON_TRS /nodes/0/matrix"}},
      {"mirrored matrix",
       [](Model& m) { node(m)["matrix"] = {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 5, 5, 1}; },
       {}},
      {"skin without mesh",
       [](Model& m) {
         m.document["skins"] = {{{"joints", {0}}}};
         m.append("nodes", {{"skin", 0}});
       },
       {"UNSATISFIED_DEPENDENCY /nodes/1/skin"}},
  });
}

}  // namespace
}  // namespace barrido::scene::test
