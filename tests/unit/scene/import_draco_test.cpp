// Primitives compressed by Draco: streams are made here by the library's encoder; what comes out is the mesh
// that went in, and whatever does not fit the accessors is refused.
#include "import_support.h"

#ifdef BARRIDO_TEST_DRACO
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>

namespace barrido::scene::test {
namespace {

using Stream = std::vector<std::uint8_t>;

/// A fan of `count` triangles around the origin, each with corners of its own.
std::unique_ptr<draco::Mesh> fan(int count) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(count);
  const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int color = builder.AddAttribute(draco::GeometryAttribute::COLOR, 4, draco::DT_UINT8);
  for (int i = 0; i < count; ++i) {
    const auto at = [&](int k) {
      return std::array<float, 3>{static_cast<float>(k) / 8.0f, static_cast<float>(k * k) / 64.0f, 0.5f};
    };
    const std::array<float, 3> origin{0, 0, 0}, a = at(i), b = at(i + 1);
    builder.SetAttributeValuesForFace(position, draco::FaceIndex(i), origin.data(), a.data(), b.data());
    const std::array<std::uint8_t, 4> tone{static_cast<std::uint8_t>(i), 7, 9, 255};
    builder.SetAttributeValuesForFace(color, draco::FaceIndex(i), tone.data(), tone.data(), tone.data());
  }
  return builder.Finalize();
}

Stream encode(const draco::Mesh& mesh, int method) {
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(mesh, &buffer).ok());
  return {buffer.data(), buffer.data() + buffer.size()};
}

constexpr int kFaces = 40;

/// A model whose one primitive holds the stream; accessors 0 positions, 1 colours, 2 indices.
Model with_stream(const Stream& stream, std::size_t points) {
  Model model;
  const int view = model.add_view(stream);
  model.add_accessor(-1, kF32, "VEC3", points);
  model.add_accessor(-1, kU8, "VEC4", points, true);
  model.add_accessor(-1, kU16, "SCALAR", kFaces * 3);
  model.document["meshes"] = {
      {{"primitives",
        {{{"attributes", {{"POSITION", 0}, {"COLOR_0", 1}}},
          {"indices", 2},
          {"extensions",
           {{"KHR_draco_mesh_compression",
             {{"bufferView", view}, {"attributes", {{"POSITION", 0}, {"COLOR_0", 1}}}}}}}}}}}};
  model.document["nodes"] = {{{"mesh", 0}}};
  model.document["extensionsUsed"] = {"KHR_draco_mesh_compression"};
  return model;
}

class DracoMethods : public testing::TestWithParam<int> {};

TEST_P(DracoMethods, GiveTheMeshThatWentIn) {
  const auto mesh = fan(kFaces);
  const Scene scene = with_stream(encode(*mesh, GetParam()), mesh->num_points()).import();
  const Primitive& read = scene.meshes[0].primitives[0];
  ASSERT_EQ(read.indices.size(), 3u * kFaces);
  // Order is the encoder's: each triangle is found by its colour.
  std::vector<bool> found(kFaces);
  for (std::size_t t = 0; t < kFaces; ++t) {
    const auto tone = static_cast<int>(read.colors.data()[4 * read.indices[3 * t]] * 255.0f + 0.5f);
    ASSERT_LT(tone, kFaces);
    found[static_cast<std::size_t>(tone)] = true;
    float largest = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(static_cast<int>(read.colors.data()[4 * read.indices[3 * t + c]] * 255.0f + 0.5f), tone);
      largest = std::max(largest, read.positions.data()[3 * read.indices[3 * t + c]]);
    }
    EXPECT_EQ(largest, static_cast<float>(tone + 1) / 8.0f);
  }
  EXPECT_EQ(std::count(found.begin(), found.end(), true), kFaces);
}

INSTANTIATE_TEST_SUITE_P(Methods, DracoMethods,
                         testing::Values(draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING));

TEST_P(DracoMethods, StreamsCutOffAnywhereAreRefused) {
  const auto mesh = fan(kFaces);
  const Stream stream = encode(*mesh, GetParam());
  for (std::size_t length = 1; length < stream.size(); length += 1 + stream.size() / 50) {
    Model model = with_stream(stream, mesh->num_points());
    model.document["bufferViews"][0]["byteLength"] = length;
    const std::string error = import_error(model);
    EXPECT_CONTAINS(error, "meshes[0].primitives[0]: ");
    EXPECT_EQ(error.find('\n'), std::string::npos);
  }
}

TEST_P(DracoMethods, ChangedBytesEndWell) {
  const auto mesh = fan(kFaces);
  const Stream stream = encode(*mesh, GetParam());
  for (std::size_t i = 0; i < stream.size(); ++i) {
    for (const std::uint8_t byte : {0x00, 0x7f, 0xff}) {
      Stream changed = stream;
      changed[i] = byte;
      try {
        with_stream(changed, mesh->num_points()).import();
      } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      }
    }
  }
}

/// "DRACO", version 2.2, triangle mesh, method, flags; then the counts as variable length integers.
TEST(Draco, CountsThatLieTakeNoMemory) {
  const Stream header{'D', 'R', 'A', 'C', 'O', 2, 2, 1};
  const Stream huge{0xff, 0xff, 0xff, 0xff, 0x07};  // 2^31 − 1
  for (const std::uint8_t method : {0, 1}) {
    Stream stream = header;
    stream.insert(stream.end(), {method, 0, 0});
    for (int i = 0; i < 8; ++i) stream.insert(stream.end(), huge.begin(), huge.end());
    stream.resize(stream.size() + 4000);
    EXPECT_CONTAINS(import_error(with_stream(stream, 100)), "meshes[0].primitives[0]: ");
  }
}

TEST(Draco, WhatDoesNotFitTheAccessorsIsRefused) {
  const auto mesh = fan(kFaces);
  const Model whole = with_stream(encode(*mesh, draco::MESH_EDGEBREAKER_ENCODING), mesh->num_points());
  const struct {
    const char* path;
    json value;
    const char* says;
  } kLies[] = {
      {"/accessors/2/count", 3 * kFaces + 3, "indices, but accessors[2] has 123"},
      {"/accessors/0/count", 7, "its accessors differ in count"},
      {"/accessors/0/type", "VEC4", "has 3 components"},
      {"/meshes/0/primitives/0/mode", 5, "its mode is another"},
      {"/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression/bufferView", 4, "is not there"},
      {"/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression/attributes/POSITION", 9, "is not there"},
      {"/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression/attributes/POSITION", -1,
       "in the Draco stream is none"},
      {"/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression/attributes", json::object(),
       "no attributes"},
  };
  for (const auto& lie : kLies) {
    Model model = whole;
    model.document[json::json_pointer(lie.path)] = lie.value;
    EXPECT_CONTAINS(import_error(model), lie.says) << lie.path;
  }
}

TEST(Draco, AFallbackStandsInForADamagedStream) {
  const auto mesh = fan(kFaces);
  Model model = with_stream(encode(*mesh, draco::MESH_SEQUENTIAL_ENCODING), 3);
  const auto view = [&](const auto& values) { return model.add_view(values); };
  model.document["accessors"][0]["bufferView"] = view(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0});
  model.document["accessors"][1]["bufferView"] = view(std::vector<std::uint8_t>(12, 255));
  model.document["accessors"][2]["bufferView"] = view(std::vector<std::uint16_t>{0, 1, 2});
  model.document["accessors"][2]["count"] = 3;
  const Scene scene = model.import();
  EXPECT_EQ(values(scene.meshes[0].primitives[0].indices), (std::vector<std::uint32_t>{0, 1, 2}));
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_CONTAINS(scene.warnings[0], "its uncompressed accessors are used");
}

}  // namespace
}  // namespace barrido::scene::test
#endif
