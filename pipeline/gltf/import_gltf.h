// glTF 2.0 and GLB into a Scene. The only code that sees tinygltf.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "pipeline/files/budget.h"
#include "pipeline/files/error.h"
#include "pipeline/scene/scene.h"

namespace barrido::scene {

/// What materials use images for; a union of these chooses which ones are worth decoding.
enum ImageRole : unsigned {
  kBaseColorImage = 1,
  kMetallicRoughnessImage = 2,
  kNormalImage = 4,
  kOcclusionImage = 8,
  kEmissiveImage = 16,
  kLayerImage = 32,  ///< Of extensions that add to the material
  kAllImages = 63
};

struct ImportOptions {
  bool load_images = true;
  /// The model is read from standard input to its end, and may name no files; its path is for messages alone.
  bool from_standard_input = false;
  unsigned image_roles = kAllImages;  ///< Images used in no other role stay empty (width 0).
  std::uint64_t max_file_bytes = std::uint64_t{1} << 31;  ///< Of any one file read.
  std::uint64_t max_vertices = 100'000'000;
  std::uint64_t max_image_pixels = std::uint64_t{1} << 28;  ///< Of any one image.
  int max_json_depth = 64;
  std::shared_ptr<Budget> budget;  ///< Of memory and time. Null: one with the default limits.
};

/// Reads a .gltf or .glb file with all it refers to, which must lie in the file's own folder or below.
/// @throws InputError when the file cannot be drawn safely; optional things that are not supported become
/// warnings.
Scene import_gltf(const std::filesystem::path& path, const ImportOptions& options = {});

}  // namespace barrido::scene
