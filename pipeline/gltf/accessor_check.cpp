// Buffer views against buffers, accessors against buffer views. What has no problem here may be read; what
// has one is an error as soon as something uses it.
#include <string>

#include "pipeline/gltf/accessor.h"
#include "pipeline/gltf/layout.h"

namespace barrido::scene::gltf {
namespace {

/// "byteOffset 96 + 40 bytes reaches past the end of bufferViews[1] (100 bytes)"
std::string past_the_end(std::uint64_t offset, std::uint64_t bytes, const std::string& container,
                         std::uint64_t container_bytes) {
  return "byteOffset " + std::to_string(offset) + " + " + std::to_string(bytes) +
         " bytes reaches past the end of " + container + " (" + std::to_string(container_bytes) + " bytes)";
}

bool fits(std::uint64_t offset, std::uint64_t bytes, std::uint64_t container_bytes) {
  return offset <= container_bytes && bytes <= container_bytes - offset;
}

/// Throws the first problem of an accessor.
class AccessorCheck {
 public:
  AccessorCheck(const Document& document, std::size_t index)
      : document_(document),
        model_(document.model()),
        accessor_(model_.accessors[index]),
        place_(element("accessors", index)) {}

  void run(std::uint64_t max_count) const {
    if (component_bytes(accessor_.componentType) == 0) {
      fail(place_, "componentType " + std::to_string(accessor_.componentType) + " is none of glTF's");
    }
    if (accessor_.count > max_count) {
      fail(place_, "has " + std::to_string(accessor_.count) + " elements; at most " +
                       std::to_string(max_count) + " are read");
    }
    if (accessor_.bufferView >= 0) check_elements();
    if (accessor_.sparse.isSparse) check_sparse();
  }

 private:
  const tinygltf::BufferView& view(int index) const {
    return model_.bufferViews[static_cast<std::size_t>(index)];
  }

  void check_elements() const {
    const tinygltf::BufferView& source = view(accessor_.bufferView);
    const ElementLayout layout = element_layout(accessor_, source.byteStride);
    if (layout.stride < layout.element_bytes) {
      fail(place_, "its elements of " + std::to_string(layout.element_bytes) +
                       " bytes are larger than the byteStride " + std::to_string(layout.stride) +
                       " of its buffer view");
    }
    check_range(place_, accessor_.bufferView, accessor_.byteOffset,
                (accessor_.count - 1) * layout.stride + layout.element_bytes);
  }

  void check_sparse() const {
    const auto& sparse = accessor_.sparse;
    const std::string place = place_ + ".sparse";
    const auto count = static_cast<std::uint64_t>(sparse.count);
    if (count > accessor_.count) fail(place, "has more elements than the accessor");
    const int type = sparse.indices.componentType;
    if (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
        type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
      fail(place + ".indices", "componentType " + std::to_string(type) + " is not unsigned");
    }
    check_range(place + ".indices", sparse.indices.bufferView,
                static_cast<std::uint64_t>(sparse.indices.byteOffset), count * component_bytes(type));
    check_range(place + ".values", sparse.values.bufferView,
                static_cast<std::uint64_t>(sparse.values.byteOffset),
                count * element_layout(accessor_, 0).element_bytes);
  }

  void check_range(const std::string& place, int buffer_view, std::uint64_t offset,
                   std::uint64_t bytes) const {
    const std::optional<Problem>& of_view = document_.view_problem(buffer_view);
    if (of_view) throw Problem(*of_view);
    const std::uint64_t length = view(buffer_view).byteLength;
    if (!fits(offset, bytes, length)) {
      fail(place, past_the_end(offset, bytes, element("bufferViews", static_cast<std::size_t>(buffer_view)),
                               length));
    }
  }

  [[noreturn]] static void fail(const std::string& place, const std::string& reason) {
    throw Problem{place, reason};
  }

  const Document& document_;
  const tinygltf::Model& model_;
  const tinygltf::Accessor& accessor_;
  std::string place_;
};

}  // namespace

std::vector<std::optional<Problem>> check_views(const Document& document) {
  const auto& views = document.model().bufferViews;
  std::vector<std::optional<Problem>> problems(views.size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    const tinygltf::BufferView& view = views[i];
    const std::uint64_t length = document.buffer(view.buffer).byte_length;
    if (!fits(view.byteOffset, view.byteLength, length)) {
      problems[i] = {element("bufferViews", i),
                     past_the_end(view.byteOffset, view.byteLength,
                                  element("buffers", static_cast<std::size_t>(view.buffer)), length)};
    }
  }
  return problems;
}

std::vector<std::optional<Problem>> check_accessors(const Document& document, std::uint64_t max_count) {
  std::vector<std::optional<Problem>> problems(document.model().accessors.size());
  for (std::size_t i = 0; i < problems.size(); ++i) {
    try {
      AccessorCheck(document, i).run(max_count);
    } catch (const Problem& problem) {
      problems[i] = problem;
    }
  }
  return problems;
}

}  // namespace barrido::scene::gltf
