// Small models for the importer's tests: JSON that a test may change at will, numbers appended to one buffer,
// written to a folder of the test's own.
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include "pipeline/gltf/import_gltf.h"
#include "temporary_folder.h"

namespace barrido::scene::test {

using nlohmann::json;

enum ComponentType { kI8 = 5120, kU8 = 5121, kI16 = 5122, kU16 = 5123, kU32 = 5125, kF32 = 5126 };

/// A model in the making.
class Model {
 public:
  json document = {{"asset", {{"version", "2.0"}}}};

  /// Appends numbers to the buffer, at a multiple of 4 plus `misalignment`; returns the buffer view's index.
  template <typename T>
  int add_view(const std::vector<T>& values, int stride = 0, std::size_t misalignment = 0) {
    bytes_.resize((bytes_.size() + 3) / 4 * 4 + misalignment);
    const std::size_t size = values.size() * sizeof(T);
    json view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", size}};
    if (stride != 0) view["byteStride"] = stride;
    const auto* begin = reinterpret_cast<const std::uint8_t*>(values.data());
    bytes_.insert(bytes_.end(), begin, begin + size);
    return append("bufferViews", view);
  }

  int add_accessor(int view, int component_type, const char* type, std::size_t count,
                   bool normalized = false) {
    json accessor = {{"componentType", component_type}, {"type", type}, {"count", count}};
    if (view >= 0) accessor["bufferView"] = view;
    if (normalized) accessor["normalized"] = true;
    return append("accessors", accessor);
  }

  /// Appends to a top-level array; returns the index.
  int append(const char* array, const json& value) {
    document[array].push_back(value);
    return static_cast<int>(document[array].size()) - 1;
  }

  /// model.gltf with its buffer in model.bin.
  std::filesystem::path write_gltf(const TemporaryFolder& folder) const {
    json complete = document;
    if (!bytes_.empty() && !complete.contains("buffers")) {
      complete["buffers"] = {{{"uri", "model.bin"}, {"byteLength", bytes_.size()}}};
      folder.write("model.bin", bytes_);
    }
    return folder.write("model.gltf", complete.dump());
  }

  std::vector<std::uint8_t> glb() const {
    json complete = document;
    if (!bytes_.empty()) complete["buffers"] = {{{"byteLength", bytes_.size()}}};
    std::string text = complete.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::vector<std::uint8_t> padded = bytes_;
    padded.resize((padded.size() + 3) / 4 * 4);
    std::vector<std::uint8_t> file;
    const auto put = [&](std::uint32_t value) {
      for (int i = 0; i < 4; ++i) file.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    };
    put(0x46546c67);
    put(2);
    put(static_cast<std::uint32_t>(28 + text.size() + padded.size()));
    put(static_cast<std::uint32_t>(text.size()));
    put(0x4e4f534a);
    file.insert(file.end(), text.begin(), text.end());
    put(static_cast<std::uint32_t>(padded.size()));
    put(0x004e4942);
    file.insert(file.end(), padded.begin(), padded.end());
    return file;
  }

  Scene import(const ImportOptions& options = {}) const {
    const TemporaryFolder folder;
    return import_gltf(write_gltf(folder), options);
  }

 private:
  std::vector<std::uint8_t> bytes_;
};

/// One triangle with positions (accessor 0) and indices (accessor 1) in one mesh, node and scene.
inline Model triangle() {
  Model model;
  model.add_accessor(model.add_view(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}), kF32, "VEC3", 3);
  model.add_accessor(model.add_view(std::vector<std::uint16_t>{0, 1, 2}), kU16, "SCALAR", 3);
  model.document["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}};
  model.document["nodes"] = {{{"mesh", 0}}};
  model.document["scenes"] = {{{"nodes", {0}}}};
  model.document["scene"] = 0;
  return model;
}

inline json& primitive(Model& model) { return model.document["meshes"][0]["primitives"][0]; }

/// The message of the InputError that `run` throws; a failure of the test when it throws none.
template <typename Run>
std::string input_error(Run run) {
  try {
    run();
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no InputError";
  return {};
}

inline testing::AssertionResult contains(const char*, const char*, const std::string& text,
                                         const std::string& part) {
  if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "\"" << text << "\" does not hold \"" << part << "\"";
}
#define EXPECT_CONTAINS(text, part) EXPECT_PRED_FORMAT2(contains, text, part)

inline std::string import_error(const Model& model) {
  return input_error([&] { model.import(); });
}

inline std::vector<float> values(const FloatArray& array) {
  return {array.values().begin(), array.values().end()};
}
inline std::vector<std::uint32_t> values(const IndexArray& array) { return {array.begin(), array.end()}; }

/// Data of every test file that is not part of the project.
inline std::filesystem::path assets_folder() {
  return std::filesystem::path(BARRIDO_SOURCE_DIR) / "../shared/assets";
}

}  // namespace barrido::scene::test
