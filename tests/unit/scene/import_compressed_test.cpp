// Compressed buffer views (EXT_meshopt_compression): streams are made here by the library's encoders, what
// comes out is compared bit for bit with the numbers that went in, or with the filters' formulas in plain
// code.
#include <bit>
#include <cmath>

#include "import_support.h"

#ifdef BARRIDO_TEST_MESHOPTIMIZER
#include <meshoptimizer.h>

namespace barrido::scene::test {
namespace {

using Stream = std::vector<std::uint8_t>;

Stream encode_vertices(const void* vertices, std::size_t count, std::size_t stride) {
  Stream stream(meshopt_encodeVertexBufferBound(count, stride));
  stream.resize(meshopt_encodeVertexBuffer(stream.data(), stream.size(), vertices, count, stride));
  return stream;
}

Stream encode_triangles(const std::vector<std::uint32_t>& indices, std::size_t vertices) {
  Stream stream(meshopt_encodeIndexBufferBound(indices.size(), vertices));
  stream.resize(meshopt_encodeIndexBuffer(stream.data(), stream.size(), indices.data(), indices.size()));
  return stream;
}

/// Puts `stream` in the place of a buffer view's own bytes, which then are in a buffer that nobody has.
json& compress(Model& model, int view, const Stream& stream, const char* mode, std::size_t count,
               std::size_t stride) {
  const int compressed = model.add_view(stream);
  json& views = model.document["bufferViews"];
  views[static_cast<std::size_t>(view)]["extensions"]["EXT_meshopt_compression"] = {
      {"buffer", 0},
      {"byteOffset", views[static_cast<std::size_t>(compressed)]["byteOffset"]},
      {"byteLength", stream.size()},
      {"byteStride", stride},
      {"count", count},
      {"mode", mode}};
  views.erase(static_cast<std::size_t>(compressed));
  views[static_cast<std::size_t>(view)]["buffer"] = 1;
  views[static_cast<std::size_t>(view)].erase("byteOffset");
  return views[static_cast<std::size_t>(view)]["extensions"]["EXT_meshopt_compression"];
}

constexpr std::uint32_t kSide = 17;

/// A bent sheet of kSide² vertices.
struct Sheet {
  Sheet() {
    for (std::size_t i = 0; i < kSide * kSide; ++i) {
      const auto x = static_cast<float>(i % kSide), y = static_cast<float>(i / kSide);
      positions.insert(positions.end(), {x, y * 0.3f, std::sin(x * 0.37f) * y});
    }
    for (std::uint32_t y = 0; y + 1 < kSide; ++y) {
      for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
        const std::uint32_t at = y * kSide + x;
        indices.insert(indices.end(), {at, at + 1, at + kSide, at + kSide, at + 1, at + 1 + kSide});
      }
    }
  }
  Model plain() const {
    Model model;
    model.add_accessor(model.add_view(positions), kF32, "VEC3", kSide * kSide);
    model.add_accessor(model.add_view(indices), kU32, "SCALAR", indices.size());
    model.document["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}};
    model.document["nodes"] = {{{"mesh", 0}}};
    model.document["extensionsUsed"] = {"EXT_meshopt_compression"};
    return model;
  }
  std::vector<float> positions;
  std::vector<std::uint32_t> indices;
};

/// The sheet with both its views compressed.
Model compressed_sheet(const Sheet& sheet) {
  Model model = sheet.plain();
  compress(model, 0, encode_vertices(sheet.positions.data(), kSide * kSide, 12), "ATTRIBUTES", kSide * kSide,
           12);
  compress(model, 1, encode_triangles(sheet.indices, kSide * kSide), "TRIANGLES", sheet.indices.size(), 4);
  return model;
}

/// The file's text with the second buffer, which is there in name only.
std::filesystem::path write(const Model& model, const TemporaryFolder& folder, const json& second) {
  const std::filesystem::path path = model.write_gltf(folder);
  json document = json::parse(std::ifstream(path));
  document["buffers"].push_back(second);
  return folder.write("model.gltf", document.dump());
}

Scene import(const Model& model, const json& second = {{"byteLength", 100000}}) {
  const TemporaryFolder folder;
  return import_gltf(write(model, folder, second));
}

json& extension(Model& model, std::size_t view) {
  return model.document["bufferViews"][view]["extensions"]["EXT_meshopt_compression"];
}

TEST(CompressedViews, GiveTheSameNumbers) {
  const Sheet sheet;
  const Scene scene = import(compressed_sheet(sheet));
  const Primitive& primitive = scene.meshes[0].primitives[0];
  EXPECT_EQ(values(primitive.positions), sheet.positions);
  // The codec may turn a triangle's corners round.
  const std::vector<std::uint32_t> indices = values(primitive.indices);
  ASSERT_EQ(indices.size(), sheet.indices.size());
  for (std::size_t t = 0; t < indices.size(); t += 3) {
    std::size_t turn = 0;
    while (turn < 3 && indices[t + turn] != sheet.indices[t]) ++turn;
    ASSERT_LT(turn, 3u);
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_EQ(indices[t + (turn + c) % 3], sheet.indices[t + c]) << "triangle " << t / 3;
    }
  }
  EXPECT_TRUE(scene.warnings.empty());
}

TEST(CompressedViews, SequencesOfIndices) {
  const Sheet sheet;
  Model model = sheet.plain();
  Stream stream(meshopt_encodeIndexSequenceBound(sheet.indices.size(), kSide * kSide));
  stream.resize(
      meshopt_encodeIndexSequence(stream.data(), stream.size(), sheet.indices.data(), sheet.indices.size()));
  compress(model, 1, stream, "INDICES", sheet.indices.size(), 4);
  EXPECT_EQ(values(import(model).meshes[0].primitives[0].indices), sheet.indices);
}

/// What the filters make of four stored numbers, by the formulas of the extension's text (section "Filters").
struct Filtered {
  static std::vector<float> octahedral(const std::int8_t* v) {
    const float one = v[2];
    float x = static_cast<float>(v[0]) / one, y = static_cast<float>(v[1]) / one;
    const float z = 1.0f - std::abs(x) - std::abs(y), t = std::min(z, 0.0f);
    x += x >= 0 ? t : -t;
    y += y >= 0 ? t : -t;
    const float length = std::sqrt(x * x + y * y + z * z);
    const auto stored = [&](float n) { return std::max(std::round(n / length * 127.0f) / 127.0f, -1.0f); };
    return {stored(x), stored(y), stored(z)};
  }
  static float exponential(std::int32_t v) { return std::ldexp(static_cast<float>(v << 8 >> 8), v >> 24); }
};

TEST(CompressedViews, OctahedralFilter) {
  const Sheet sheet;
  std::vector<std::int8_t> normals;
  for (int i = 0; i < static_cast<int>(kSide * kSide); ++i) {
    normals.insert(normals.end(), {static_cast<std::int8_t>(i * 7 % 255 - 127),
                                   static_cast<std::int8_t>(i * 29 % 255 - 127), 127, 0});
  }
  Model model = sheet.plain();
  const int view = model.add_view(normals, 4);
  const int accessor = model.add_accessor(view, kI8, "VEC3", kSide * kSide, true);
  primitive(model)["attributes"]["NORMAL"] = accessor;
  compress(model, view, encode_vertices(normals.data(), kSide * kSide, 4), "ATTRIBUTES", kSide * kSide,
           4)["filter"] = "OCTAHEDRAL";
  const std::vector<float> read = values(import(model).meshes[0].primitives[0].normals);
  for (std::size_t i = 0; i < kSide * kSide; ++i) {
    const std::vector<float> wanted = Filtered::octahedral(normals.data() + 4 * i);
    const float length = std::hypot(wanted[0], wanted[1], wanted[2]);
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_NEAR(read[3 * i + c], wanted[c] / length, 1.0f / 127.0f) << i << ' ' << c;
    }
  }
}

TEST(CompressedViews, ExponentialFilter) {
  const Sheet sheet;
  std::vector<std::int32_t> stored;
  for (int i = 0; i < static_cast<int>(kSide * kSide * 3); ++i) {
    stored.push_back(static_cast<std::int32_t>(static_cast<std::uint32_t>(i % 31 - 20) << 24 |
                                               (static_cast<std::uint32_t>(i * 7919 - 900000) & 0xffffffu)));
  }
  Model model = sheet.plain();
  compress(model, 0, encode_vertices(stored.data(), kSide * kSide, 12), "ATTRIBUTES", kSide * kSide,
           12)["filter"] = "EXPONENTIAL";
  const std::vector<float> read = values(import(model).meshes[0].primitives[0].positions);
  for (std::size_t i = 0; i < stored.size(); ++i) {
    ASSERT_EQ(read[i], Filtered::exponential(stored[i])) << i << ": " << stored[i];
  }
}

TEST(CompressedViews, QuaternionFilter) {
  constexpr std::size_t kKeys = 40;
  const Sheet sheet;
  Model model = sheet.plain();
  std::vector<float> rotations, times;
  for (std::size_t i = 0; i < kKeys; ++i) {
    const auto angle = static_cast<float>(i) * 0.17f;
    rotations.insert(rotations.end(), {0.6f * std::sin(angle), 0, 0.8f * std::sin(angle), std::cos(angle)});
    times.push_back(static_cast<float>(i));
  }
  std::vector<std::int16_t> packed(4 * kKeys);
  meshopt_encodeFilterQuat(packed.data(), kKeys, 8, 16, rotations.data());
  const int view = model.add_view(packed);
  const int output = model.add_accessor(view, kI16, "VEC4", kKeys, true);
  const int input = model.add_accessor(model.add_view(times), kF32, "SCALAR", kKeys);
  model.document["animations"] = {
      {{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "rotation"}}}}}},
       {"samplers", {{{"input", input}, {"output", output}}}}}};
  compress(model, view, encode_vertices(packed.data(), kKeys, 8), "ATTRIBUTES", kKeys, 8)["filter"] =
      "QUATERNION";
  const std::vector<float> read = import(model).animations[0].channels[0].values;
  for (std::size_t i = 0; i < kKeys; ++i) {
    float dot = 0;
    for (std::size_t c = 0; c < 4; ++c) dot += read[4 * i + c] * rotations[4 * i + c];
    ASSERT_NEAR(std::abs(dot), 1.0f, 1e-3f) << i;
  }
}

TEST(CompressedViews, StreamsCutOffAnywhereAreRefused) {
  const Sheet sheet;
  const Model whole = compressed_sheet(sheet);
  for (std::size_t view : {0u, 1u}) {
    Model model = whole;
    const auto length = extension(model, view)["byteLength"].get<std::size_t>();
    for (std::size_t cut = 0; cut < length; cut += 1 + length / 60) {
      extension(model, view)["byteLength"] = cut;
      const std::string error = input_error([&] { import(model); });
      EXPECT_CONTAINS(error, "bufferViews[" + std::to_string(view) + "]: the compressed bytes are damaged");
    }
  }
}

TEST(CompressedViews, LiesAreRefusedInOneLine) {
  const struct {
    std::size_t view;
    const char* key;
    json value;
    const char* says;
  } kLies[] = {
      {0, "count", 9007199254740992, "memory"},
      {0, "count", 1, "do not fill its byteLength"},
      {1, "count", 9007199254740992 - 2, "memory"},
      {1, "count", 1537, "no whole triangles"},
      {0, "byteStride", 13, "not a multiple of 4"},
      {0, "byteStride", 257, "is not in 1 to 256"},
      {1, "byteStride", 8, "neither 2 nor 4"},
      {0, "byteOffset", 9007199254740992, "past the end"},
      {0, "byteLength", 9007199254740992, "past the end"},
      {0, "buffer", 1, "has no bytes"},
      {0, "buffer", 7, "in a buffer that is not there"},
      {0, "mode", "TRIANGLES", "neither 2 nor 4"},
      {0, "mode", "WRONG", "mode of its compression is unknown"},
      {0, "filter", "OCTAHEDRAL", "neither 4 nor 8"},
      {0, "filter", "QUATERNION", "is not 8"},
      {0, "filter", "COLOR", "filter of its compression is not supported"},
      {1, "filter", "EXPONENTIAL", "no filter"},
  };
  const Sheet sheet;
  for (const auto& lie : kLies) {
    Model model = compressed_sheet(sheet);
    extension(model, lie.view)[lie.key] = lie.value;
    const std::string error = input_error([&] { import(model); });
    EXPECT_CONTAINS(error, lie.says);
    EXPECT_EQ(error.find('\n'), std::string::npos);
  }
}

TEST(CompressedViews, AFallbackStandsInForADamagedStream) {
  const Sheet sheet;
  Model model = compressed_sheet(sheet);
  extension(model, 0)["byteLength"] = 5;
  const TemporaryFolder folder;
  std::vector<std::uint8_t> plain(sheet.positions.size() * sizeof(float));
  std::memcpy(plain.data(), sheet.positions.data(), plain.size());
  plain.resize(100000);
  folder.write("fallback.bin", plain);
  const Scene scene = import_gltf(write(model, folder, {{"byteLength", 100000}, {"uri", "fallback.bin"}}));
  EXPECT_EQ(values(scene.meshes[0].primitives[0].positions), sheet.positions);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_CONTAINS(scene.warnings[0], "bufferViews[0]: the compressed bytes are damaged");
}

}  // namespace
}  // namespace barrido::scene::test
#endif
