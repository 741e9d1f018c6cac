#include "pipeline/gltf/stand_ins.h"

#include "pipeline/gltf/json_values.h"

namespace barrido::scene::gltf {
namespace {

using nlohmann::json;

const json& array_of(const json& object, std::string_view name) {
  static const json kNone = json::array();
  const auto found = object.is_object() ? object.find(name) : object.end();
  return found != object.end() && found->is_array() ? *found : kNone;
}

/// Every number that is called "index", at any depth: textures are named so by whoever uses them.
void find_indices(const json& value, std::vector<std::uint64_t>& indices) {
  if (const auto index = whole_number(value, "index")) indices.push_back(*index);
  if (!value.is_structured()) return;
  for (const json& part : value) find_indices(part, indices);
}

}  // namespace

StandIns::StandIns(const json& document) {
  for (const char* array : {"nodes", "meshes", "skins", "materials", "textures", "cameras"}) {
    used_[array].resize(array_of(document, array).size());
  }
  has_nodes_ = !used_["nodes"].empty();
  use_nodes(document);
  use_what_nodes_use(document);
  const json& meshes = array_of(document, "meshes");
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (used_["meshes"][i]) use_materials(meshes[i]);
  }
  const json& materials = array_of(document, "materials");
  std::vector<std::uint64_t> textures;
  for (std::size_t i = 0; i < materials.size(); ++i) {
    if (used_["materials"][i]) find_indices(materials[i], textures);
  }
  for (const std::uint64_t texture : textures) {
    if (texture < used_["textures"].size()) used_["textures"][static_cast<std::size_t>(texture)] = true;
  }
}

/// All below the roots of any scene; without scenes all there are.
void StandIns::use_nodes(const json& document) {
  const json& nodes = array_of(document, "nodes");
  std::vector<bool>& used = used_["nodes"];
  std::vector<std::uint64_t> waiting;
  const auto add = [&](const json& list) {
    for (const json& number : list) {
      if (number.is_number_unsigned()) waiting.push_back(number.get<std::uint64_t>());
    }
  };
  if (array_of(document, "scenes").empty()) used.assign(used.size(), true);
  for (const json& scene : array_of(document, "scenes")) add(array_of(scene, "nodes"));
  for (const json& skin : array_of(document, "skins")) add(array_of(skin, "joints"));
  while (!waiting.empty()) {
    const auto node = static_cast<std::size_t>(waiting.back());
    waiting.pop_back();
    if (node >= nodes.size() || used[node]) continue;
    used[node] = true;
    add(array_of(nodes[node], "children"));
  }
}

void StandIns::use_what_nodes_use(const json& document) {
  const json& nodes = array_of(document, "nodes");
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!used_["nodes"][i]) continue;
    use("meshes", nodes[i], "mesh");
    use("skins", nodes[i], "skin");
    use("cameras", nodes[i], "camera");
  }
}

void StandIns::use_materials(const json& mesh) {
  for (const json& primitive : array_of(mesh, "primitives")) {
    use("materials", primitive, "material");
    const json::json_pointer variants("/extensions/KHR_materials_variants");
    if (!primitive.is_object() || !primitive.contains(variants)) continue;
    for (const json& mapping : array_of(primitive[variants], "mappings"))
      use("materials", mapping, "material");
  }
}

void StandIns::use(std::string_view array, const json& object, const char* name) {
  const auto index = whole_number(object, name);
  if (index && *index < used_[array].size()) used_[array][static_cast<std::size_t>(*index)] = true;
}

bool StandIns::is_used(std::string_view array, std::size_t index) const {
  const auto found = used_.find(array);
  return found == used_.end() || index >= found->second.size() || found->second[index];
}

std::optional<json> StandIns::find(std::string_view array, std::size_t index) const {
  if (array == "animations") return json{{"samplers", json::array()}, {"channels", json::array()}};
  if (is_used(array, index)) return std::nullopt;
  if (array == "meshes") return json{{"primitives", {{{"attributes", json::object()}}}}};
  if (array == "cameras") return json{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}};
  if (array == "skins" && !has_nodes_) return std::nullopt;
  if (array == "skins") return json{{"joints", {0}}};
  return json::object();
}

}  // namespace barrido::scene::gltf
