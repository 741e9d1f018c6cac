// Reading of accessors whose bounds are already checked (gltf_accessor_check.cpp); what is left to check is
// inside the data: the order of sparse indices and numbers that are not finite.
#include "pipeline/gltf/accessor.h"

#include <algorithm>
#include <bit>

#include "pipeline/gltf/elements.h"
#include "pipeline/gltf/layout.h"

namespace barrido::scene::gltf {
namespace {

template <typename T>
bool is_aligned(const std::uint8_t* data) {
  return reinterpret_cast<std::uintptr_t>(data) % alignof(T) == 0;
}

/// False for infinities and NaN, whose exponent bits are all ones.
bool is_finite_bits(std::uint32_t bits) { return (bits & 0x7f800000u) != 0x7f800000u; }

/// Two numbers a step: adding 1 to an exponent of ones carries into the sign's bit, and no further.
bool all_finite(std::span<const float> values) {
  constexpr std::uint64_t kExponents = 0x7f8000007f800000u;
  constexpr std::uint64_t kOne = 0x0080000000800000u;
  std::uint64_t carries = 0;
  const std::size_t pairs = values.size() / 2;
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(values.data());
  for (std::size_t i = 0; i < pairs; ++i) carries |= (load<std::uint64_t>(bytes + 8 * i) & kExponents) + kOne;
  const bool last = values.size() % 2 == 0 || is_finite_bits(std::bit_cast<std::uint32_t>(values.back()));
  return last && (carries & 0x8000000080000000u) == 0;
}

/// Elements of an accessor's buffer view, or decoded ones; `data` is null where it has none and all numbers
/// are 0.
Elements base_elements(const Document& document, int index) {
  const tinygltf::Accessor& accessor = document.model().accessors[static_cast<std::size_t>(index)];
  if (const DecodedAccessor* decoded = document.decoded_accessor(index)) {
    const std::size_t components =
        static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
    return {decoded->elements.bytes().data(),
            accessor.count,
            components * component_bytes(decoded->component_type),
            static_cast<int>(components),
            decoded->component_type,
            accessor.normalized};
  }
  std::uint64_t view_stride = 0;
  const std::uint8_t* data = nullptr;
  if (accessor.bufferView >= 0) {
    view_stride = document.model().bufferViews[static_cast<std::size_t>(accessor.bufferView)].byteStride;
    data = document.view_bytes(accessor.bufferView).data() + accessor.byteOffset;
  }
  const ElementLayout layout = element_layout(accessor, view_stride);
  return {data,
          accessor.count,
          layout.stride,
          static_cast<int>(layout.components),
          accessor.componentType,
          accessor.normalized};
}

unsigned format_of(const tinygltf::Accessor& accessor) {
  switch (accessor.componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return accessor.normalized ? kNormalizedByte : kByte;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return accessor.normalized ? kNormalizedUnsignedByte : kUnsignedByte;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return accessor.normalized ? kNormalizedShort : kShort;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return accessor.normalized ? kNormalizedUnsignedShort : kUnsignedShort;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return kUnsignedInt;
    default:
      return kFloat;
  }
}

const char* format_name(unsigned format) {
  switch (format) {
    case kByte:
      return "byte";
    case kUnsignedByte:
      return "unsigned byte";
    case kShort:
      return "short";
    case kUnsignedShort:
      return "unsigned short";
    case kUnsignedInt:
      return "unsigned int";
    case kNormalizedByte:
      return "normalized byte";
    case kNormalizedUnsignedByte:
      return "normalized unsigned byte";
    case kNormalizedShort:
      return "normalized short";
    case kNormalizedUnsignedShort:
      return "normalized unsigned short";
    default:
      return "float";
  }
}

}  // namespace

AccessorReader::AccessorReader(Report& report, const Document& document)
    : report_(report), document_(document) {}

int AccessorReader::components(int accessor) const {
  return tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(source(accessor).type));
}

void AccessorReader::require(int accessor, const std::string& place,
                             std::initializer_list<int> component_counts, unsigned formats,
                             std::size_t expected_count) const {
  if (const auto& problem = document_.accessor_problem(accessor)) {
    report_.fail(problem->place, problem->reason);
  }
  const tinygltf::Accessor& from = source(accessor);
  const std::string name = element("accessors", static_cast<std::size_t>(accessor));
  // MAT2 has as many components as VEC4, but no attribute is one.
  const bool is_small_matrix = from.type == TINYGLTF_TYPE_MAT2 || from.type == TINYGLTF_TYPE_MAT3;
  const bool has_components = std::find(component_counts.begin(), component_counts.end(),
                                        components(accessor)) != component_counts.end();
  if (!has_components || is_small_matrix || (format_of(from) & formats) == 0) {
    report_.fail(place, name + " with " + std::to_string(components(accessor)) + " components of type " +
                            format_name(format_of(from)) + " is not allowed here");
  }
  if (expected_count != 0 && from.count != expected_count) {
    report_.fail(place, name + " has " + std::to_string(from.count) + " elements where " +
                            std::to_string(expected_count) + " are due");
  }
  require_bytes(accessor, place);
}

std::shared_ptr<const void> AccessorReader::owner_of(int accessor) const {
  const DecodedAccessor* decoded = document_.decoded_accessor(accessor);
  return decoded != nullptr ? decoded->elements.owner() : document_.view_owner(source(accessor).bufferView);
}

void AccessorReader::require_bytes(int accessor, const std::string& place) const {
  const tinygltf::Accessor& from = source(accessor);
  const auto check = [&](int buffer_view) {
    if (buffer_view < 0 || document_.has_bytes(buffer_view)) return;
    const auto& view = document_.model().bufferViews[static_cast<std::size_t>(buffer_view)];
    report_.fail(place, element("buffers", static_cast<std::size_t>(view.buffer)) +
                            " has neither a uri nor a binary chunk of a GLB");
  };
  if (document_.decoded_accessor(accessor) == nullptr) check(from.bufferView);
  if (!from.sparse.isSparse) return;
  check(from.sparse.indices.bufferView);
  check(from.sparse.values.bufferView);
}

void AccessorReader::take_scalars(int accessor, std::size_t scalars) {
  document_.budget().take(std::uint64_t{4} * scalars, report_.file(),
                          element("accessors", static_cast<std::size_t>(accessor)));
}

template <typename Visit>
void AccessorReader::visit_sparse(int accessor, Visit visit) const {
  const tinygltf::Accessor& from = source(accessor);
  if (!from.sparse.isSparse) return;
  const auto& sparse = from.sparse;
  const auto count = static_cast<std::size_t>(sparse.count);
  const std::size_t index_bytes = component_bytes(sparse.indices.componentType);
  const std::size_t value_bytes = element_layout(from, 0).element_bytes;
  const std::uint8_t* indices =
      document_.view_bytes(sparse.indices.bufferView).data() + sparse.indices.byteOffset;
  const std::uint8_t* values =
      document_.view_bytes(sparse.values.bufferView).data() + sparse.values.byteOffset;
  std::uint64_t next_allowed = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t index = load_unsigned(indices + i * index_bytes, sparse.indices.componentType);
    if (index >= from.count || index < next_allowed) {
      report_.fail(
          element("accessors", static_cast<std::size_t>(accessor)) + ".sparse.indices",
          "element " + std::to_string(i) + " is " + std::to_string(index) +
              (index >= from.count ? ", but there are only " + std::to_string(from.count) + " elements"
                                   : ", but indices must ascend"));
    }
    next_allowed = std::uint64_t{index} + 1;
    visit(index, values + i * value_bytes);
  }
}

FloatArray AccessorReader::floats(int accessor, int out_components) {
  const auto [cached, is_new] = cache_.try_emplace({accessor, out_components});
  if (is_new) cached->second = make_finite(read_floats(accessor, out_components));
  return cached->second;
}

std::vector<float> AccessorReader::copy_floats(int accessor) {
  const FloatArray array = floats(accessor);
  take_scalars(accessor, array.size());
  return {array.values().begin(), array.values().end()};
}

FloatArray AccessorReader::read_floats(int accessor, int out_components) {
  const tinygltf::Accessor& from = source(accessor);
  Elements in = base_elements(document_, accessor);
  const std::size_t scalars = in.count * static_cast<std::size_t>(out_components);
  const bool is_packed_float = in.data != nullptr && from.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT &&
                               in.components == out_components &&
                               in.stride == sizeof(float) * static_cast<std::size_t>(in.components) &&
                               is_aligned<float>(in.data);
  if (is_packed_float && !from.sparse.isSparse) {
    return FloatArray({reinterpret_cast<const float*>(in.data), scalars}, owner_of(accessor));
  }
  take_scalars(accessor, scalars);
  std::vector<float> values(scalars);
  if (in.data != nullptr) {
    convert_to_floats(in, values.data(), out_components);
  } else {
    // Elements of zeros, but what they do not have is 1, as always.
    for (std::size_t i = 0; i < scalars; ++i) {
      if (i % static_cast<std::size_t>(out_components) >= static_cast<std::size_t>(in.components))
        values[i] = 1.0f;
    }
  }
  visit_sparse(accessor, [&](std::uint32_t index, const std::uint8_t* value) {
    in.data = value;
    in.count = 1;
    convert_to_floats(in, values.data() + index * static_cast<std::size_t>(out_components), out_components);
  });
  return FloatArray(std::move(values));
}

FloatArray AccessorReader::make_finite(FloatArray array) {
  if (all_finite(array.values())) return array;
  std::vector<float> values(array.values().begin(), array.values().end());
  for (float& value : values) {
    if (is_finite_bits(std::bit_cast<std::uint32_t>(value))) continue;
    value = 0.0f;
    ++not_finite_;
  }
  return FloatArray(std::move(values));
}

const CheckedIndices& AccessorReader::indices(int accessor, const std::string& place) {
  require(accessor, place, {1}, kUnsignedByte | kUnsignedShort | kUnsignedInt);
  const auto [cached, is_new] = index_cache_.try_emplace(accessor);
  if (is_new) {
    cached->second.values = read_indices(accessor);
    std::uint32_t largest = 0;
    for (const std::uint32_t index : cached->second.values) largest = std::max(largest, index);
    cached->second.largest = largest;
  }
  return cached->second;
}

IndexArray AccessorReader::read_indices(int accessor) {
  const tinygltf::Accessor& from = source(accessor);
  const Elements in = base_elements(document_, accessor);
  const bool is_packed = in.data != nullptr && in.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT &&
                         in.stride == sizeof(std::uint32_t) && is_aligned<std::uint32_t>(in.data);
  if (is_packed && !from.sparse.isSparse) {
    return IndexArray({reinterpret_cast<const std::uint32_t*>(in.data), in.count}, owner_of(accessor));
  }
  take_scalars(accessor, in.count);
  std::vector<std::uint32_t> values(in.count);
  if (in.data != nullptr) widen_indices(in, values.data());
  visit_sparse(accessor, [&](std::uint32_t index, const std::uint8_t* value) {
    values[index] = load_unsigned(value, from.componentType);
  });
  return IndexArray(std::move(values));
}

std::vector<std::array<std::uint16_t, 4>> AccessorReader::unsigned_vec4(int accessor,
                                                                        const std::string& place) {
  require(accessor, place, {4}, kUnsignedByte | kUnsignedShort);
  const Elements in = base_elements(document_, accessor);
  take_scalars(accessor, in.count * 4);
  const std::size_t bytes = component_bytes(in.component_type);
  const auto read = [&](const std::uint8_t* element) {
    std::array<std::uint16_t, 4> value;
    for (std::size_t c = 0; c < 4; ++c) {
      value[c] = static_cast<std::uint16_t>(load_unsigned(element + c * bytes, in.component_type));
    }
    return value;
  };
  std::vector<std::array<std::uint16_t, 4>> values(in.count);
  if (in.data != nullptr) {
    for (std::size_t i = 0; i < in.count; ++i) values[i] = read(in.data + i * in.stride);
  }
  visit_sparse(accessor,
               [&](std::uint32_t index, const std::uint8_t* value) { values[index] = read(value); });
  return values;
}

void AccessorReader::finish() {
  if (not_finite_ == 0) return;
  report_.warn(std::to_string(not_finite_) +
               " numbers that are not finite (NaN or infinity) were replaced by 0");
}

}  // namespace barrido::scene::gltf
