// Words of the schema's tables.
#include "pipeline/gltf/schema.h"

#include <algorithm>
#include <array>

namespace barrido::scene::gltf {

std::string_view name_of(Collection collection) {
  constexpr std::array<std::string_view, kCollections> kNames = {
      "accessors", "buffers",  "bufferViews", "cameras", "images",   "materials", "meshes",
      "nodes",     "samplers", "scenes",      "skins",   "textures", "lights",    "variants"};
  return kNames[static_cast<std::size_t>(collection)];
}

std::string pointer_to(Collection collection) {
  const std::string_view extension = collection == Collection::lights ? "/extensions/KHR_lights_punctual"
                                     : collection == Collection::variants
                                         ? "/extensions/KHR_materials_variants"
                                         : "";
  return std::string(extension) + '/' + std::string(name_of(collection));
}

bool is_choice(std::string_view text, std::string_view choices) {
  while (!choices.empty()) {
    const std::string_view choice = choices.substr(0, choices.find('|'));
    if (choice == text) return true;
    choices.remove_prefix(std::min(choice.size() + 1, choices.size()));
  }
  return false;
}

std::string list_of(std::string_view choices) {
  std::string text(choices);
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.replace(at, 1, ", ");
  return text;
}

}  // namespace barrido::scene::gltf
