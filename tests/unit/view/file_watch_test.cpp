// Changes on disk are told, those of other files are not.
#include "viewer/view/file_watch.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <future>

namespace barrido::view {
namespace {

constexpr std::chrono::seconds kDeadline{30};

/// Writes `name` in a fresh folder while `watched` is watched. @return whether that was told, given that a
/// write to `watched` itself afterwards is told in any case.
int calls_after(const std::string& watched, const std::vector<std::string>& written) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "barrido_file_watch_test";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  std::ofstream(folder / watched) << "old";
  int calls = 0;
  std::promise<void> told;
  {
    const FileWatch watch((folder / watched).string(), [&] {
      if (++calls == 1) told.set_value();
    });
    for (const std::string& name : written) std::ofstream(folder / name) << "new";
    EXPECT_EQ(told.get_future().wait_for(kDeadline), std::future_status::ready);
  }
  std::filesystem::remove_all(folder);
  return calls;
}

TEST(FileWatch, TellsOfAWrite) { EXPECT_GE(calls_after("model.glb", {"model.glb"}), 1); }

TEST(FileWatch, TellsOfPicturesBesideAGltf) { EXPECT_GE(calls_after("model.gltf", {"texture.png"}), 1); }

TEST(FileWatch, EndsWithoutAnyChange) {
  const FileWatch watch("no such folder/model.glb", [] {});
  const FileWatch other("model.glb", [] {});
}

TEST(FileWatch, TellsOfAReplacement) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "barrido_file_watch_test2";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  std::promise<void> told;
  {
    bool once = false;
    const FileWatch watch((folder / "model.glb").string(), [&] {
      if (!once) told.set_value();
      once = true;
    });
    std::ofstream(folder / "part") << "new";
    std::filesystem::rename(folder / "part", folder / "model.glb");
    EXPECT_EQ(told.get_future().wait_for(kDeadline), std::future_status::ready);
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace barrido::view
