// The arrays that indices of a document refer to: which of their elements exist, and which are used.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "pipeline/gltf/schema.h"
#include "pipeline/validate/json_text.h"

namespace barrido::scene::validation {

using gltf::Collection;
using gltf::Kind;
using gltf::ObjectType;
using gltf::Property;
using gltf::Schema;

class References {
 public:
  explicit References(const Json& document);

  /// Whether there is an object at that index.
  bool exists(Collection collection, std::size_t index) const;
  std::size_t size(Collection collection) const {
    return states_[static_cast<std::size_t>(collection)].size();
  }
  void use(Collection collection, std::size_t index);

  /// Reports what nothing refers to.
  void report_unused(Issues& issues) const;

 private:
  enum class State : std::uint8_t { missing, unused, used };
  void count(Collection collection, const Json& document);

  std::array<std::vector<State>, gltf::kCollections> states_;
};

}  // namespace barrido::scene::validation
