// Buffers, views and accessors with any numbers in them, through the reader of accessors. What it lets pass
// must lie in memory to its last element, be finite, and have no index above the largest it reports.
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include <nlohmann/json.hpp>

#include "input.h"
#include "model_file.h"
#include "pipeline/gltf/accessor.h"
#include "viewer/compare/text_encoding.h"

namespace barrido::fuzz {
namespace {

using nlohmann::json;
namespace gltf = scene::gltf;

/// Small as a rule, else where sums and products of 31, 32, 53, 63 and 64 bits end.
json any_integer(Input& input) {
  constexpr std::int64_t kEdges[] = {
      -1,         2147483647,       2147483648,          4294967295,
      4294967296, 9007199254740991, 4611686018427387904, std::numeric_limits<std::int64_t>::max()};
  const std::uint8_t kind = input.byte();
  if (kind < 224) return kind;
  if (kind < 248) return kEdges[kind % std::size(kEdges)] - input.between(0, 3);
  return static_cast<std::int64_t>(static_cast<std::int32_t>(input.bits32()));
}

/// Right as a rule: an input made of chance alone would hardly ever pass a check.
json mostly(Input& input, const json& right) { return input.byte() < 224 ? right : any_integer(input); }

json any_component_type(Input& input) {
  return mostly(input, input.pick({5126, 5126, 5125, 5123, 5121, 5120, 5122}));
}

json any_buffer(Input& input) {
  const Bytes bytes = input.take(input.byte());
  json buffer = {{"byteLength", mostly(input, bytes.size())}};
  if (input.byte() < 240) buffer["uri"] = "data:application/octet-stream;base64," + compare::base64(bytes);
  return buffer;
}

json any_view(Input& input, const json& buffers) {
  const int buffer = input.between(0, static_cast<int>(buffers.size()) - 1);
  const json& length = buffers[static_cast<std::size_t>(buffer)]["byteLength"];
  json view = {{"buffer", mostly(input, buffer)}, {"byteLength", mostly(input, length)}};
  if (input.flag()) {
    view["byteOffset"] = any_integer(input);
    view["byteLength"] = any_integer(input);
  }
  if (input.byte() < 64) view["byteStride"] = any_integer(input);
  return view;
}

json any_sparse(Input& input, int view_count) {
  const auto view = [&] { return mostly(input, input.between(0, view_count - 1)); };
  json sparse = {{"count", any_integer(input)},
                 {"indices", {{"bufferView", view()}, {"componentType", any_component_type(input)}}},
                 {"values", {{"bufferView", view()}}}};
  for (const char* part : {"indices", "values"}) {
    if (input.flag()) sparse[part]["byteOffset"] = any_integer(input);
  }
  return sparse;
}

json any_accessor(Input& input, int view_count) {
  json accessor = {{"componentType", any_component_type(input)},
                   {"type", input.pick({"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"})},
                   {"count", any_integer(input)}};
  if (input.byte() < 224) accessor["bufferView"] = mostly(input, input.between(0, view_count - 1));
  if (input.flag()) accessor["byteOffset"] = any_integer(input);
  if (input.byte() < 64) accessor["normalized"] = true;
  if (input.byte() < 96) accessor["sparse"] = any_sparse(input, view_count);
  return accessor;
}

json any_document(Input& input) {
  json document = {{"asset", {{"version", "2.0"}}}};
  for (int i = input.between(1, 2); i > 0; --i) document["buffers"].push_back(any_buffer(input));
  const int views = input.between(1, 4);
  for (int i = 0; i < views; ++i) document["bufferViews"].push_back(any_view(input, document["buffers"]));
  for (int i = input.between(1, 4); i > 0; --i) document["accessors"].push_back(any_accessor(input, views));
  return document;
}

void check_floats(gltf::AccessorReader& reader, int accessor, int components) {
  const scene::FloatArray array = reader.floats(accessor, components);
  require(array.size() == reader.count(accessor) * static_cast<std::size_t>(components),
          "numbers are missing");
  for (const float value : array.values()) require(std::isfinite(value), "a number is not finite");
}

void check_indices(gltf::AccessorReader& reader, int accessor) {
  const gltf::CheckedIndices& indices = reader.indices(accessor, "here");
  require(indices.values.size() == reader.count(accessor), "indices are missing");
  for (const std::uint32_t index : indices.values)
    require(index <= indices.largest, "an index is above the largest");
}

template <class Read>
void expect_input_error(Read read) {
  try {
    read();
  } catch (const scene::InputError&) {
  }
}

void read_in_every_way(gltf::Report& report, const gltf::Document& document) {
  constexpr unsigned kAllFormats = 2 * gltf::kNormalizedUnsignedShort - 1;
  const auto count = static_cast<int>(document.model().accessors.size());
  gltf::AccessorReader reader(report, document);
  for (int accessor = 0; accessor < count; ++accessor) {
    const int components = reader.components(accessor);
    expect_input_error([&] {
      reader.require(accessor, "here", {1, 2, 3, 4, 16}, kAllFormats);
      check_floats(reader, accessor, components);
      if (components == 3) check_floats(reader, accessor, 4);
      require(reader.copy_floats(accessor).size() == reader.floats(accessor).size(), "the copy is shorter");
    });
    expect_input_error([&] { check_indices(reader, accessor); });
    expect_input_error([&] {
      require(reader.unsigned_vec4(accessor, "here").size() == reader.count(accessor), "vectors are missing");
    });
  }
  reader.finish();
}

}  // namespace

void run_accessor(Bytes bytes) {
  static const ModelFile file;
  Input input(bytes);
  const std::string text = any_document(input).dump();
  const auto path =
      file.write("model.gltf", {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  expect_input_error([&] {
    gltf::Report report(path.string());
    auto options = small_limits();
    options.budget = std::make_shared<scene::Budget>();
    const gltf::Document document(report, path, options);
    read_in_every_way(report, document);
  });
}

}  // namespace barrido::fuzz
