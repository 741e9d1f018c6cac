#include "pipeline/gltf/compressed_views.h"

#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include <tbb/parallel_for.h>

#include "pipeline/files/module_loader.h"
#include "pipeline/gltf/json_values.h"
#include "pipeline/gltf/meshopt_module/interface.h"

namespace barrido::scene::gltf {
namespace {

using nlohmann::json;

struct CompressedView {
  int index = 0;
  std::string place;
  BarridoMeshoptView source{};
  std::string problem;  ///< Why it cannot be decoded.
  ByteBlock decoded;
};

std::optional<BarridoMeshoptMode> mode_of(const json& extension) {
  const std::string mode = text_of(extension, "mode");
  if (mode == "ATTRIBUTES") return BARRIDO_MESHOPT_ATTRIBUTES;
  if (mode == "TRIANGLES") return BARRIDO_MESHOPT_TRIANGLES;
  if (mode == "INDICES") return BARRIDO_MESHOPT_INDICES;
  return std::nullopt;
}

/// Empty also for the filter that only KHR_meshopt_compression knows.
std::optional<BarridoMeshoptFilter> filter_of(const json& extension) {
  const std::string filter = text_of(extension, "filter");
  if (filter.empty() || filter == "NONE") return BARRIDO_MESHOPT_NONE;
  if (filter == "OCTAHEDRAL") return BARRIDO_MESHOPT_OCTAHEDRAL;
  if (filter == "QUATERNION") return BARRIDO_MESHOPT_QUATERNION;
  if (filter == "EXPONENTIAL") return BARRIDO_MESHOPT_EXPONENTIAL;
  return std::nullopt;
}

/// What the extension says, checked; or the reason why it cannot be true. An element has at most 256 bytes,
/// so that no product overflows.
std::string read_extension(const Document& document, const json& extension, std::uint64_t due,
                           BarridoMeshoptView& source) {
  const auto buffer_index = whole_number(extension, "buffer");
  const auto size = whole_number(extension, "byteLength"), count = whole_number(extension, "count"),
             stride = whole_number(extension, "byteStride");
  const std::uint64_t offset = whole_number(extension, "byteOffset").value_or(0);
  const auto mode = mode_of(extension);
  const auto filter = filter_of(extension);
  if (!buffer_index || !size || !count || !stride) {
    return "its compression lacks a buffer, a byteLength, a byteStride or a count";
  }
  if (!mode) return "the mode of its compression is unknown";
  if (!filter) return "the filter of its compression is not supported";
  if (*buffer_index >= document.buffers().size())
    return "its compressed bytes are in a buffer that is not there";
  const std::string name = element("buffers", static_cast<std::size_t>(*buffer_index));
  const Buffer& buffer = document.buffer(static_cast<int>(*buffer_index));
  if (buffer.owner == nullptr) return name + " has no bytes";
  if (offset > buffer.byte_length || *size > buffer.byte_length - offset) {
    return "its compressed bytes reach past the end of " + name;
  }
  if (*stride == 0 || *stride > 256) return "byteStride " + std::to_string(*stride) + " is not in 1 to 256";
  if (*count * *stride < due) {
    return std::to_string(*count) + " elements of " + std::to_string(*stride) +
           " bytes do not fill its byteLength of " + std::to_string(due);
  }
  source = {*mode,
            *filter,
            static_cast<std::size_t>(*count),
            static_cast<std::size_t>(*stride),
            buffer.bytes.data() + offset,
            static_cast<std::size_t>(*size)};
  return {};
}

/// Takes memory for the decoded bytes.
CompressedView prepare(const Report& report, const Document& document, int index, const json& extension) {
  CompressedView view;
  view.index = index;
  view.place = element("bufferViews", static_cast<std::size_t>(index));
  const std::uint64_t due = document.model().bufferViews[static_cast<std::size_t>(index)].byteLength;
  view.problem = read_extension(document, extension, due, view.source);
  if (!view.problem.empty()) return view;
  const std::size_t bytes = view.source.count * view.source.stride;
  document.budget().take(bytes, report.file(), view.place);
  view.decoded = ByteBlock::allocate(bytes);
  return view;
}

std::vector<CompressedView> prepare_all(const Report& report, const Document& document) {
  std::vector<CompressedView> views;
  const auto all = document.tree().find("bufferViews");
  if (all == document.tree().end()) return views;
  for (std::size_t i = 0; i < all->size(); ++i) {
    if (const json* extension = compression_of((*all)[i])) {
      views.push_back(prepare(report, document, static_cast<int>(i), *extension));
    }
  }
  return views;
}

void decode(CompressedView& view) {
  static const Module module("barrido_meshopt.so", BARRIDO_MESHOPT_ENTRY, BARRIDO_MESHOPT_INTERFACE_VERSION);
  if (!view.problem.empty()) return;
  const auto* functions = module.functions<BarridoMeshoptFunctions>();
  BarridoModuleError error{};
  if (functions == nullptr) {
    view.problem = module.problem("reading EXT_meshopt_compression");
  } else if (functions->decode(&view.source, view.decoded.writable(), &error) == 0) {
    view.problem = error.text;
  }
}

}  // namespace

const json* compression_of(const json& buffer_view) {
  const auto extensions = buffer_view.find("extensions");
  if (extensions == buffer_view.end() || !extensions->is_object()) return nullptr;
  for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    const auto found = extensions->find(name);
    if (found != extensions->end()) return &*found;
  }
  return nullptr;
}

std::map<int, ByteBlock> decode_compressed_views(Report& report, const Document& document,
                                                 std::vector<std::optional<Problem>>& problems) {
  std::vector<CompressedView> views = prepare_all(report, document);
  tbb::parallel_for(std::size_t{0}, views.size(), [&](std::size_t i) { decode(views[i]); });
  std::map<int, ByteBlock> decoded;
  for (CompressedView& view : views) {
    std::optional<Problem>& problem = problems[static_cast<std::size_t>(view.index)];
    if (view.problem.empty()) {
      decoded.emplace(view.index, std::move(view.decoded));
      problem.reset();  // Its place in a buffer does not matter.
    } else if (!problem && document.has_bytes(view.index)) {
      report.warn(view.place + ": " + view.problem + "; its uncompressed bytes are used");
    } else {
      problem = {view.place, view.problem};
    }
  }
  return decoded;
}

}  // namespace barrido::scene::gltf
