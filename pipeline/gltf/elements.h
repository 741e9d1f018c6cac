// Numbers as glTF's buffers hold them, and their conversion to floats and 32-bit indices. Works on memory
// whose bounds somebody else has checked.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include <tiny_gltf.h>

namespace barrido::scene::gltf {

static_assert(std::endian::native == std::endian::little, "glTF's buffers are little-endian");

/// Buffers promise no alignment that a processor could rely on.
template <typename T>
T load(const std::uint8_t* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

struct Elements {
  const std::uint8_t* data = nullptr;  ///< Null: all numbers are 0.
  std::size_t count = 0;
  std::size_t stride = 0;  ///< Bytes
  int components = 0;
  int component_type = TINYGLTF_COMPONENT_TYPE_FLOAT;
  bool normalized = false;
};

/// Writes count × out_components floats; components that the elements lack become 1.
void convert_to_floats(const Elements& in, float* out, int out_components);

/// Writes `count` indices from unsigned elements of one component.
void widen_indices(const Elements& in, std::uint32_t* out);

std::uint32_t load_unsigned(const std::uint8_t* bytes, int component_type);

}  // namespace barrido::scene::gltf
