// Elements counted before the walk begins, since references may lead forwards.
#include "pipeline/validate/references.h"

#include <algorithm>

namespace barrido::scene::validation {

References::References(const Json& document) {
  for (std::size_t i = 0; i < states_.size(); ++i) count(static_cast<Collection>(i), document);
}

void References::count(Collection collection, const Json& document) {
  const Json::json_pointer pointer(gltf::pointer_to(collection));
  if (!document.contains(pointer)) return;
  const Json& array = document[pointer];
  if (!array.is_array()) return;
  auto& states = states_[static_cast<std::size_t>(collection)];
  for (const Json& item : array) states.push_back(item.is_object() ? State::unused : State::missing);
  const bool all_or_none = collection == Collection::lights || collection == Collection::variants;
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
  for (std::size_t c = 0; c < states_.size(); ++c) {
    const auto collection = static_cast<Collection>(c);
    if (collection == Collection::scenes) continue;
    for (std::size_t i = 0; i < states_[c].size(); ++i) {
      if (states_[c][i] != State::unused) continue;
      issues.add(kUnusedObject, gltf::pointer_to(collection) + '/' + std::to_string(i));
    }
  }
}

}  // namespace barrido::scene::validation
