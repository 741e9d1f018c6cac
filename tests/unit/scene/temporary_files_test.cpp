// Files that must not outlive their writing.
#include "pipeline/files/temporary_files.h"

#include <fstream>

#include <gtest/gtest.h>

#include "pipeline/files/write_file.h"
#include "tests/unit/scene/import_support.h"

namespace barrido::scene::test {
namespace {

namespace fs = std::filesystem;

TEST(TemporaryPath, IsRemovedUnlessKept) {
  const TemporaryFolder folder;
  const fs::path gone = folder.write("gone", "x"), stays = folder.write("stays", "x");
  {
    const TemporaryPath one(gone);
    TemporaryPath other(stays);
    other.keep();
  }
  EXPECT_FALSE(fs::exists(gone));
  EXPECT_TRUE(fs::exists(stays));
}

TEST(TemporaryPath, AllAreRemovedAtTheEnd) {
  const TemporaryFolder folder;
  const fs::path below = folder.path() / "below";
  fs::create_directory(below);
  const TemporaryPath made_folder(below);
  const fs::path file = folder.write("below/file", "x"), other = folder.write("other", "x"),
                 kept = folder.write("kept", "x");
  const TemporaryPath one(file), two(other);
  TemporaryPath three(kept);
  three.keep();
  remove_temporary_files();
  EXPECT_FALSE(fs::exists(other));
  EXPECT_FALSE(fs::exists(below));
  EXPECT_TRUE(fs::exists(kept));
}

TEST(TemporaryPath, FilesBeingWrittenAreKnown) {
  const TemporaryFolder folder;
  const fs::path target = folder.write("target", "old");
  EXPECT_THROW(write_atomically(target,
                                [&](const fs::path& part) {
                                  std::ofstream(part) << "half";
                                  EXPECT_TRUE(fs::exists(part));
                                  remove_temporary_files();
                                  EXPECT_FALSE(fs::exists(part));
                                }),
               InputError);
  std::ifstream file(target);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "old");
}

TEST(TemporaryPath, MoreThanAreRemembered) {
  const TemporaryFolder folder;
  std::vector<std::unique_ptr<TemporaryPath>> many;
  for (int i = 0; i < 100; ++i) {
    many.push_back(std::make_unique<TemporaryPath>(folder.write(std::to_string(i), "x")));
  }
  many.clear();
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace
}  // namespace barrido::scene::test
