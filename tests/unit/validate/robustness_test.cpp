// Anything in any place: a document with a bit of everything, in which one value after the other is replaced
// by what does not belong there. The validator must come back with a report each time.
#include "tests/unit/validate/validate_support.h"

namespace barrido::scene::test {
namespace {

json everything() {
  return json::parse(R"({
    "asset": {"version": "2.0", "minVersion": "2.0", "generator": "test"},
    "extensionsUsed": ["KHR_lights_punctual", "KHR_materials_variants", "KHR_materials_anisotropy", "KHR_materials_clearcoat",
      "KHR_materials_volume", "KHR_materials_emissive_strength", "KHR_texture_transform", "KHR_animation_pointer",
      "EXT_texture_webp", "KHR_mesh_quantization", "A_unknown"],
    "extensionsRequired": ["KHR_mesh_quantization"],
    "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot", "color": [1, 1, 1], "spot": {"innerConeAngle": 0.1}}]},
      "KHR_materials_variants": {"variants": [{"name": "red"}]}},
    "buffers": [{"byteLength": 512, "uri": "data:application/octet-stream;base64,)" +
                     std::string(684, 'A') + R"("}],
    "bufferViews": [{"buffer": 0, "byteLength": 400, "byteStride": 16, "target": 34962}, {"buffer": 0, "byteOffset": 400, "byteLength": 12, "target": 34963},
      {"buffer": 0, "byteLength": 128}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [0, 0, 0]},
      {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR", "min": [0], "max": [0]},
      {"componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [0, 0, 0],
        "sparse": {"count": 1, "indices": {"bufferView": 2, "byteOffset": 0, "componentType": 5121}, "values": {"bufferView": 2, "byteOffset": 4}}},
      {"bufferView": 0, "componentType": 5121, "count": 3, "type": "VEC4"},
      {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC4"},
      {"bufferView": 2, "componentType": 5126, "count": 2, "type": "MAT4"},
      {"bufferView": 2, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [0]},
      {"bufferView": 2, "componentType": 5120, "count": 2, "type": "MAT3", "normalized": true},
      {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC2"}],
    "images": [{"uri": "data:image/png;base64,iVBORw0KGgo="}, {"bufferView": 2, "mimeType": "image/png"}, {"uri": "picture.png", "extras": {}}],
    "samplers": [{"magFilter": 9729, "wrapS": 10497}],
    "textures": [{"sampler": 0, "source": 0, "extensions": {"EXT_texture_webp": {"source": 1}}}, {"source": 2}],
    "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 1], "baseColorTexture": {"index": 0, "texCoord": 0,
        "extensions": {"KHR_texture_transform": {"offset": [0, 0], "texCoord": 1}}}},
      "normalTexture": {"index": 1, "scale": 1}, "occlusionTexture": {"index": 0, "strength": 1}, "emissiveFactor": [0, 0, 0], "alphaMode": "MASK", "alphaCutoff": 0.5,
      "extensions": {"KHR_materials_anisotropy": {"anisotropyTexture": {"index": 0}}, "KHR_materials_clearcoat": {"clearcoatNormalTexture": {"index": 0, "texCoord": 1}},
        "KHR_materials_volume": {"thicknessFactor": 1, "attenuationColor": [1, 1, 1]}, "KHR_materials_emissive_strength": {"emissiveStrength": 2}}}],
    "meshes": [{"weights": [0], "primitives": [{"mode": 4, "attributes": {"POSITION": 0, "NORMAL": 0, "TANGENT": 4, "JOINTS_0": 3, "WEIGHTS_0": 4, "TEXCOORD_0": 8, "COLOR_0": 4},
      "indices": 1, "material": 0, "targets": [{"POSITION": 2}],
      "extensions": {"KHR_materials_variants": {"mappings": [{"material": 0, "variants": [0]}]}, "A_unknown": {"x": [1]}}}]}],
    "skins": [{"joints": [2, 3], "skeleton": 1, "inverseBindMatrices": 5}],
    "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 1, "zfar": 2}}, {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": 0, "zfar": 1}}],
    "nodes": [{"mesh": 0, "skin": 0, "weights": [1], "rotation": [0, 0, 0, 1]}, {"children": [2], "camera": 0, "extensions": {"KHR_lights_punctual": {"light": 0}}},
      {"children": [3], "translation": [0, 1, 0]}, {"scale": [1, 1, 1], "camera": 1}, {"matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}],
    "scenes": [{"nodes": [0, 1]}],
    "scene": 0,
    "animations": [{"samplers": [{"input": 6, "output": 0, "interpolation": "CUBICSPLINE"}, {"input": 6, "output": 4}],
      "channels": [{"sampler": 0, "target": {"node": 2, "path": "translation"}}, {"sampler": 1, "target": {"node": 3, "path": "rotation"}},
        {"sampler": 1, "target": {"path": "pointer", "extensions": {"KHR_animation_pointer": {"pointer": "/nodes/0/rotation"}}}}]}]
  })");
}

/// Where every value stands, objects and arrays included.
void collect_places(const json& value, const json::json_pointer& place,
                    std::vector<json::json_pointer>& places) {
  if (!place.empty()) places.push_back(place);
  if (value.is_object()) {
    for (const auto& [name, inner] : value.items()) collect_places(inner, place / name, places);
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) collect_places(value[i], place / i, places);
  }
}

class AnythingAnywhere : public testing::TestWithParam<const char*> {};

TEST_P(AnythingAnywhere, HasAReport) {
  const json whole = everything();
  std::vector<json::json_pointer> places;
  collect_places(whole, json::json_pointer(), places);
  ASSERT_GT(places.size(), 300u);
  const TemporaryFolder folder;
  for (const json::json_pointer& place : places) {
    SCOPED_TRACE(place.to_string());
    json changed = whole;
    changed[place] = json::parse(GetParam());
    EXPECT_NO_THROW(validate_gltf(folder.write("model.gltf", changed.dump())));
  }
}

INSTANTIATE_TEST_SUITE_P(Values, AnythingAnywhere,
                         testing::Values("null", "true", "-1", "0.5", "7", "18446744073709551615", "1e308",
                                         "\"VEC2\"", "[]", "[-1, null, [0]]", "{}", "{\"POSITION\": -1}"));

TEST(Robustness, TheWholeDocumentIsReadToItsEnd) {
  const ValidationReport report = validate_text(everything().dump());
  ASSERT_TRUE(report.info);
  EXPECT_EQ(report.info->draw_calls, 1u);
  EXPECT_EQ(report.info->max_influences, 4u);
}

}  // namespace
}  // namespace barrido::scene::test
