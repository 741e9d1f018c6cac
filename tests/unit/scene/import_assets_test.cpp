// Models made elsewhere: every good one is read, every hostile one is refused or read as its manifest says.
#include <algorithm>
#include <set>
#include <sstream>

#include "import_support.h"
#include "pipeline/scene/animate.h"

namespace barrido::scene::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> models_below(const fs::path& folder) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path extension = entry.path().extension();
    if (extension == ".gltf" || extension == ".glb") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// What every later stage may rely on.
void expect_sound(const Scene& scene) {
  ASSERT_LT(static_cast<std::size_t>(scene.default_scene), scene.scenes.size());
  for (const Mesh& mesh : scene.meshes) {
    for (const Primitive& primitive : mesh.primitives) {
      const std::size_t count = primitive.vertex_count;
      EXPECT_EQ(primitive.positions.size(), 3 * count);
      EXPECT_TRUE(primitive.normals.empty() || primitive.normals.size() == 3 * count);
      EXPECT_TRUE(primitive.colors.empty() || primitive.colors.size() == 4 * count);
      EXPECT_TRUE(primitive.joints.empty() || primitive.joints.size() == count);
      for (const FloatArray& texcoords : primitive.texcoords) {
        EXPECT_TRUE(texcoords.empty() || texcoords.size() == 2 * count);
      }
      EXPECT_TRUE(std::all_of(primitive.indices.begin(), primitive.indices.end(),
                              [&](std::uint32_t index) { return index < count; }));
    }
  }
}

/// Poses and deforms everything, so that the sanitizers see each access.
void pose_all(const Scene& scene) {
  for (int animation = kNone; animation < static_cast<int>(scene.animations.size()); ++animation) {
    const Pose pose = pose_at(scene, animation, 0.37);
    for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
      if (scene.nodes[node].mesh == kNone) continue;
      for (const Primitive& primitive :
           scene.meshes[static_cast<std::size_t>(scene.nodes[node].mesh)].primitives) {
        const int index = static_cast<int>(node);
        if (is_deformed(scene, index, primitive)) deform(scene, pose, index, primitive);
      }
    }
  }
}

void expect_all_import(const fs::path& folder, std::size_t count) {
  const std::vector<fs::path> paths = models_below(folder);
  EXPECT_EQ(paths.size(), count);
  for (const fs::path& path : paths) {
    SCOPED_TRACE(path);
    try {
      const Scene scene = import_gltf(path);
      expect_sound(scene);
      pose_all(scene);
    } catch (const InputError& error) {
      ADD_FAILURE() << error.what();
    }
  }
}

TEST(ImportAssets, EverySampleModel) {
  if (!fs::exists(assets_folder() / "models")) GTEST_SKIP() << "needs the test assets in " << assets_folder();
  expect_all_import(assets_folder() / "models", 25);
}

TEST(ImportAssets, EveryPositiveCaseOfTheGenerator) {
  if (!fs::exists(assets_folder() / "generator"))
    GTEST_SKIP() << "needs the test assets in " << assets_folder();
  expect_all_import(assets_folder() / "generator/Positive", 59);
}

TEST(ImportAssets, HostileFilesDoAsTheirManifestSays) {
  const fs::path folder = assets_folder() / "hostile";
  if (!fs::exists(folder)) GTEST_SKIP() << "needs the test assets in " << assets_folder();
  std::ifstream manifest(folder / "MANIFEST.tsv");
  std::string line;
  std::size_t models = 0;
  std::getline(manifest, line);
  while (std::getline(manifest, line)) {
    std::istringstream fields(line);
    std::string name, bytes, verdict;
    std::getline(fields, name, '\t');
    std::getline(fields, bytes, '\t');
    std::getline(fields, verdict, '\t');
    if (!name.ends_with(".gltf") && !name.ends_with(".glb")) continue;
    ++models;
    SCOPED_TRACE(line);
    bool refused = false;
    try {
      const Scene scene = import_gltf(folder / name);
      expect_sound(scene);
      pose_all(scene);
    } catch (const InputError& error) {
      refused = true;
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      EXPECT_CONTAINS(error.what(), name);
    }
    // A model whose only fault is a picture that is damaged or out of reach is drawn without it.
    for (const char* picture : {"87_image", "89_image", "91_image", "92_image"}) {
      if (name.starts_with(picture)) verdict = "SAFE";
    }
    EXPECT_TRUE(verdict == "EITHER" || refused == (verdict == "ERROR"));
  }
  EXPECT_EQ(models, 75u);
  EXPECT_FALSE(fs::exists("pwned"));
}

TEST(ImportAssets, FilesOfTheValidatorNeverCrash) {
  const fs::path folder = assets_folder() / "validator";
  if (!fs::exists(folder)) GTEST_SKIP() << "needs the test assets in " << assets_folder();
  for (const fs::path& path : models_below(folder)) {
    SCOPED_TRACE(path);
    try {
      const Scene scene = import_gltf(path);
      expect_sound(scene);
      pose_all(scene);
    } catch (const InputError& error) {
      EXPECT_CONTAINS(error.what(), path.filename().string());
    }
  }
}

TEST(ImportAssets, WhatTheSampleModelsAreFor) {
  const fs::path folder = assets_folder() / "models";
  if (!fs::exists(folder)) GTEST_SKIP() << "needs the test assets in " << assets_folder();
  EXPECT_TRUE(import_gltf(folder / "UnlitTest/glTF-Binary/UnlitTest.glb").materials.at(0).unlit);
  EXPECT_EQ(import_gltf(folder / "MultipleScenes/glTF/MultipleScenes.gltf").scenes.size(), 2u);
  EXPECT_EQ(import_gltf(folder / "Cameras/glTF/Cameras.gltf").cameras.size(), 2u);
  EXPECT_FALSE(import_gltf(folder / "LightsPunctualLamp/glTF/LightsPunctualLamp.gltf").lights.empty());
  EXPECT_EQ(import_gltf(folder / "RiggedFigure/glTF-Binary/RiggedFigure.glb").skins.size(), 1u);
  const Scene boxes = import_gltf(folder / "SimpleInstancing/glTF-Binary/SimpleInstancing.glb");
  EXPECT_EQ(boxes.warnings, std::vector<std::string>{});
  EXPECT_EQ(std::count_if(boxes.nodes.begin(), boxes.nodes.end(),
                          [](const Node& node) { return node.mesh != kNone; }),
            125);
  std::set<pipeline::PrimitiveMode> modes;
  for (const Mesh& mesh : import_gltf(folder / "MeshPrimitiveModes/glTF/MeshPrimitiveModes.gltf").meshes) {
    modes.insert(mesh.primitives.at(0).mode);
  }
  EXPECT_EQ(modes.size(), 7u);
}

}  // namespace
}  // namespace barrido::scene::test
