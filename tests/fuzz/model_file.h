// A folder with one model file in it, for importers, which take paths; and limits that keep a run short.
#pragma once

#include <filesystem>
#include <string>

#include "pipeline/gltf/import_gltf.h"
#include "targets.h"

namespace barrido::fuzz {

/// Removed with all it holds at the end.
class ModelFile {
 public:
  ModelFile();
  ~ModelFile();
  ModelFile(const ModelFile&) = delete;
  ModelFile& operator=(const ModelFile&) = delete;

  /// Replaces what was there.
  std::filesystem::path write(const std::string& name, Bytes bytes) const;

 private:
  std::filesystem::path folder_;
};

/// 2000 vertices, pictures of 65,536 pixels, files of 4 MB.
scene::ImportOptions small_limits();

}  // namespace barrido::fuzz
