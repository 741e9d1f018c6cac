// The counts of the reference validator's "info", which counts every mesh once.
#include "pipeline/validate/report_info.h"

#include <algorithm>
#include <set>

#include "pipeline/validate/semantics.h"

namespace barrido::scene::validation {
namespace {

std::vector<std::string> different_texts(const Json& array) {
  std::vector<std::string> texts;
  std::set<std::string> seen;
  for (const Json& item : array) {
    if (seen.insert(item.get<std::string>()).second) texts.push_back(item.get<std::string>());
  }
  return texts;
}

/// Null where there is no such accessor.
const Accessor* accessor_in(const Link& link, const Json& object, const std::string& name) {
  const std::size_t index = index_of(object, name, link.model.accessors.size());
  return index == kNone ? nullptr : &link.model.accessors[index];
}

std::uint64_t triangles_of(std::size_t mode, std::uint64_t count) {
  constexpr std::size_t kTriangles = 4;
  if (mode < kTriangles) return 0;
  return mode == kTriangles ? count / 3 : count > 2 ? count - 2 : 0;
}

void count_primitive(const Link& link, const Json& primitive, ValidationInfo& info) {
  ++info.draw_calls;
  info.has_morph_targets = info.has_morph_targets || primitive.contains("targets");
  const auto attributes = primitive.find("attributes");
  std::uint64_t vertices = 0;
  if (attributes != primitive.end()) {
    const AttributeSets sets = count_attribute_sets(*attributes);
    std::size_t attribute_count = 0;
    for (const auto& [name, unused] : attributes->items()) {
      const Accessor* accessor = accessor_in(link, *attributes, name);
      if (accessor == nullptr) continue;
      if (attribute_count++ == 0) vertices = accessor->count;
    }
    info.max_attributes = std::max(info.max_attributes, attribute_count);
    info.max_uvs = std::max(info.max_uvs, sets.texcoords);
    info.max_influences = std::max(info.max_influences, sets.joints * 4);
  }
  info.vertices += vertices;
  const Accessor* indices = accessor_in(link, primitive, "indices");
  const std::uint64_t count = indices != nullptr ? indices->count : vertices;
  info.triangles += triangles_of(primitive.value("mode", std::size_t{4}), count);
}

}  // namespace

ValidationInfo info_of(const Link& link) {
  ValidationInfo info;
  const Json& asset = link.document["asset"];
  info.version = asset.value("version", std::string());
  info.min_version = asset.value("minVersion", std::string());
  info.generator = asset.value("generator", std::string());
  info.extensions_used = different_texts(link.array("extensionsUsed"));
  info.extensions_required = different_texts(link.array("extensionsRequired"));
  info.animations = link.array("animations").size();
  info.materials = link.array("materials").size();
  info.has_skins = !link.array("skins").empty();
  info.has_textures = !link.array("textures").empty();
  info.has_default_scene = index_of(link.document, "scene", link.array("scenes").size()) != kNone;
  for (const Json& mesh : link.array("meshes")) {
    if (!mesh.is_object()) continue;
    for (const Json& primitive : array_of(mesh, "primitives")) count_primitive(link, primitive, info);
  }
  return info;
}

}  // namespace barrido::scene::validation
