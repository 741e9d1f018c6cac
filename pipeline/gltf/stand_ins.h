// What stands in the place of an element that is broken and that nothing drawn uses. Knows nothing of
// schemas: it looks into documents that may be broken everywhere.
#pragma once

#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace barrido::scene::gltf {

class StandIns {
 public:
  explicit StandIns(const nlohmann::json& document);

  /// An element that is whole and does nothing, for element `index` of the document's array; none where that
  /// may be drawn, or of arrays that have none. Animations are used by nobody who does not ask for them.
  std::optional<nlohmann::json> find(std::string_view array, std::size_t index) const;

 private:
  void use_nodes(const nlohmann::json& document);
  void use_what_nodes_use(const nlohmann::json& document);
  void use_materials(const nlohmann::json& mesh);
  void use(std::string_view array, const nlohmann::json& object, const char* name);
  bool is_used(std::string_view array, std::size_t index) const;

  std::map<std::string_view, std::vector<bool>> used_;
  bool has_nodes_ = false;
};

}  // namespace barrido::scene::gltf
