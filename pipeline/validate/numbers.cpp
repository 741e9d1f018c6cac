// Buffers promise no alignment, so every number is copied out.
#include "pipeline/validate/numbers.h"

#include <algorithm>
#include <cstring>

namespace barrido::scene::validation {
namespace {

template <typename T>
double load(const std::uint8_t* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return static_cast<double>(value);
}

double load_as(int component_type, const std::uint8_t* bytes) {
  switch (component_type) {
    case kByte:
      return load<std::int8_t>(bytes);
    case kUnsignedByte:
      return load<std::uint8_t>(bytes);
    case kShort:
      return load<std::int16_t>(bytes);
    case kUnsignedShort:
      return load<std::uint16_t>(bytes);
    case kUnsignedInt:
      return load<std::uint32_t>(bytes);
    default:
      return load<float>(bytes);
  }
}

/// count × bytes, unless that is more than any view can hold.
bool multiply(std::uint64_t count, std::uint64_t bytes, std::uint64_t& product) {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 53;
  if (bytes == 0 || count > kMost / bytes) return false;
  product = count * bytes;
  return true;
}

/// Numbers that do not begin where they must are reported as such, and not as what they seem to be.
bool is_aligned(const Model& model, std::size_t view, std::uint64_t offset, std::size_t component) {
  return view != kNone && offset % component == 0 && model.views[view].offset % component == 0;
}

}  // namespace

Numbers::Numbers(const Model& model, const Accessor& accessor) : accessor_(accessor) {
  if (!accessor.is_complete() || (accessor.view == kNone && !accessor.sparse)) return;
  const std::size_t component = component_bytes(accessor.component_type);
  if (accessor.view != kNone) {
    if (!is_aligned(model, accessor.view, accessor.offset, component)) return;
    stride_ = model.stride_of(accessor);
    std::uint64_t length = 0;
    if (stride_ < accessor.element_bytes() || !multiply(accessor.count, stride_, length)) return;
    bytes_ = model.bytes_of(accessor.view, accessor.offset, length - stride_ + accessor.element_bytes());
    if (bytes_.empty()) return;
  }
  if (accessor.sparse) {
    const Sparse& sparse = *accessor.sparse;
    const std::size_t index = component_bytes(sparse.index_type);
    if (index == 0 || !is_aligned(model, sparse.index_view, sparse.index_offset, index) ||
        !is_aligned(model, sparse.value_view, sparse.value_offset, component)) {
      return;
    }
    std::uint64_t indices = 0, values = 0;
    if (sparse.count > accessor.count || !multiply(sparse.count, index, indices) ||
        !multiply(sparse.count, accessor.packed_stride(), values)) {
      return;
    }
    sparse_indices_ = model.bytes_of(sparse.index_view, sparse.index_offset, indices);
    sparse_values_ = model.bytes_of(sparse.value_view, sparse.value_offset, values);
    if (sparse_indices_.empty() || sparse_values_.empty()) return;
  }
  readable_ = true;
}

std::uint64_t Numbers::sparse_index(std::uint64_t i) const {
  const int type = accessor_.sparse->index_type;
  return static_cast<std::uint64_t>(load_as(type, sparse_indices_.data() + i * component_bytes(type)));
}

std::size_t Numbers::offset_of(std::size_t component) const {
  const std::size_t bytes = component_bytes(accessor_.component_type);
  const std::size_t columns = accessor_.type->columns;
  if (columns == 1) return component * bytes;
  return component / columns * ((columns * bytes + 3) / 4 * 4) + component % columns * bytes;
}

double Numbers::at(std::uint64_t element, std::size_t component) {
  const std::uint8_t* source = bytes_.empty() ? nullptr : bytes_.data() + element * stride_;
  if (accessor_.sparse) {
    const std::uint64_t count = accessor_.sparse->count;
    while (sparse_at_ + 1 < count && sparse_index(sparse_at_) < element) ++sparse_at_;
    if (sparse_index(sparse_at_) == element)
      source = sparse_values_.data() + sparse_at_ * accessor_.packed_stride();
  }
  return source == nullptr ? 0.0 : load_as(accessor_.component_type, source + offset_of(component));
}

double Numbers::normalized_at(std::uint64_t element, std::size_t component) {
  const double value = at(element, component);
  if (!accessor_.normalized || accessor_.component_type == kFloat) return value;
  return std::max(value / greatest_of(accessor_.component_type), -1.0);
}

}  // namespace barrido::scene::validation
