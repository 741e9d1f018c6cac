// From checked JSON to plain values.
#include "pipeline/validate/model.h"

#include <algorithm>

namespace barrido::scene::validation {
namespace {

BufferView buffer_view(const Json& source, std::size_t buffers) {
  BufferView view;
  if (!source.is_object()) return view;
  view.buffer = index_of(source, "buffer", buffers);
  view.offset = source.value("byteOffset", std::uint64_t{0});
  view.length = source.value("byteLength", std::uint64_t{0});
  view.stride = source.value("byteStride", std::uint64_t{0});
  view.target = source.value("target", 0);
  return view;
}

std::optional<Sparse> sparse_of(const Json& accessor, std::size_t views) {
  const auto found = accessor.find("sparse");
  if (found == accessor.end() || !found->contains("count") || !found->contains("indices") ||
      !found->contains("values")) {
    return {};
  }
  const Json &indices = found->at("indices"), &values = found->at("values");
  Sparse sparse;
  sparse.count = found->at("count").get<std::uint64_t>();
  sparse.index_view = index_of(indices, "bufferView", views);
  sparse.index_offset = indices.value("byteOffset", std::uint64_t{0});
  sparse.index_type = indices.value("componentType", 0);
  sparse.value_view = index_of(values, "bufferView", views);
  sparse.value_offset = values.value("byteOffset", std::uint64_t{0});
  return sparse;
}

std::vector<double> bounds_of(const Json& accessor, const char* name, int component_type) {
  std::vector<double> bounds;
  const auto found = accessor.find(name);
  if (found == accessor.end()) return bounds;
  for (const Json& item : *found) {
    const double value = item.get<double>();
    // A double beyond single precision has no float; it stays, and no element equals it.
    const bool fits = std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max());
    bounds.push_back(component_type == kFloat && fits ? static_cast<double>(static_cast<float>(value))
                                                      : value);
  }
  return bounds;
}

Accessor accessor_of(const Json& source, std::size_t views) {
  Accessor accessor;
  if (!source.is_object()) return accessor;
  accessor.view = index_of(source, "bufferView", views);
  if (source.contains("bufferView")) accessor.offset = source.value("byteOffset", std::uint64_t{0});
  accessor.component_type = source.value("componentType", 0);
  accessor.count = source.value("count", std::uint64_t{0});
  accessor.type = find_type(source.value("type", std::string()));
  accessor.normalized = source.value("normalized", false);
  accessor.min = bounds_of(source, "min", accessor.component_type);
  accessor.max = bounds_of(source, "max", accessor.component_type);
  accessor.sparse = sparse_of(source, views);
  return accessor;
}

}  // namespace

const Json& array_of(const Json& document, std::string_view name) {
  static const Json kEmpty = Json::array();
  const auto found = document.find(name);
  return found == document.end() ? kEmpty : *found;
}

std::size_t index_of(const Json& object, std::string_view name, std::size_t size) {
  const auto found = object.find(name);
  if (found == object.end()) return kNone;
  const auto index = found->get<std::size_t>();
  return index < size ? index : kNone;
}

std::uint64_t Accessor::element_bytes() const {
  const std::uint64_t bytes = component_bytes(component_type);
  if (type->columns == 1) return bytes * type->components;
  return packed_stride() - packed_stride() / type->columns + type->columns * bytes;
}

std::uint64_t Accessor::packed_stride() const {
  const std::uint64_t bytes = component_bytes(component_type);
  if (type->columns == 1) return bytes * type->components;
  return type->columns * ((type->columns * bytes + 3) / 4 * 4);
}

std::string Accessor::format() const {
  std::string text(type != nullptr ? type->name : "no type");
  text += ", ";
  if (normalized) text += "normalized ";
  text += name_of_component(component_type);
  return '{' + text + '}';
}

Model::Model(const Json& document) {
  for (const Json& source : array_of(document, "buffers")) {
    Buffer& buffer = buffers.emplace_back();
    if (source.is_object() && source.contains("byteLength")) {
      buffer.byte_length = source["byteLength"].get<std::uint64_t>();
    }
  }
  for (const Json& source : array_of(document, "bufferViews")) {
    views.push_back(buffer_view(source, buffers.size()));
  }
  for (const Json& source : array_of(document, "accessors")) {
    accessors.push_back(accessor_of(source, views.size()));
  }
}

std::uint64_t Model::stride_of(const Accessor& accessor) const {
  const std::uint64_t given = accessor.view == kNone ? 0 : views[accessor.view].stride;
  return given != 0 ? given : accessor.packed_stride();
}

std::span<const std::uint8_t> Model::bytes_of(std::size_t view_index, std::uint64_t offset,
                                              std::uint64_t length) const {
  if (view_index == kNone || views[view_index].buffer == kNone) return {};
  const BufferView& view = views[view_index];
  const auto bytes = buffers[view.buffer].bytes;
  if (offset > view.length || length > view.length - offset) return {};
  if (view.offset > bytes.size() || view.length > bytes.size() - view.offset) return {};
  return bytes.subspan(static_cast<std::size_t>(view.offset + offset), static_cast<std::size_t>(length));
}

}  // namespace barrido::scene::validation
