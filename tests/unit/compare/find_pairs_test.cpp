// Pairs of files and of folders.
#include "viewer/compare/find_pairs.h"

#include <gtest/gtest.h>

#include "tests/unit/compare/pictures.h"

namespace barrido::compare::test {
namespace {

namespace fs = std::filesystem;

class FindPairs : public testing::Test {
 protected:
  void touch(const std::string& name) {
    fs::create_directories((folder_ / name).parent_path());
    write_text(folder_ / name, "x");
  }
  std::string message(const std::string& a, const std::string& b) {
    return scene::test::message_of([&] { find_pairs(folder_ / a, folder_ / b); });
  }
  TemporaryFolder folder_;
};

TEST_F(FindPairs, TwoFilesAreOnePairWhateverTheyAreCalled) {
  touch("a.png");
  touch("b.tif");
  const auto pairs = find_pairs(folder_ / "a.png", folder_ / "b.tif");
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].name, "b.tif");
  EXPECT_EQ(pairs[0].expected, folder_ / "a.png");
  EXPECT_EQ(pairs[0].actual, folder_ / "b.tif");
}

TEST_F(FindPairs, FoldersAreMatchedByRelativeName) {
  for (const char* name : {"a/z.png", "a/sub/deep/1.EXR", "a/only.jpg", "b/z.png", "b/sub/deep/1.EXR",
                           "b/sub/new.hdr", "b/z.jpg"}) {
    touch(name);
  }
  // What is no picture by its name, or hidden, is none of our business.
  for (const char* name : {"a/notes.txt", "b/z.png.bak", "b/.z.png", "b/.cache/z.png", "b/README"})
    touch(name);
  const auto pairs = find_pairs(folder_ / "a", folder_ / "b");
  std::vector<std::string> names;
  for (const Pair& pair : pairs) {
    names.push_back(pair.name + (pair.expected.empty() ? " new" : pair.actual.empty() ? " missing" : ""));
  }
  EXPECT_EQ(names, (std::vector<std::string>{"only.jpg missing", "sub/deep/1.EXR", "sub/new.hdr new",
                                             "z.jpg new", "z.png"}));
  EXPECT_EQ(pairs[2].target, folder_ / "a/sub/new.hdr");
}

TEST_F(FindPairs, LinksToFoldersAreNotFollowed) {
  touch("a/x.png");
  touch("b/x.png");
  fs::create_directory_symlink(folder_ / "a", folder_ / "a/loop");
  EXPECT_EQ(find_pairs(folder_ / "a", folder_ / "b").size(), 1u);
}

TEST_F(FindPairs, WhatCannotBeComparedIsNamed) {
  touch("a/x.png");
  touch("file.png");
  fs::create_directories(folder_ / "empty");
  fs::create_directories(folder_ / "void");
  EXPECT_EQ(message("a", "file.png"), (folder_ / "a").string() +
                                          ": is a folder and cannot be compared with the file " +
                                          (folder_ / "file.png").string());
  EXPECT_EQ(message("file.png", "a"), message("a", "file.png"));
  EXPECT_EQ(message("none", "a"),
            (folder_ / "none").string() + ": cannot be read: No such file or directory");
  EXPECT_EQ(message("a", "none"),
            (folder_ / "none").string() + ": cannot be read: No such file or directory");
  EXPECT_EQ(
      message("empty", "void"),
      (folder_ / "empty").string() + ": holds no pictures, and neither does " + (folder_ / "void").string());
  EXPECT_EQ(find_pairs(folder_ / "a", folder_ / "empty").size(), 1u);
}

TEST_F(FindPairs, WhatIsToBeBlessedNeedNotBeThere) {
  touch("b/x.png");
  const auto folders = find_pairs(folder_ / "none", folder_ / "b", MissingExpected::is_empty);
  ASSERT_EQ(folders.size(), 1u);
  EXPECT_TRUE(folders[0].expected.empty());
  EXPECT_EQ(folders[0].target, folder_ / "none/x.png");
  const auto files = find_pairs(folder_ / "n.png", folder_ / "b/x.png", MissingExpected::is_empty);
  EXPECT_TRUE(files[0].expected.empty());
  EXPECT_EQ(files[0].target, folder_ / "n.png");
}

}  // namespace
}  // namespace barrido::compare::test
