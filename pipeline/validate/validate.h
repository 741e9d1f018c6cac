// Whether a glTF file is what glTF 2.0 says a file must be, in the terms of the Khronos glTF validator: every
// fault with its code, place and severity, where the importer (import_gltf.h) stops at the first that makes
// drawing unsafe and forgives most others. Draws nothing, and stays within limits on hostile files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/validate/issues.h"

namespace barrido::scene {

struct ValidateOptions {
  std::uint64_t max_file_bytes = std::uint64_t{1} << 31;  ///< Of the file, and of all it refers to.
  int max_json_depth = 64;
  std::size_t max_json_values = 4'000'000;  ///< Numbers, texts, arrays and objects together.
  std::size_t max_issues = 10'000;          ///< Findings that are kept; others are only counted.
  std::uint64_t max_numbers = 300'000'000;  ///< Numbers in accessors that are looked at, again for every use.
};

/// What a file holds, as the reference validator's reports tell it.
struct ValidationInfo {
  std::string version, min_version, generator;
  std::vector<std::string> extensions_used, extensions_required;
  std::size_t animations = 0, materials = 0, draw_calls = 0;
  std::uint64_t vertices = 0, triangles = 0;
  std::size_t max_uvs = 0, max_influences = 0, max_attributes = 0;
  bool has_morph_targets = false, has_skins = false, has_textures = false, has_default_scene = false;
};

struct ValidationReport {
  std::string file;  ///< As given.
  bool is_glb = false;
  validation::Issues issues;
  std::optional<ValidationInfo> info;  ///< Nothing unless the file is of a version that can be checked.
};

/// @throws InputError when the file itself cannot be read.
ValidationReport validate_gltf(const std::filesystem::path& path, const ValidateOptions& options = {});

}  // namespace barrido::scene
