// GLB's header and chunks, and the depth of JSON.
#include "import_support.h"
#include "pipeline/gltf/container.h"

namespace barrido::scene::test {
namespace {

class Glb : public testing::Test {
 protected:
  std::string error() const {
    return input_error([&] { import(); });
  }
  Scene import() const {
    const TemporaryFolder folder;
    return import_gltf(folder.write("model.glb", file));
  }
  void put(std::size_t offset, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i) file[offset + i] = static_cast<std::uint8_t>(value >> (8 * i));
  }
  std::uint32_t get(std::size_t offset) const {
    std::uint32_t value;
    std::memcpy(&value, file.data() + offset, 4);
    return value;
  }
  std::size_t binary_chunk() const { return 20 + get(12); }

  std::vector<std::uint8_t> file = triangle().glb();
};

TEST_F(Glb, TriangleIsRead) {
  const Scene scene = import();
  EXPECT_EQ(values(scene.meshes.at(0).primitives.at(0).positions),
            (std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
  EXPECT_EQ(values(scene.meshes[0].primitives[0].indices), (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(Glb, ContentDecidesNotTheName) {
  const TemporaryFolder folder;
  EXPECT_EQ(import_gltf(folder.write("model.gltf", file)).meshes.size(), 1u);
}

TEST_F(Glb, OtherVersionIsRefused) {
  put(4, 1);
  EXPECT_CONTAINS(error(), "model.glb: GLB header: container version 1");
}

TEST_F(Glb, LengthBeyondTheFileIsRefused) {
  put(8, get(8) + 4);
  EXPECT_CONTAINS(error(), "GLB header: gives a length of");
}

TEST_F(Glb, BytesBehindTheEndAreAWarning) {
  file.insert(file.end(), 5, 0);
  const Scene scene = import();
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_CONTAINS(scene.warnings[0], "5 bytes longer");
}

TEST_F(Glb, ChunkBeyondTheFileIsRefused) {
  put(12, 0xffffffff);
  EXPECT_CONTAINS(error(), "GLB chunk 0: reaches past the end");
}

TEST_F(Glb, UnalignedChunkIsRefused) {
  put(binary_chunk(), get(binary_chunk()) - 1);
  EXPECT_CONTAINS(error(), "GLB chunk 1: its length is not a multiple of 4");
}

TEST_F(Glb, FirstChunkMustBeJson) {
  put(16, 0x004e4942);
  EXPECT_CONTAINS(error(), "GLB chunk 0: is not JSON");
}

TEST_F(Glb, SecondJsonChunkIsRefused) {
  put(binary_chunk() + 4, 0x4e4f534a);
  EXPECT_CONTAINS(error(), "GLB chunk 1: is a second JSON chunk");
}

TEST_F(Glb, UnknownChunkIsSkipped) {
  file.insert(file.end(), {4, 0, 0, 0, 'X', 'Y', 'Z', ' ', 1, 2, 3, 4});
  put(8, static_cast<std::uint32_t>(file.size()));
  EXPECT_EQ(import().meshes.size(), 1u);
}

TEST_F(Glb, EveryPrefixOfAFileIsAnErrorAndNoCrash) {
  const std::vector<std::uint8_t> whole = file;
  for (std::size_t size = 0; size < whole.size(); size += size < 40 ? 1 : 37) {
    file.assign(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_FALSE(error().empty()) << size;
  }
}

TEST(GltfContainer, NeitherGlbNorJson) {
  const TemporaryFolder folder;
  EXPECT_CONTAINS(input_error([&] { import_gltf(folder.write("a.gltf", "solid cube")); }), "neither GLB");
  EXPECT_CONTAINS(input_error([&] { import_gltf(folder.write("b.gltf", "")); }), "b.gltf: the file is empty");
}

TEST(GltfContainer, ByteOrderMarkIsIgnored) {
  const TemporaryFolder folder;
  EXPECT_NO_THROW(import_gltf(folder.write("a.gltf", "\xef\xbb\xbf{\"asset\":{\"version\":\"2.0\"}}")));
}

TEST(GltfJsonDepth, LimitIsExact) {
  gltf::Report report("model.gltf");
  const auto nested = [](int depth) {
    return std::string(static_cast<std::size_t>(depth), '[') +
           std::string(static_cast<std::size_t>(depth), ']');
  };
  EXPECT_NO_THROW(gltf::check_json_depth(report, nested(64), 64));
  EXPECT_THROW(gltf::check_json_depth(report, nested(65), 64), InputError);
}

TEST(GltfJsonDepth, BracketsInStringsDoNotCount) {
  gltf::Report report("model.gltf");
  EXPECT_NO_THROW(gltf::check_json_depth(report, R"({"a":"[[[[[[","b":"\"[[[[","c":"\\"})", 2));
  EXPECT_THROW(gltf::check_json_depth(report, R"({"a":"\\",[["]])", 2), InputError);
}

TEST(GltfJsonDepth, HundredThousandLevelsAreRefused) {
  const TemporaryFolder folder;
  std::string text = R"({"asset":{"version":"2.0"},"extras":)";
  text += std::string(100000, '[') + std::string(100000, ']') + "}";
  EXPECT_CONTAINS(input_error([&] { import_gltf(folder.write("deep.gltf", text)); }), "nest deeper than 64");
}

}  // namespace
}  // namespace barrido::scene::test
