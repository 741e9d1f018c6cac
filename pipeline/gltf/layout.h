// How the elements of an accessor lie in memory (glTF 2.0, section 3.6.2). Plain arithmetic on numbers that
// the checks of check.h have bounded: no product here can overflow 64 bits.
#pragma once

#include <cstdint>

#include <tiny_gltf.h>

namespace barrido::scene::gltf {

struct ElementLayout {
  std::uint64_t component_bytes = 0;
  std::uint64_t components = 0;
  std::uint64_t element_bytes = 0;  ///< With the padding of matrix columns to 4 bytes.
  std::uint64_t stride = 0;         ///< From one element to the next.
};

/// 1, 2 or 4; 0 for what is no component type of glTF.
constexpr std::uint64_t component_bytes(int component_type) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

/// `view_stride`: the buffer view's byteStride, 0 where elements are packed.
inline ElementLayout element_layout(const tinygltf::Accessor& accessor, std::uint64_t view_stride) {
  ElementLayout layout;
  layout.component_bytes = component_bytes(accessor.componentType);
  layout.components =
      static_cast<std::uint64_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
  layout.element_bytes = layout.component_bytes * layout.components;
  const bool is_matrix = accessor.type == TINYGLTF_TYPE_MAT2 || accessor.type == TINYGLTF_TYPE_MAT3 ||
                         accessor.type == TINYGLTF_TYPE_MAT4;
  if (is_matrix) {
    const std::uint64_t columns = static_cast<std::uint64_t>(accessor.type - TINYGLTF_TYPE_MAT2) + 2;
    const std::uint64_t column_bytes = (columns * layout.component_bytes + 3) / 4 * 4;
    layout.element_bytes = columns * column_bytes;
  }
  layout.stride = view_stride == 0 ? layout.element_bytes : view_stride;
  return layout;
}

}  // namespace barrido::scene::gltf
