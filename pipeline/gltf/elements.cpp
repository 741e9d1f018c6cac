// The loops that convert whole arrays, one instance a component type.
#include "pipeline/gltf/elements.h"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace barrido::scene::gltf {
namespace {

/// Integer to float as glTF 2.0, section 3.11 defines for normalised accessors.
template <typename T>
float normalized_to_float(T value) {
  constexpr float kMaximum = static_cast<float>(std::numeric_limits<T>::max());
  return std::max(static_cast<float>(value) / kMaximum, -1.0f);
}

template <typename T>
void convert_as(const Elements& in, float* out, int out_components) {
  for (std::size_t i = 0; i < in.count; ++i) {
    const std::uint8_t* element = in.data + i * in.stride;
    for (int c = 0; c < in.components; ++c) {
      const T value = load<T>(element + static_cast<std::size_t>(c) * sizeof(T));
      if constexpr (std::is_integral_v<T>) {
        out[c] = in.normalized ? normalized_to_float(value) : static_cast<float>(value);
      } else {
        out[c] = value;
      }
    }
    for (int c = in.components; c < out_components; ++c) out[c] = 1.0f;
    out += out_components;
  }
}

template <typename T>
void widen(const std::uint8_t* data, std::size_t stride, std::uint32_t* out, std::size_t count) {
  if (stride == sizeof(T)) {
    for (std::size_t i = 0; i < count; ++i) out[i] = load<T>(data + i * sizeof(T));
  } else {
    for (std::size_t i = 0; i < count; ++i) out[i] = load<T>(data + i * stride);
  }
}

}  // namespace

void convert_to_floats(const Elements& in, float* out, int out_components) {
  switch (in.component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return convert_as<std::int8_t>(in, out, out_components);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return convert_as<std::uint8_t>(in, out, out_components);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return convert_as<std::int16_t>(in, out, out_components);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return convert_as<std::uint16_t>(in, out, out_components);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return convert_as<std::uint32_t>(in, out, out_components);
    default:
      return convert_as<float>(in, out, out_components);
  }
}

std::uint32_t load_unsigned(const std::uint8_t* bytes, int component_type) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return *bytes;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return load<std::uint16_t>(bytes);
    default:
      return load<std::uint32_t>(bytes);
  }
}

void widen_indices(const Elements& in, std::uint32_t* out) {
  switch (in.component_type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return widen<std::uint8_t>(in.data, in.stride, out, in.count);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return widen<std::uint16_t>(in.data, in.stride, out, in.count);
    default:
      return widen<std::uint32_t>(in.data, in.stride, out, in.count);
  }
}

}  // namespace barrido::scene::gltf
