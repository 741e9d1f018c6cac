// Elements counted before the walk begins, since references may lead forwards.
#include "pipeline/validate/references.h"

#include <algorithm>

namespace barrido::scene::validation {
namespace {

constexpr std::array<std::string_view, static_cast<std::size_t>(Collection::count)> kNames = {
    "accessors", "buffers",  "bufferViews", "cameras", "images",   "materials", "meshes",
    "nodes",     "samplers", "scenes",      "skins",   "textures", "lights",    "variants"};

constexpr const char* kLightsPointer = "/extensions/KHR_lights_punctual/lights";
constexpr const char* kVariantsPointer = "/extensions/KHR_materials_variants/variants";

const Json& at_pointer(const Json& document, const char* pointer) {
  static const Json kNull;
  const Json::json_pointer path(pointer);
  return document.contains(path) ? document.at(path) : kNull;
}

}  // namespace

std::string_view name_of(Collection collection) { return kNames[static_cast<std::size_t>(collection)]; }

References::References(const Json& document) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(Collection::lights); ++i) {
    const auto found = document.find(kNames[i]);
    if (found != document.end()) count(static_cast<Collection>(i), *found, false);
  }
  count(Collection::lights, at_pointer(document, kLightsPointer), true);
  count(Collection::variants, at_pointer(document, kVariantsPointer), true);
}

void References::count(Collection collection, const Json& array, bool all_or_none) {
  if (!array.is_array()) return;
  auto& states = states_[static_cast<std::size_t>(collection)];
  for (const Json& item : array) states.push_back(item.is_object() ? State::unused : State::missing);
  if (all_or_none && std::find(states.begin(), states.end(), State::missing) != states.end()) states.clear();
}

bool References::exists(Collection collection, std::size_t index) const {
  const auto& states = states_[static_cast<std::size_t>(collection)];
  return index < states.size() && states[index] != State::missing;
}

void References::use(Collection collection, std::size_t index) {
  if (exists(collection, index)) states_[static_cast<std::size_t>(collection)][index] = State::used;
}

void References::report_unused(Issues& issues) const {
  const Place root;
  for (std::size_t c = 0; c < states_.size(); ++c) {
    const auto collection = static_cast<Collection>(c);
    if (collection == Collection::scenes) continue;
    for (std::size_t i = 0; i < states_[c].size(); ++i) {
      if (states_[c][i] != State::unused) continue;
      if (collection == Collection::lights) {
        issues.add(kUnusedObject, kLightsPointer + ('/' + std::to_string(i)));
      } else if (collection == Collection::variants) {
        issues.add(kUnusedObject, kVariantsPointer + ('/' + std::to_string(i)));
      } else {
        const Place array(root, kNames[c]);
        issues.add(kUnusedObject, Place(array, i));
      }
    }
  }
}

}  // namespace barrido::scene::validation
