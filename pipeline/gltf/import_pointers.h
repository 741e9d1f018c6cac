// KHR_animation_pointer: from JSON pointers to what an animation can move.
#pragma once

#include <optional>
#include <string_view>

#include "pipeline/gltf/import_parts.h"

namespace barrido::scene::gltf {

struct NodePointer {
  int node = kNone;  ///< Not yet checked
  AnimationChannel::Path path = AnimationChannel::Path::translation;
};
/// "/nodes/3/translation"; none for all else.
std::optional<NodePointer> node_pointer(std::string_view pointer);

struct PropertyPointer {
  PropertyChannel channel;  ///< Without keys
  int components = 1;       ///< Of a key's value
};
/// "/materials/0/pbrMetallicRoughness/baseColorFactor"; none where it leads to nothing that can be moved.
/// @throws InputError where there is no such object.
std::optional<PropertyPointer> property_pointer(Import& import, std::string_view pointer);

}  // namespace barrido::scene::gltf
