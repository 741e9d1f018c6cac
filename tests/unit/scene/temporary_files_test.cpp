// Files that must not outlive their writing.
#include "pipeline/files/temporary_files.h"

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <thread>

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

/// Runs `work` and then ends, in a process of its own: after remove_temporary_files() nothing more is
/// created.
template <typename Work>
void in_a_process(Work work) {
  const auto run = [&] {
    work();
    std::_Exit(0);
  };
  EXPECT_EXIT(run(), testing::ExitedWithCode(0), "");
}

TEST(TemporaryPath, AllAreRemovedAtTheEnd) {
  const TemporaryFolder folder;
  const fs::path below = folder.path() / "below";
  fs::create_directory(below);
  const fs::path file = folder.write("below/file", "x"), other = folder.write("other", "x"),
                 kept = folder.write("kept", "x");
  in_a_process([&] {
    const TemporaryPath made_folder(below);
    const TemporaryPath one(file), two(other);
    TemporaryPath three(kept);
    three.keep();
    remove_temporary_files();
    // Without what the destructors do.
    std::_Exit(fs::exists(other) || fs::exists(below) ? 1 : 0);
  });
  EXPECT_TRUE(fs::exists(kept));
}

TEST(TemporaryPath, FilesBeingWrittenAreKnown) {
  const TemporaryFolder folder;
  const fs::path target = folder.write("target", "old");
  in_a_process([&] {
    try {
      write_atomically(target, [&](const fs::path& part) {
        std::ofstream(part) << "half";
        if (!fs::exists(part)) std::_Exit(1);
        remove_temporary_files();
        if (fs::exists(part)) std::_Exit(2);
      });
      std::_Exit(3);
    } catch (const InputError&) {
    }
  });
  std::ifstream file(target);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "old");
}

/// The end waits for a file that is being created, and removes it; no other is created from then on.
TEST(TemporaryPath, NoneIsCreatedBesideTheEnd) {
  const TemporaryFolder folder;
  in_a_process([&] {
    std::atomic<bool> creating{false};
    std::thread slow([&] {
      const TemporaryPath path([&] {
        creating = true;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        return folder.write("slow", "x");
      });
      std::this_thread::sleep_for(std::chrono::seconds(60));
    });
    while (!creating) std::this_thread::yield();
    remove_temporary_files();
    std::thread late([&] { const TemporaryPath path([&] { return folder.write("late", "x"); }); });
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    std::_Exit(0);
  });
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

/// A signal is kept waiting while a file comes into being: its handler would wait for the thread that it
/// stops.
TEST(TemporaryPath, NoSignalComesDuringCreation) {
  const TemporaryFolder folder;
  in_a_process([&] {
    std::signal(SIGTERM, [](int) {
      remove_temporary_files();
      std::_Exit(0);
    });
    const TemporaryPath path([&] {
      ::raise(SIGTERM);
      return folder.write("file", "x");
    });
    std::_Exit(1);
  });
  EXPECT_TRUE(fs::is_empty(folder.path()));
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
