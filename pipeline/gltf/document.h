// A glTF document after every check that can be made without looking at its elements: JSON types, ranges and
// indices, buffers of the promised length, buffer views and accessors within their buffers. What comes later
// may use any index it finds here, and what lies behind views and accessors without a problem.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include <tiny_gltf.h>
#include <nlohmann/json_fwd.hpp>

#include "pipeline/files/bytes.h"
#include "pipeline/gltf/container.h"
#include "pipeline/gltf/import_gltf.h"
#include "pipeline/gltf/report.h"

namespace barrido::scene::gltf {

/// A buffer's byteLength bytes and what keeps them alive. A file may leave a buffer to the application; it
/// has no bytes then, and what needs them is an error.
struct Buffer {
  std::uint64_t byte_length = 0;
  std::span<const std::uint8_t> bytes;
  std::shared_ptr<const void> owner;
};

/// An image's encoded bytes, or the reason why they cannot be had.
struct EncodedImage {
  std::string name;  ///< For messages: its file, its name, or "images[3]".
  std::span<const std::uint8_t> bytes;
  std::shared_ptr<const void> owner;
  std::string problem;
};

/// What is wrong with an element that nothing may use.
struct Problem {
  std::string place, reason;
};

/// The elements of an accessor, tightly packed, in place of those that its buffer view holds.
struct DecodedAccessor {
  ByteBlock elements;
  int component_type = 0;
};

class Document {
 public:
  /// Reads `path` and the buffers it refers to.
  /// `options` must have a budget. @throws InputError.
  Document(Report& report, const std::filesystem::path& path, const ImportOptions& options);
  ~Document();

  const tinygltf::Model& model() const { return model_; }
  /// The checked JSON; without buffers and their contents.
  const nlohmann::json& tree() const { return *json_; }
  Budget& budget() const { return *options_.budget; }
  const std::vector<Buffer>& buffers() const { return buffers_; }
  const Buffer& buffer(int index) const { return buffers_[static_cast<std::size_t>(index)]; }
  const std::optional<Problem>& view_problem(int buffer_view) const {
    return view_problems_[static_cast<std::size_t>(buffer_view)];
  }
  const std::optional<Problem>& accessor_problem(int accessor) const {
    return accessor_problems_[static_cast<std::size_t>(accessor)];
  }
  /// Warns of views and accessors with a problem that was not met: nothing that is drawn uses them.
  void warn_of_unused(Report& report) const;
  bool has_bytes(int buffer_view) const;
  /// Only of a view that has bytes; decoded where they are compressed.
  std::span<const std::uint8_t> view_bytes(int buffer_view) const;
  /// What keeps them alive.
  std::shared_ptr<const void> view_owner(int buffer_view) const;

  /// Null where the accessor's elements are in its buffer view.
  const DecodedAccessor* decoded_accessor(int accessor) const;

  std::size_t image_count() const;
  /// Reads the bytes of one image; may be called from several threads at once.
  EncodedImage read_image(std::size_t index) const;

 private:
  void load_buffers(Report& report, const Container& container, const ByteBlock& file);
  void parse_model(const Report& report);
  void take_views_from_indices();

  std::filesystem::path folder_;
  ImportOptions options_;
  std::unique_ptr<nlohmann::json> json_;
  tinygltf::Model model_;
  std::vector<Buffer> buffers_;
  std::vector<std::optional<Problem>> view_problems_, accessor_problems_;
  std::map<int, ByteBlock> decoded_views_;            ///< Of compressed buffer views
  std::map<int, DecodedAccessor> decoded_accessors_;  ///< Of compressed primitives
};

}  // namespace barrido::scene::gltf
