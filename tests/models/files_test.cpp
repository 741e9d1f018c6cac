// The committed files of models/ are what the tool makes from this source.
#include <filesystem>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "models/tool/file.h"
#include "models/tool/png.h"
#include "models/tool/write_models.h"

namespace barrido::models {
namespace {

const std::filesystem::path kCommitted = std::filesystem::path(BARRIDO_SOURCE_DIR) / "models";
const std::filesystem::path kMade = std::filesystem::path(BARRIDO_BINARY_DIR) / "models_made_again";

/// Files below `folder` with this extension, relative to it.
std::set<std::string> files_in(const std::filesystem::path& folder, const std::string& extension) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == extension) {
      names.insert(entry.path().lexically_relative(folder).string());
    }
  }
  return names;
}

TEST(ModelFiles, AreWhatTheToolMakes) {
  std::filesystem::remove_all(kMade);
  write_models({kMade, kCommitted / "textures", 10});

  const std::set<std::string> scenes = files_in(kMade, ".glb");
  EXPECT_EQ(scenes.size(), 13u);
  for (const std::string& name : scenes) {
    EXPECT_TRUE(read_file(kMade / name) == read_file(kCommitted / name))
        << name << " differs; run barrido-models";
  }
  std::set<std::string> committed = files_in(kCommitted, ".glb");
  EXPECT_EQ(committed.erase("suzanne.glb"), 1u);  // the one model from elsewhere
  EXPECT_EQ(scenes, committed);

  // Compressed bytes may differ with another zlib; the pixels may not.
  const std::set<std::string> pictures = files_in(kMade, ".png");
  EXPECT_EQ(pictures, files_in(kCommitted, ".png"));
  for (const std::string& name : pictures) {
    EXPECT_TRUE(read_png(kMade / name).rgb == read_png(kCommitted / name).rgb) << name << " differs";
  }
}

TEST(ModelFiles, UnwritableFolderIsNamed) {
  EXPECT_THROW(write_models({"/proc/barrido", {}, 1}), std::runtime_error);
}

}  // namespace
}  // namespace barrido::models
