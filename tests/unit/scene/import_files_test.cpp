// Which files a model may name, and how their bytes are read.
#include <filesystem>

#include <sys/stat.h>

#include "import_support.h"
#include "pipeline/files/bytes.h"

namespace barrido::scene::test {
namespace {

namespace fs = std::filesystem;
class ResolveUri : public testing::Test {
 protected:
  ResolveUri() {
    fs::create_directories(model_folder() / "textures");
    folder.write("model/textures/a b+c.png", std::string("x"));
    folder.write("secret.bin", std::string("x"));
  }
  fs::path model_folder() const { return folder.path() / "model"; }
  std::string problem(const std::string& uri) const { return gltf::resolve_uri(model_folder(), uri).problem; }

  TemporaryFolder folder;
};

TEST_F(ResolveUri, PercentSignsAreDecodedAndPlusStays) {
  const gltf::ResolvedPath resolved = gltf::resolve_uri(model_folder(), "textures/a%20b+c.png");
  EXPECT_EQ(resolved.problem, "");
  EXPECT_EQ(resolved.path, fs::canonical(model_folder() / "textures/a b+c.png"));
}

TEST_F(ResolveUri, PathThatComesBackIsFine) { EXPECT_EQ(problem("textures/../textures/./a%20b+c.png"), ""); }

TEST_F(ResolveUri, ParentFolderIsRefusedWhetherTheFileIsThereOrNot) {
  EXPECT_CONTAINS(problem("../secret.bin"), "leaves the model's folder");
  EXPECT_CONTAINS(problem("../nothing.bin"), "leaves the model's folder");
  EXPECT_CONTAINS(problem("textures/../../secret.bin"), "leaves the model's folder");
  EXPECT_CONTAINS(problem("%2e%2e%2fsecret.bin"), "leaves the model's folder");
  EXPECT_CONTAINS(problem("..%2Fsecret.bin"), "leaves the model's folder");
}

TEST_F(ResolveUri, AbsolutePathsAndSchemesAreRefused) {
  EXPECT_CONTAINS(problem((folder.path() / "secret.bin").string()), "absolute");
  EXPECT_CONTAINS(problem("%2Fetc/passwd"), "absolute");
  EXPECT_CONTAINS(problem("file:///etc/passwd"), "only relative paths");
  EXPECT_CONTAINS(problem("http://example.com/a.bin"), "only relative paths");
}

TEST_F(ResolveUri, SymbolicLinksAreFollowedBeforeTheFolderIsChecked) {
  fs::create_symlink(folder.path() / "secret.bin", model_folder() / "out.bin");
  fs::create_symlink(model_folder() / "textures", model_folder() / "in");
  fs::create_symlink(folder.path(), model_folder() / "up");
  EXPECT_CONTAINS(problem("out.bin"), "leaves the model's folder");
  EXPECT_CONTAINS(problem("up/secret.bin"), "leaves the model's folder");
  EXPECT_EQ(problem("in/a b+c.png"), "");
}

TEST_F(ResolveUri, FolderWithTheSameBeginningIsNotTheModels) {
  fs::create_directories(folder.path() / "model2");
  folder.write("model2/a.bin", std::string("x"));
  fs::create_symlink(folder.path() / "model2", model_folder() / "link");
  EXPECT_CONTAINS(problem("link/a.bin"), "leaves the model's folder");
}

TEST_F(ResolveUri, WhatIsNotThereOrNoNameIsRefused) {
  EXPECT_EQ(problem("nothing.bin"), "no such file");
  EXPECT_CONTAINS(problem(""), "empty");
  EXPECT_CONTAINS(problem("a%00.bin"), "zero byte");
  EXPECT_NE(problem(std::string(70000, 'x')), "");
}

TEST(ReadRegularFile, FoldersDevicesAndPipesAreRefusedWithoutWaiting) {
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
  EXPECT_CONTAINS(gltf::read_regular_file(folder.path() / "pipe", 1000).problem, "not a regular file");
  EXPECT_CONTAINS(gltf::read_regular_file("/dev/zero", 1000).problem, "not a regular file");
  EXPECT_CONTAINS(gltf::read_regular_file(folder.path(), 1000).problem, "is a folder");
  EXPECT_EQ(gltf::read_regular_file(folder.path() / "nothing", 1000).problem, "no such file");
}

TEST(ReadRegularFile, SizeLimitIsExact) {
  const TemporaryFolder folder;
  const fs::path path = folder.write("a", std::string("12345"));
  EXPECT_EQ(gltf::read_regular_file(path, 5).problem, "");
  EXPECT_CONTAINS(gltf::read_regular_file(path, 4).problem, "has 5 bytes; at most 4");
}

std::string decoded(const std::string& uri) {
  const gltf::Content content = gltf::decode_data_uri(uri);
  EXPECT_EQ(content.problem, "") << uri;
  return {content.block.bytes().begin(), content.block.bytes().end()};
}

TEST(DataUri, Base64OfEveryLength) {
  EXPECT_EQ(decoded("data:application/octet-stream;base64,"), "");
  EXPECT_EQ(decoded("data:;base64,Zg=="), "f");
  EXPECT_EQ(decoded("data:a/b;charset=utf-8;base64,Zm8="), "fo");
  EXPECT_EQ(decoded("data:a/b;base64,Zm9v"), "foo");
  EXPECT_EQ(decoded("data:a/b;base64,Zm9vYg"), "foob");
  EXPECT_EQ(decoded("data:a/b;base64,+/+/"), "\xfb\xff\xbf");
}

TEST(DataUri, PercentEncoding) { EXPECT_EQ(decoded("data:text/plain,a%20b"), "a b"); }

TEST(DataUri, DamageIsAProblem) {
  EXPECT_NE(gltf::decode_data_uri("data:a/b;base64,Zm9v!A==").problem, "");
  EXPECT_NE(gltf::decode_data_uri("data:a/b;base64,Z").problem, "");
  EXPECT_NE(gltf::decode_data_uri("data:a/b;base64,Zm=v").problem, "");
  EXPECT_NE(gltf::decode_data_uri("data:a/b;base64").problem, "");
}

TEST(DataUri, SchemeIsRecognisedInAnyCase) {
  EXPECT_TRUE(gltf::is_data_uri("DaTa:x"));
  EXPECT_FALSE(gltf::is_data_uri("dat"));
  EXPECT_FALSE(gltf::is_data_uri("data.bin"));
}

TEST(ImportFiles, BufferErrorsNameTheBufferAndItsFile) {
  Model model = triangle();
  model.document["buffers"] = {{{"uri", "other.bin"}, {"byteLength", 42}}};
  EXPECT_CONTAINS(import_error(model), "model.gltf: buffers[0] (other.bin): no such file");
  model.document["buffers"] = {{{"uri", "data:;base64,AAAA"}, {"byteLength", 42}}};
  EXPECT_CONTAINS(import_error(model), "byteLength is 42, but there are only 3 bytes");
  model.document["buffers"] = {{{"byteLength", 42}}};
  EXPECT_CONTAINS(import_error(model), "POSITION: buffers[0] has neither a uri nor a binary chunk");
}

TEST(ImportFiles, BufferMayBeLargerThanItSays) {
  Model model = triangle();
  const TemporaryFolder folder;
  const fs::path path = model.write_gltf(folder);
  std::ofstream(folder.path() / "model.bin", std::ios::app | std::ios::binary) << "more";
  EXPECT_NO_THROW(import_gltf(path));
}

TEST(ImportFiles, RelativeModelPathFindsItsBuffer) {
  const TemporaryFolder folder;
  triangle().write_gltf(folder);
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  EXPECT_NO_THROW(import_gltf("model.gltf"));
  fs::current_path(before);
}

TEST(ImportFiles, MessagesStayOnOneLine) {
  Model model = triangle();
  model.document["buffers"] = {
      {{"uri", std::string("a\nb\x1b[31m") + std::string(500, 'x')}, {"byteLength", 42}}};
  const std::string message = import_error(model);
  EXPECT_CONTAINS(message, "(a?b?[31mxxx");
  EXPECT_EQ(message.find('\n'), std::string::npos);
  EXPECT_LT(message.size(), 300u);
}

TEST(ImportFiles, MissingModel) {
  EXPECT_EQ(input_error([] { import_gltf("/nowhere/model.glb"); }), "/nowhere/model.glb: no such file");
}

}  // namespace
}  // namespace barrido::scene::test
