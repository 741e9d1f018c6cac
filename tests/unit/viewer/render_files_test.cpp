// What goes wrong with files: one line that says so, exit status 2, and nothing half-written.
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/unit/viewer/program.h"
#include "tests/unit/viewer/tiny_models.h"

namespace barrido::test {
namespace {

using Words = std::vector<std::string>;

class RenderFiles : public ::testing::Test {
 protected:
  RenderFiles() { write_square(folder_.path() / "square.gltf"); }

  Outcome render(Words words, std::uint64_t memory_bytes = 0) const {
    words.insert(words.begin(), "render");
    return run(words, {folder_.path(), "", false, memory_bytes});
  }

  /// Exit status 2, one line that begins so, and no file but those that were there.
  void expect_error(const Words& words, const std::string& beginning,
                    const Words& left_over = {"square.gltf"}) {
    const Outcome outcome = render(words);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.error.substr(0, beginning.size() + 9), "barrido: " + beginning);
    EXPECT_EQ(lines_of(outcome.error).size(), 1u) << outcome.error;
    EXPECT_EQ(folder_.files(), left_over);
  }

  TemporaryFolder folder_;
};

TEST_F(RenderFiles, AMissingFile) { expect_error({"missing.glb", "-o", "a.png"}, "missing.glb: "); }

TEST_F(RenderFiles, AFolderInPlaceOfAFile) {
  std::filesystem::create_directory(folder_.path() / "folder.glb");
  expect_error({"folder.glb", "-o", "a.png"}, "folder.glb: ");
}

TEST_F(RenderFiles, ABrokenFile) {
  write_text(folder_.path() / "broken.gltf", "{\"asset\": ");
  expect_error({"broken.gltf", "-o", "a.png"}, "broken.gltf: ", {"broken.gltf", "square.gltf"});
}

TEST_F(RenderFiles, AnAnimationIsOneFileForAllMoments) {
  const Words turn{"square.gltf", "--turntable", "3", "--resolution", "32,24"};
  for (const char* name : {"turn.gif", "turn.webp"}) {
    Words words = turn;
    words.insert(words.end(), {"-o", name, "--fps", "10"});
    const Outcome outcome = render(words);
    if (outcome.error.find("needs the module") != std::string::npos) GTEST_SKIP() << outcome.error;
    EXPECT_EQ(outcome.status, 0) << outcome.error;
  }
  EXPECT_EQ(folder_.files(), (Words{"square.gltf", "turn.gif", "turn.webp"}));
  EXPECT_EQ(read_text(folder_.path() / "turn.gif").substr(0, 6), "GIF89a");
  EXPECT_EQ(read_text(folder_.path() / "turn.webp").substr(8, 8), "WEBPVP8X");
  EXPECT_EQ(read_text(folder_.path() / "turn.webp").substr(30, 4), "ANIM");
  // Several of them, each whole.
  EXPECT_EQ(render({"square.gltf", "--turntable", "2", "--resolution", "32,24", "--shading", "flat,phong",
                    "-o", "{shading}.gif"})
                .status,
            0);
  EXPECT_EQ(folder_.files(), (Words{"flat.gif", "phong.gif", "square.gltf", "turn.gif", "turn.webp"}));
}

TEST_F(RenderFiles, AnAnimationThatCannotBeFinishedLeavesNothing) {
  // More pixels a side than either format holds; the folder that was made stays.
  const Outcome large =
      render({"square.gltf", "--turntable", "2", "--resolution", "16384,8", "-o", "turn.webp"});
  EXPECT_EQ(large.status, 2);
  EXPECT_EQ(lines_of(large.error).back(), "barrido: turn.webp: an animation has at most 16383 pixels a side");
  EXPECT_EQ(folder_.files(), Words{"square.gltf"});
  expect_error({"square.gltf", "--turntable", "2", "--shading", "all", "-o", "turn.gif"},
               "--output: 'turn.gif': the frames need different names: add {shading}");
  expect_error({"square.gltf", "square.gltf", "--turntable", "2", "-o", "{model}.gif"},
               "square.gif: two frames would have this name");
}

TEST_F(RenderFiles, ABrokenFileAmongGoodOnesStopsOnlyItself) {
  write_text(folder_.path() / "broken.gltf", "no");
  const Outcome outcome = render({"missing.glb", "broken.gltf", "square.gltf", "-o", "{model}.png"});
  EXPECT_EQ(outcome.status, 2);
  ASSERT_EQ(lines_of(outcome.error).size(), 2u) << outcome.error;
  EXPECT_EQ(lines_of(outcome.error)[0].substr(0, 22), "barrido: missing.glb: ");
  EXPECT_EQ(lines_of(outcome.error)[1].substr(0, 22), "barrido: broken.gltf: ");
  EXPECT_EQ(folder_.files(), (Words{"broken.gltf", "square.gltf", "square.png"}));
}

TEST_F(RenderFiles, ASheetIsWholeOrNotAtAll) {
  expect_error({"square.gltf", "missing.glb", "-o", "a.png", "--sheet"}, "missing.glb: ");
}

TEST_F(RenderFiles, AnEnvironmentThatCannotBeRead) {
  expect_error({"square.gltf", "-o", "a.png", "--environment", "sky.png"}, "sky.png: ");
}

TEST_F(RenderFiles, AnOutputThatCannotBeWritten) {
  std::filesystem::create_directory(folder_.path() / "a.png");
  expect_error({"square.gltf", "-o", "a.png", "--resolution", "8,8"}, "a.png: ");
  expect_error({"square.gltf", "-o", "square.gltf/a.png", "--resolution", "8,8"},
               "square.gltf/a.png: cannot make its folder: ");
  expect_error({"square.gltf", "-o", "/proc/a.png", "--resolution", "8,8"}, "/proc/a.png: ");
}

TEST_F(RenderFiles, ReadOnlyFolders) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  std::filesystem::create_directory(folder_.path() / "locked");
  chmod((folder_.path() / "locked").c_str(), 0500);
  expect_error({"square.gltf", "-o", "locked/a.png", "--resolution", "8,8"}, "locked/a.png: ");
}

TEST_F(RenderFiles, MissingFoldersAreMade) {
  EXPECT_EQ(render({"square.gltf", "-o", "x/y/a.png", "--resolution", "8,8"}).status, 0);
  EXPECT_EQ(folder_.files(), (Words{"square.gltf", "x/y/a.png"}));
}

TEST_F(RenderFiles, NamesAreCheckedBeforeAnythingIsLoaded) {
  expect_error({"missing.glb", "-o", "a.png", "--shading", "all"}, "--output: 'a.png': the frames need");
  expect_error({"missing.glb", "x/missing.glb", "-o", "{model}.png"}, "missing.png: two frames would");
  expect_error({"missing.glb", "-o", "a.abc"}, "--output: 'a.abc': no picture format");
}

TEST_F(RenderFiles, WhatTheFileLacks) {
  expect_error({"square.gltf", "-o", "a.png", "--camera-index", "0"}, "square.gltf: --camera-index 0: ");
  expect_error({"square.gltf", "-o", "a.png", "--time", "1"}, "square.gltf: --time: ");
  expect_error({"square.gltf", "-o", "a.png", "--scene", "7"}, "square.gltf: ");
}

TEST_F(RenderFiles, NamesWithLineFeedsStayOnOneLine) {
  expect_error({"a\nb.glb", "-o", "a.png"}, "a\\nb.glb: ");
}

TEST_F(RenderFiles, MemoryThatIsNotThereIsAnError) {
#ifdef BARRIDO_SANITIZED
  GTEST_SKIP() << "sanitizers need the address space";
#endif
  const Outcome outcome =
      render({"square.gltf", "-o", "a.png", "--resolution", "16384,16384", "--threads", "1"}, 400u << 20);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(lines_of(outcome.error).size(), 1u) << outcome.error;
  EXPECT_EQ(outcome.error.find("barrido: square.gltf: square/phong: not enough memory"), 0u) << outcome.error;
  EXPECT_EQ(folder_.files(), Words{"square.gltf"});
}

/// Of the hostile files, those whose only fault is a picture: the manifest would have them refused, but a
/// model whose picture is missing, damaged or out of reach is drawn without it.
bool lacks_only_a_picture(const std::string& file) {
  return file.starts_with("87_image") || file.starts_with("89_image") || file.starts_with("91_image") ||
         file.starts_with("92_image");
}

/// The hostile files: a clear message or a frame, within the limits.
TEST(HostileFiles, AreRefusedInOneLineOrDrawn) {
  const std::filesystem::path hostile =
      std::filesystem::path(BARRIDO_SOURCE_DIR) / "../shared/assets/hostile";
  std::ifstream manifest(hostile / "MANIFEST.tsv");
  if (!manifest) GTEST_SKIP() << hostile << " is not here";
  const TemporaryFolder folder;
  std::string line;
  int count = 0;
  while (std::getline(manifest, line)) {
    std::istringstream fields(line);
    std::string file, bytes, expected;
    std::getline(fields, file, '\t');
    std::getline(fields, bytes, '\t');
    std::getline(fields, expected, '\t');
    if (lacks_only_a_picture(file)) expected = "SAFE";
    if (expected != "ERROR" && expected != "SAFE" && expected != "EITHER") continue;
    ++count;
    const std::string out = (folder.path() / "a.png").string();
    std::filesystem::remove(out);
    const Outcome outcome = run({"render", (hostile / file).string(), "-o", out, "--resolution", "64,48",
                                 "--quiet", "--threads", "1"},
                                {folder.path(), "", false, 0});
    if (expected == "ERROR") {
      EXPECT_EQ(outcome.status, 2) << file;
    }
    if (expected == "SAFE") {
      EXPECT_EQ(outcome.status, 0) << file << ": " << outcome.error;
    }
    EXPECT_TRUE(outcome.status == 0 || outcome.status == 2) << file << ": " << outcome.status;
    EXPECT_EQ(lines_of(outcome.error).size(), outcome.status == 0 ? 0u : 1u) << file << ": " << outcome.error;
    EXPECT_EQ(std::filesystem::exists(out), outcome.status == 0) << file;
  }
  EXPECT_GT(count, 50);
}

}  // namespace
}  // namespace barrido::test
