// Every kind of accessor, and its bounds.
#include <cmath>
#include <limits>

#include "import_support.h"

namespace barrido::scene::test {
namespace {

const std::vector<float> kTriangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};

const Primitive& only_primitive(const Scene& scene) { return scene.meshes.at(0).primitives.at(0); }

/// The triangle with another accessor as its TEXCOORD_0.
std::vector<float> texcoords(Model& model, int accessor) {
  primitive(model)["attributes"]["TEXCOORD_0"] = accessor;
  return values(only_primitive(model.import()).texcoords[0]);
}

TEST(Accessor, PackedFloatsAndIndicesAreViewedInPlace) {
  Model model = triangle();
  model.document["accessors"][1] = model.document["accessors"][0];  // Replaced below.
  const int view = model.add_view(std::vector<std::uint32_t>{2, 1, 0});
  model.document["accessors"][1] = {
      {"bufferView", view}, {"componentType", kU32}, {"type", "SCALAR"}, {"count", 3}};
  const TemporaryFolder folder;
  const Scene scene = import_gltf(folder.write("model.glb", model.glb()));
  const Primitive& made = only_primitive(scene);
  // Positions, 6 bytes of the first indices padded to 8, then these: distances as in the file.
  const auto distance = reinterpret_cast<std::uintptr_t>(made.indices.data()) -
                        reinterpret_cast<std::uintptr_t>(made.positions.data());
  EXPECT_EQ(distance, 36u + 8u);
  EXPECT_EQ(values(made.indices), (std::vector<std::uint32_t>{2, 1, 0}));
}

TEST(Accessor, PrimitivesWithOneAccessorShareItsNumbers) {
  Model model = triangle();
  const std::vector<std::uint8_t> bytes = {0, 0, 0, 0, 255, 0, 0, 0, 0, 255, 0, 0};
  const int converted = model.add_accessor(model.add_view(bytes, 4), kU8, "VEC2", 3, true);
  primitive(model)["attributes"]["TEXCOORD_0"] = converted;
  model.document["meshes"].push_back(model.document["meshes"][0]);
  const Scene scene = model.import();
  EXPECT_EQ(scene.meshes[0].primitives[0].indices.data(), scene.meshes[1].primitives[0].indices.data());
  EXPECT_EQ(scene.meshes[0].primitives[0].texcoords[0].data(),
            scene.meshes[1].primitives[0].texcoords[0].data());
}

template <typename T>
void expect_converted(int type, bool normalized, const std::vector<T>& in,
                      const std::vector<float>& expected) {
  Model model = triangle();
  std::vector<T> padded;  // Two components, then padding up to a stride of 8 bytes.
  for (std::size_t i = 0; i < in.size(); i += 2) {
    padded.insert(padded.end(), {in[i], in[i + 1]});
    padded.resize(padded.size() + 8 / sizeof(T) - 2);
  }
  const int accessor = model.add_accessor(model.add_view(padded, 8), type, "VEC2", 3, normalized);
  EXPECT_EQ(texcoords(model, accessor), expected) << type << (normalized ? " normalized" : "");
}

TEST(Accessor, IntegersAreConvertedAsTheSpecificationSays) {
  expect_converted<std::uint8_t>(kU8, true, {0, 255, 51, 102, 1, 254},
                                 {0, 1, 0.2f, 0.4f, 1 / 255.0f, 254 / 255.0f});
  expect_converted<std::int8_t>(kI8, true, {0, 127, -127, -128, 64, 1},
                                {0, 1, -1, -1, 64 / 127.0f, 1 / 127.0f});
  expect_converted<std::uint16_t>(kU16, true, {0, 65535, 13107, 1, 2, 3},
                                  {0, 1, 0.2f, 1 / 65535.0f, 2 / 65535.0f, 3 / 65535.0f});
  expect_converted<std::int16_t>(kI16, true, {0, 32767, -32767, -32768, 1, -1},
                                 {0, 1, -1, -1, 1 / 32767.0f, -1 / 32767.0f});
  expect_converted<std::uint8_t>(kU8, false, {0, 255, 3, 4, 5, 6}, {0, 255, 3, 4, 5, 6});
  expect_converted<std::int8_t>(kI8, false, {-128, 127, 3, 4, 5, 6}, {-128, 127, 3, 4, 5, 6});
  expect_converted<std::uint16_t>(kU16, false, {0, 65535, 3, 4, 5, 6}, {0, 65535, 3, 4, 5, 6});
  expect_converted<std::int16_t>(kI16, false, {-32768, 32767, 3, 4, 5, 6}, {-32768, 32767, 3, 4, 5, 6});
}

TEST(Accessor, StridedFloats) {
  Model model = triangle();
  const std::vector<float> interleaved = {1, 2, 99, 3, 4, 99, 5, 6, 99};
  const int accessor = model.add_accessor(model.add_view(interleaved, 12), kF32, "VEC2", 3);
  EXPECT_EQ(texcoords(model, accessor), (std::vector<float>{1, 2, 3, 4, 5, 6}));
}

TEST(Accessor, LastElementOfAStrideNeedsNoPadding) {
  Model model = triangle();
  const std::vector<float> interleaved = {1, 2, 99, 3, 4, 99, 5, 6};
  const int accessor = model.add_accessor(model.add_view(interleaved, 12), kF32, "VEC2", 3);
  EXPECT_EQ(texcoords(model, accessor), (std::vector<float>{1, 2, 3, 4, 5, 6}));
}

TEST(Accessor, UnalignedFloatsAreCopied) {
  Model model = triangle();
  const std::vector<float> numbers = {1, 2, 3, 4, 5, 6};
  const int accessor = model.add_accessor(model.add_view(numbers, 0, 1), kF32, "VEC2", 3);
  EXPECT_EQ(texcoords(model, accessor), numbers);
}

TEST(Accessor, WithoutABufferViewAllIsZero) {
  Model model = triangle();
  EXPECT_EQ(texcoords(model, model.add_accessor(-1, kF32, "VEC2", 3)), std::vector<float>(6, 0.0f));
}

template <typename Index>
void expect_sparse(int index_type) {
  for (const bool with_base : {true, false}) {
    Model model = triangle();
    const int base = with_base ? model.add_view(std::vector<float>{1, 2, 3, 4, 5, 6}) : -1;
    const int accessor = model.add_accessor(base, kF32, "VEC2", 3);
    const int indices = model.add_view(std::vector<Index>{0, 2});
    const int numbers = model.add_view(std::vector<float>{-1, -2, -5, -6});
    model.document["accessors"][static_cast<std::size_t>(accessor)]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", indices}, {"componentType", index_type}}},
        {"values", {{"bufferView", numbers}}}};
    const float kept_u = with_base ? 3.0f : 0.0f;
    const float kept_v = with_base ? 4.0f : 0.0f;
    EXPECT_EQ(texcoords(model, accessor), (std::vector<float>{-1, -2, kept_u, kept_v, -5, -6}));
  }
}

TEST(Accessor, SparseElementsReplaceThoseOfTheView) {
  expect_sparse<std::uint8_t>(kU8);
  expect_sparse<std::uint16_t>(kU16);
  expect_sparse<std::uint32_t>(kU32);
}

std::string sparse_error(const std::vector<std::uint16_t>& sparse_indices, const json& patch) {
  Model model = triangle();
  const int indices = model.add_view(sparse_indices);
  const int numbers = model.add_view(kTriangle);
  json sparse = {{"count", sparse_indices.size()},
                 {"indices", {{"bufferView", indices}, {"componentType", kU16}}},
                 {"values", {{"bufferView", numbers}}}};
  sparse.merge_patch(patch);
  model.document["accessors"][0]["sparse"] = sparse;
  return import_error(model);
}

TEST(Accessor, SparseBoundsAreChecked) {
  EXPECT_CONTAINS(sparse_error({0, 3}, json::object()),
                  "accessors[0].sparse.indices: element 1 is 3, but there are only 3");
  EXPECT_CONTAINS(sparse_error({1, 1}, json::object()), "element 1 is 1, but indices must ascend");
  EXPECT_CONTAINS(sparse_error({1, 0}, json::object()), "indices must ascend");
  EXPECT_CONTAINS(sparse_error({0, 1}, {{"count", 4}}), "sparse: has more elements than the accessor");
  EXPECT_CONTAINS(sparse_error({0, 1}, {{"count", 3}}),
                  "sparse.indices: byteOffset 0 + 6 bytes reaches past");
  EXPECT_CONTAINS(sparse_error({0, 1}, {{"values", {{"byteOffset", 16}}}}),
                  "sparse.values: byteOffset 16 + 24");
  EXPECT_CONTAINS(sparse_error({0, 1}, {{"indices", {{"componentType", 5122}}}}), "5122 is not unsigned");
  EXPECT_CONTAINS(sparse_error({0, 1}, {{"indices", {{"bufferView", 77}}}}), "refers to bufferViews[77]");
  EXPECT_CONTAINS(sparse_error({0, 1}, {{"values", {{"bufferView", -1}}}}), "refers to bufferViews[-1]");
}

TEST(Accessor, BoundsAreExact) {
  const auto error = [](const char* pointer, std::uint64_t value) {
    Model model = triangle();
    model.document[json::json_pointer(pointer)] = value;
    return import_error(model);
  };
  EXPECT_CONTAINS(error("/accessors/0/count", 4),
                  "accessors[0]: byteOffset 0 + 48 bytes reaches past the end of bufferViews[0] (36 bytes)");
  EXPECT_CONTAINS(error("/accessors/0/byteOffset", 4), "accessors[0]: byteOffset 4 + 36 bytes");
  EXPECT_CONTAINS(error("/accessors/0/count", 2'000'000'000),
                  "the file has more than 100000000 vertices, the importer's limit");
  EXPECT_CONTAINS(error("/accessors/0/byteOffset", 1ull << 62), "byteOffset: is 4.6");
  EXPECT_CONTAINS(error("/accessors/0/byteOffset", 1ull << 53), "reaches past the end");
  EXPECT_CONTAINS(error("/bufferViews/0/byteLength", 35), "accessors[0]: byteOffset 0 + 36 bytes");
  EXPECT_CONTAINS(error("/bufferViews/1/byteLength", 7), "bufferViews[1]: byteOffset 36 + 7 bytes");
  EXPECT_CONTAINS(error("/bufferViews/1/byteOffset", 37), "bufferViews[1]: byteOffset 37 + 6 bytes");
  EXPECT_CONTAINS(error("/bufferViews/0/byteStride", 8),
                  "its elements of 12 bytes are larger than the byteStride 8");
  Model beyond_32_bits = triangle();
  beyond_32_bits.document["bufferViews"][0]["byteStride"] = 64;
  beyond_32_bits.document["accessors"][0]["count"] = (1 << 26) + 1;
  EXPECT_CONTAINS(import_error(beyond_32_bits), "accessors[0]: byteOffset 0 + 4294967308 bytes reaches past");
}

TEST(Accessor, MatrixColumnsArePaddedToFourBytes) {
  Model model = triangle();
  const int view = model.add_view(std::vector<std::uint8_t>(11));
  model.add_accessor(view, kU8, "MAT3", 1);  // 3 columns of 3 bytes, each padded to 4.
  const Scene scene = model.import();
  ASSERT_EQ(scene.warnings.size(), 1u) << "nothing uses it";
  EXPECT_CONTAINS(scene.warnings[0], "accessors[2]: byteOffset 0 + 12 bytes reaches past");
}

TEST(Accessor, WhatIsBrokenAndNotDrawnIsAWarning) {
  Model model = triangle();
  const int broken = model.add_accessor(model.add_view(std::vector<float>(8)), kF32, "VEC3", 3);
  model.append("meshes", {{"primitives", {{{"attributes", {{"POSITION", broken}}}}}}});
  const Scene scene = model.import();
  ASSERT_EQ(scene.warnings.size(), 2u);
  EXPECT_CONTAINS(scene.warnings[0], "accessors[2]: byteOffset 0 + 36");
  EXPECT_CONTAINS(scene.warnings[0], "nothing draws this mesh");
  EXPECT_EQ(scene.meshes.size(), 2u);
  EXPECT_TRUE(scene.meshes[1].primitives.empty());
  model.append("nodes", {{"mesh", 1}});
  model.document["scenes"][0]["nodes"].push_back(1);
  EXPECT_CONTAINS(import_error(model), "accessors[2]: byteOffset 0 + 36");
}

TEST(Accessor, NumbersThatAreNotFiniteBecomeZeroWithOneWarning) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kLargest = std::numeric_limits<float>::max();
  Model model = triangle();
  const std::vector<float> positions = {kNan,     1,         -kInfinity, 2,    kInfinity,
                                        kLargest, -kLargest, 1e-45f,     -kNan};
  primitive(model)["attributes"]["POSITION"] = model.add_accessor(model.add_view(positions), kF32, "VEC3", 3);
  const std::vector<float> texcoord = {kNan, 1, 2, 3, 4, 5};
  primitive(model)["attributes"]["TEXCOORD_0"] =
      model.add_accessor(model.add_view(texcoord), kF32, "VEC2", 3);
  const Scene scene = model.import();
  EXPECT_EQ(values(only_primitive(scene).positions),
            (std::vector<float>{0, 1, 0, 2, 0, kLargest, -kLargest, 1e-45f, 0}));
  EXPECT_EQ(values(only_primitive(scene).texcoords[0]), (std::vector<float>{0, 1, 2, 3, 4, 5}));
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_CONTAINS(scene.warnings[0], "5 numbers that are not finite");
}

TEST(Accessor, OddNumberOfFloatsIsCheckedToItsEnd) {
  Model model = triangle();
  std::vector<float> positions = kTriangle;
  positions.back() = std::numeric_limits<float>::quiet_NaN();
  primitive(model)["attributes"]["POSITION"] = model.add_accessor(model.add_view(positions), kF32, "VEC3", 3);
  EXPECT_EQ(values(only_primitive(model.import()).positions), kTriangle);
}

TEST(Accessor, SmallFileCannotAskForMuchMemory) {
  Model model = triangle();
  model.document["meshes"][0]["primitives"] = json::array();
  for (int i = 0; i < 3; ++i) {  // 90 million vertices of zeros, none of which the file holds.
    const int zeros = model.add_accessor(-1, kF32, "VEC3", 30'000'000);
    model.document["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", zeros}}}});
  }
  EXPECT_CONTAINS(import_error(model), "needs more than the 352 MiB of memory that it may take");
}

}  // namespace
}  // namespace barrido::scene::test
