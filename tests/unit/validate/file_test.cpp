// Faults of the container, of the text and of the files a model refers to.
#include "tests/unit/validate/validate_support.h"

namespace barrido::scene::test {
namespace {

using Lines = std::vector<std::string>;

TEST(ValidateText, SyntaxAndEncoding) {
  const std::string sound = R"({"asset":{"version":"2.0"}})";
  EXPECT_EQ(lines_of(validate_text(sound)), Lines{});
  EXPECT_EQ(lines_of(validate_text("")), Lines{"INVALID_JSON "});
  EXPECT_EQ(lines_of(validate_text(sound.substr(0, 20))), Lines{"INVALID_JSON "});
  EXPECT_EQ(lines_of(validate_text(sound + "x")), Lines{"INVALID_JSON "});
  EXPECT_EQ(lines_of(validate_text("\xef\xbb\xbf" + sound)), Lines{"INVALID_JSON "});
  EXPECT_EQ(lines_of(validate_text("{\"asset\":{\"version\":\"2.0\",\"generator\":\"\xff\"}}")),
            Lines{"INVALID_JSON "});
  EXPECT_EQ(lines_of(validate_text("[]")), Lines{"TYPE_MISMATCH "});
  EXPECT_EQ(lines_of(validate_text(std::string(100'000, '['))), Lines{"INVALID_JSON "});
}

TEST(ValidateText, TheRootIsASlashAndTheFileIsNothing) {
  EXPECT_EQ(lines_of(validate_text("{}")), Lines{"UNDEFINED_PROPERTY /"});
  EXPECT_EQ(lines_of(validate_text("7")), Lines{"TYPE_MISMATCH "});
}

TEST(ValidateUri, BeforeAColonStandsAScheme) {
  const auto buffer = [](const std::string& uri) {
    return lines_of(
        validate_text(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4,"uri":")" + uri + "\"}]}"),
        Severity::warning);
  };
  for (const char* uri : {":", ":a", "1a:b", "a b:c"})
    EXPECT_EQ(buffer(uri), Lines{"INVALID_URI /buffers/0/uri"}) << uri;
  for (const char* uri : {"http:", "a+1.b-c:d", "/a:b", "?:", "#:"}) {
    EXPECT_EQ(buffer(uri), Lines{"NON_RELATIVE_URI /buffers/0/uri"}) << uri;
  }
  EXPECT_EQ(buffer("none/1:2.bin"), Lines{"IO_ERROR /buffers/0/uri"});
  EXPECT_EQ(
      lines_of(validate_text(R"({"asset":{"version":"2.0"},"images":[{"uri":":"}]})"), Severity::warning),
      Lines{"INVALID_URI /images/0/uri"});
}

TEST(ValidateText, AsManyValuesAsAllowed) {
  const std::string text = R"({"asset":{"version":"2.0","generator":",[{"}})";
  EXPECT_EQ(lines_of(validate_text(text, "a.gltf", {.max_json_values = 4})), Lines{});
  EXPECT_EQ(lines_of(validate_text(text, "a.gltf", {.max_json_values = 3})), Lines{"INVALID_JSON "});
}

TEST(ValidateText, NamesThatComeTwice) {
  EXPECT_EQ(
      lines_of(validate_text(R"({"asset":{"version":"2.0"},"nodes":[{"name":"a"},{"name":"a","name":"b"}]})"),
               Severity::error),
      Lines{"DUPLICATE_ELEMENTS /nodes/1/name"});
}

/// A million values: what looks at all of an array for each of its objects does not come to an end.
TEST(ValidateText, ManyObjectsInAnArray) {
  std::string text = R"({"asset":{"version":"2.0"},"extras":{"a":[{"b":1})";
  for (int i = 0; i < 500'000; ++i) text += R"(,{"b":1})";
  EXPECT_EQ(lines_of(validate_text(text + "]}}")), Lines{});
}

TEST(ValidateText, NumbersBeyondADouble) {
  const auto node = [](const char* number) {
    return validate_text(R"({"asset":{"version":"2.0"},"nodes":[{"translation":[0,)" + std::string(number) +
                         ",0]}]}");
  };
  EXPECT_EQ(lines_of(node("1e999"), Severity::error), Lines{"VALUE_NOT_IN_RANGE /nodes/0/translation/1"});
  EXPECT_EQ(lines_of(node("-1e999"), Severity::error), Lines{"VALUE_NOT_IN_RANGE /nodes/0/translation/1"});
  EXPECT_EQ(lines_of(node(std::string(400, '9').c_str()), Severity::error),
            Lines{"VALUE_NOT_IN_RANGE /nodes/0/translation/1"});
  EXPECT_EQ(lines_of(node("1e-999"), Severity::error), Lines{});
  EXPECT_EQ(lines_of(node("1e30"), Severity::error), Lines{});
}

Lines glb_lines(const std::function<void(std::vector<std::uint8_t>&)>& spoil) {
  std::vector<std::uint8_t> file = sound_triangle().glb();
  spoil(file);
  const TemporaryFolder folder;
  return lines_of(validate_gltf(folder.write("model.glb", file)), Severity::warning);
}

void put(std::vector<std::uint8_t>& file, std::size_t offset, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i) file.at(offset + i) = static_cast<std::uint8_t>(value >> (8 * i));
}

/// A GLB of chunks without content.
std::vector<std::uint8_t> empty_chunks(const std::vector<std::uint32_t>& types) {
  std::vector<std::uint8_t> file(12 + 8 * types.size());
  put(file, 0, 0x46546c67);
  put(file, 4, 2);
  put(file, 8, static_cast<std::uint32_t>(file.size()));
  for (std::size_t i = 0; i < types.size(); ++i) put(file, 16 + 8 * i, types[i]);
  return file;
}

TEST(ValidateGlb, AnEmptyJsonChunkIsReadIfSomethingFollows) {
  constexpr std::uint32_t kJson = 0x4e4f534a, kBinary = 0x004e4942;
  const auto lines = [](const std::vector<std::uint32_t>& types) {
    const TemporaryFolder folder;
    return lines_of(validate_gltf(folder.write("model.glb", empty_chunks(types))));
  };
  EXPECT_EQ(lines({kJson}), Lines{"GLB_EMPTY_CHUNK @12"});
  EXPECT_EQ(lines({kJson, kJson}), (Lines{"GLB_DUPLICATE_CHUNK @20", "GLB_EMPTY_CHUNK @12",
                                          "GLB_EMPTY_CHUNK @20", "INVALID_JSON "}));
  EXPECT_EQ(lines({kJson, kBinary}),
            (Lines{"GLB_EMPTY_BIN_CHUNK @20", "GLB_EMPTY_CHUNK @12", "INVALID_JSON "}));
}

TEST(ValidateGlb, Containers) {
  using File = std::vector<std::uint8_t>;
  const std::size_t bytes = sound_triangle().glb().size();
  const std::size_t binary = bytes - 44 - 8;  // 36 bytes of positions, 6 of indices, 2 of padding.
  const std::string at_binary = " @" + std::to_string(binary), at_end = " @" + std::to_string(bytes);
  EXPECT_EQ(glb_lines([](File&) {}), Lines{});
  EXPECT_EQ(glb_lines([](File& f) { f.clear(); }), Lines{"GLB_UNEXPECTED_END_OF_HEADER @0"});
  EXPECT_EQ(glb_lines([](File& f) { f[0] = 'G'; }), Lines{"GLB_INVALID_MAGIC @0"});
  EXPECT_EQ(glb_lines([](File& f) { put(f, 4, 1); }), Lines{"GLB_INVALID_VERSION @4"});
  EXPECT_EQ(glb_lines([&](File& f) { f.resize(bytes + 4); }), Lines{"GLB_EXTRA_DATA" + at_end});
  EXPECT_EQ(glb_lines([&](File& f) { f.resize(bytes - 4); }),
            Lines{"GLB_UNEXPECTED_END_OF_CHUNK_DATA @" + std::to_string(bytes - 4)});
  EXPECT_EQ(glb_lines([&](File& f) { f.resize(bytes - 48); }),
            Lines{"GLB_UNEXPECTED_END_OF_CHUNK_HEADER @" + std::to_string(bytes - 48)});
  EXPECT_EQ(glb_lines([&](File& f) { put(f, 8, static_cast<std::uint32_t>(bytes + 8)); }),
            Lines{"GLB_LENGTH_MISMATCH" + at_end});
  EXPECT_EQ(glb_lines([&](File& f) { put(f, binary + 4, 0x4e4f534a); }),
            (Lines{"BUFFER_MISSING_GLB_DATA /buffers/0", "GLB_DUPLICATE_CHUNK" + at_binary}));
  EXPECT_EQ(glb_lines([&](File& f) { put(f, binary + 4, 0x58585858); }),
            (Lines{"BUFFER_MISSING_GLB_DATA /buffers/0", "GLB_UNKNOWN_CHUNK_TYPE" + at_binary}));
  EXPECT_EQ(glb_lines([&](File& f) { put(f, binary, 0xffffffff); }),
            (Lines{"GLB_CHUNK_LENGTH_UNALIGNED" + at_binary, "GLB_CHUNK_TOO_BIG" + at_binary,
                   "GLB_UNEXPECTED_END_OF_CHUNK_DATA" + at_end}));
}

Lines buffer_lines(const std::string& uri, std::size_t bytes = 42) {
  Model model = sound_triangle();
  model.document["buffers"] = {{{"uri", uri}, {"byteLength", bytes}}};
  const TemporaryFolder folder;
  folder.write("short.bin", std::string(10, '\0'));
  return lines_of(validate_gltf(model.write_gltf(folder)), Severity::warning);
}

TEST(ValidateFiles, Buffers) {
  EXPECT_EQ(buffer_lines("absent.bin"), Lines{"IO_ERROR /buffers/0/uri"});
  EXPECT_EQ(buffer_lines("../../etc/passwd"), Lines{"IO_ERROR /buffers/0/uri"});
  EXPECT_EQ(buffer_lines("%2e%2e/%2e%2e/etc/passwd"), Lines{"IO_ERROR /buffers/0/uri"});
  EXPECT_EQ(buffer_lines("."), Lines{"IO_ERROR /buffers/0/uri"});
  EXPECT_EQ(buffer_lines("/dev/zero"), Lines{"NON_RELATIVE_URI /buffers/0/uri"});
  EXPECT_EQ(buffer_lines("https://example.com/a.bin"), Lines{"NON_RELATIVE_URI /buffers/0/uri"});
  EXPECT_EQ(buffer_lines("short.bin"), Lines{"BUFFER_BYTE_LENGTH_MISMATCH /buffers/0"});
  EXPECT_EQ(buffer_lines("data:application/octet-stream;base64,AA=="),
            Lines{"BUFFER_BYTE_LENGTH_MISMATCH /buffers/0"});
  EXPECT_EQ(buffer_lines("data:text/plain;base64,AA=="),
            Lines{"BUFFER_DATA_URI_MIME_TYPE_INVALID /buffers/0/uri"});
  EXPECT_EQ(buffer_lines("data:application/octet-stream;base64,?"), Lines{"INVALID_URI /buffers/0/uri"});
  EXPECT_EQ(buffer_lines("data:application/octet-stream;;base64,AA=="), Lines{"INVALID_URI /buffers/0/uri"});
  EXPECT_EQ(buffer_lines("data:"), Lines{"INVALID_URI /buffers/0/uri"});
}

const std::string kPng = std::string("\x89PNG\r\n\x1a\n", 8) + std::string("\0\0\0\x0dIHDR", 8) +
                         std::string("\0\0\0\x04\0\0\0\x02\x08\x02\0\0\0", 13) + std::string(4, 'c') +
                         std::string("\0\0\0\0IDAT", 8);
const std::string kJpeg = std::string("\xff\xd8\xff\xe0\0\x04??\xff\xc0\0\x0b\x08\0\x02\0\x04\x01???", 21);

Lines image_lines(const std::string& bytes, const json& more = json::object()) {
  Model model = sound_triangle();
  json image = {{"uri", "image"}};
  image.update(more);
  model.document["images"] = json::array({image});
  model.document["textures"] = {{{"source", 0}}};
  const TemporaryFolder folder;
  folder.write("image", bytes);
  Lines lines = lines_of(validate_gltf(model.write_gltf(folder)));
  std::erase(lines, "UNUSED_OBJECT /textures/0");
  return lines;
}

TEST(ValidateFiles, Images) {
  EXPECT_EQ(image_lines(kPng), Lines{});
  EXPECT_EQ(image_lines(kJpeg), Lines{});
  EXPECT_EQ(image_lines(kPng, {{"mimeType", "image/jpeg"}}), Lines{"IMAGE_MIME_TYPE_INVALID /images/0/uri"});
  EXPECT_EQ(image_lines(kPng.substr(0, 30)), Lines{"IMAGE_UNEXPECTED_EOS /images/0"});
  EXPECT_EQ(image_lines(kJpeg.substr(0, 15)), Lines{"IMAGE_UNEXPECTED_EOS /images/0"});
  EXPECT_EQ(image_lines("no picture at all"), Lines{"IMAGE_UNRECOGNIZED_FORMAT /images/0"});
  EXPECT_EQ(image_lines(""), Lines{"IMAGE_UNRECOGNIZED_FORMAT /images/0"});
  std::string odd = kPng;
  odd[19] = 3;
  EXPECT_EQ(image_lines(odd), Lines{"IMAGE_NPOT_DIMENSIONS /images/0"});
  odd[19] = 0;
  EXPECT_EQ(image_lines(odd), Lines{"IMAGE_DATA_INVALID /images/0"});
  const std::string webp = "RIFF????WEBPVP8X" + std::string(8, '\0') + std::string("\x07\0\0\x03\0\0", 6);
  EXPECT_EQ(image_lines(webp), (Lines{"IMAGE_NON_ENABLED_MIME_TYPE /images/0",
                                      "TEXTURE_INVALID_IMAGE_MIME_TYPE /textures/0/source"}));
}

// What has no error is drawn, too, where that is possible.

TEST(WithoutErrors, IndicesWithoutAViewAreZeros) {
  Model model = sound_triangle();
  primitive(model)["indices"] = model.add_accessor(-1, kU16, "SCALAR", 3);
  EXPECT_EQ(lines_of(validate(model), Severity::error), Lines{});
  const Scene scene = model.import();
  ASSERT_EQ(scene.meshes.at(0).primitives.size(), 1u);
  EXPECT_EQ(values(scene.meshes[0].primitives[0].indices), (std::vector<std::uint32_t>{0, 0, 0}));
  EXPECT_EQ(scene.meshes[0].primitives[0].vertex_count, 3u);
}

TEST(WithoutErrors, ABufferThatNothingUsesMayBeAnywhere) {
  Model model = sound_triangle();
  const TemporaryFolder folder;
  json complete = json::parse(std::ifstream(model.write_gltf(folder)));
  complete["buffers"].push_back({{"uri", "https://example.com/a.bin"}, {"byteLength", 4}});
  const std::filesystem::path path = folder.write("model.gltf", complete.dump());
  EXPECT_EQ(lines_of(validate_gltf(path), Severity::warning), Lines{"NON_RELATIVE_URI /buffers/1/uri"});
  const Scene scene = import_gltf(path);
  EXPECT_EQ(scene.meshes.at(0).primitives.size(), 1u);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_CONTAINS(scene.warnings[0], "nothing uses it");
  complete["bufferViews"][0]["buffer"] = 1;
  folder.write("model.gltf", complete.dump());
  EXPECT_CONTAINS(input_error([&] { import_gltf(path); }), "only relative paths");
}

TEST(ValidateFiles, AFileThatCannotBeReadIsAnInputError) {
  EXPECT_CONTAINS(input_error([] { validate_gltf("/nowhere/model.gltf"); }),
                  "/nowhere/model.gltf: no such file");
}

TEST(ValidateFiles, InfoCountsWhatIsThere) {
  const ValidationReport report = validate(sound_triangle());
  ASSERT_TRUE(report.info);
  EXPECT_EQ(report.info->version, "2.0");
  EXPECT_EQ(report.info->draw_calls, 1u);
  EXPECT_EQ(report.info->vertices, 3u);
  EXPECT_EQ(report.info->triangles, 1u);
  EXPECT_TRUE(report.info->has_default_scene);
  EXPECT_FALSE(report.info->has_skins);
}

}  // namespace
}  // namespace barrido::scene::test
