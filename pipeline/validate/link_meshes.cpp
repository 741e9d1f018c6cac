// Primitives with their accessors, materials and morph targets (glTF 2.0, section 3.7.2).
#include <algorithm>
#include <map>
#include <set>

#include "pipeline/validate/link.h"
#include "pipeline/validate/semantics.h"

namespace barrido::scene::validation {
namespace {

/// A format of a semantic; those of KHR_mesh_quantization only with it.
struct AttributeFormat {
  std::string_view semantic;
  Format format;
  bool in_primitives, in_targets, is_quantized;
};

// Semantic, format, allowed in primitives, in morph targets, and only with the extension.
constexpr AttributeFormat kAttributeFormats[] = {
    {"POSITION", {"VEC3", kFloat, false}, true, true, false},
    {"POSITION", {"VEC3", kByte, false}, true, true, true},
    {"POSITION", {"VEC3", kByte, true}, true, true, true},
    {"POSITION", {"VEC3", kUnsignedByte, false}, true, false, true},
    {"POSITION", {"VEC3", kUnsignedByte, true}, true, false, true},
    {"POSITION", {"VEC3", kShort, false}, true, true, true},
    {"POSITION", {"VEC3", kShort, true}, true, true, true},
    {"POSITION", {"VEC3", kUnsignedShort, false}, true, false, true},
    {"POSITION", {"VEC3", kUnsignedShort, true}, true, false, true},
    {"NORMAL", {"VEC3", kFloat, false}, true, true, false},
    {"NORMAL", {"VEC3", kByte, true}, true, true, true},
    {"NORMAL", {"VEC3", kShort, true}, true, true, true},
    {"TANGENT", {"VEC4", kFloat, false}, true, false, false},
    {"TANGENT", {"VEC4", kByte, true}, true, false, true},
    {"TANGENT", {"VEC4", kShort, true}, true, false, true},
    {"TANGENT", {"VEC3", kFloat, false}, false, true, false},
    {"TANGENT", {"VEC3", kByte, true}, false, true, true},
    {"TANGENT", {"VEC3", kShort, true}, false, true, true},
    {"TEXCOORD", {"VEC2", kFloat, false}, true, true, false},
    {"TEXCOORD", {"VEC2", kUnsignedByte, true}, true, true, false},
    {"TEXCOORD", {"VEC2", kUnsignedShort, true}, true, true, false},
    {"TEXCOORD", {"VEC2", kByte, true}, false, true, false},
    {"TEXCOORD", {"VEC2", kShort, true}, false, true, false},
    {"TEXCOORD", {"VEC2", kByte, true}, true, false, true},
    {"TEXCOORD", {"VEC2", kShort, true}, true, false, true},
    {"TEXCOORD", {"VEC2", kByte, false}, true, true, true},
    {"TEXCOORD", {"VEC2", kUnsignedByte, false}, true, false, true},
    {"TEXCOORD", {"VEC2", kShort, false}, true, true, true},
    {"TEXCOORD", {"VEC2", kUnsignedShort, false}, true, false, true},
    {"COLOR", {"VEC3", kFloat, false}, true, true, false},
    {"COLOR", {"VEC3", kUnsignedByte, true}, true, true, false},
    {"COLOR", {"VEC3", kUnsignedShort, true}, true, true, false},
    {"COLOR", {"VEC3", kByte, true}, false, true, false},
    {"COLOR", {"VEC3", kShort, true}, false, true, false},
    {"COLOR", {"VEC4", kFloat, false}, true, true, false},
    {"COLOR", {"VEC4", kUnsignedByte, true}, true, true, false},
    {"COLOR", {"VEC4", kUnsignedShort, true}, true, true, false},
    {"COLOR", {"VEC4", kByte, true}, false, true, false},
    {"COLOR", {"VEC4", kShort, true}, false, true, false},
    {"JOINTS", {"VEC4", kUnsignedByte, false}, true, false, false},
    {"JOINTS", {"VEC4", kUnsignedShort, false}, true, false, false},
    {"WEIGHTS", {"VEC4", kFloat, false}, true, false, false},
    {"WEIGHTS", {"VEC4", kUnsignedByte, true}, true, false, false},
    {"WEIGHTS", {"VEC4", kUnsignedShort, true}, true, false, false},
};

constexpr Format kIndexFormats[] = {
    {"SCALAR", kUnsignedByte}, {"SCALAR", kUnsignedShort}, {"SCALAR", kUnsignedInt}};

constexpr std::string_view kModes[] = {"points",    "lines",           "line loops",   "line strips",
                                       "triangles", "triangle strips", "triangle fans"};
enum Mode : std::size_t { kPoints, kLines, kLineLoop, kLineStrip, kTriangles, kTriangleStrip, kTriangleFan };

class PrimitiveLink {
 public:
  PrimitiveLink(Link& link, std::map<std::size_t, std::set<std::size_t>>& packed_views, const Json& primitive,
                const Place& place)
      : link_(link), packed_views_(packed_views), primitive_(primitive), place_(place) {}

  void run() {
    const Json& attributes = object_in(primitive_, "attributes");
    sets_ = count_attribute_sets(attributes);
    texcoord_used_.resize(sets_.texcoords);
    const Place attributes_place(place_, "attributes");
    for_each_in_order(attributes, attributes_place, [&](const std::string& name, const Json& index) {
      link_attribute(name, index, Place(attributes_place, name));
    });
    link_indices(Place(place_, "indices"));
    check_mode();
    link_material(attributes, attributes_place);
    link_variants();
    for (std::size_t i = 0; i < texcoord_used_.size(); ++i) {
      const std::string name = "TEXCOORD_" + std::to_string(i);
      if (!texcoord_used_[i]) link_.issues.add(kUnusedObject, Place(attributes_place, name));
    }
    link_targets(attributes);
  }

 private:
  static const Json& object_in(const Json& object, const char* name) {
    static const Json kEmpty = Json::object();
    const auto found = object.find(name);
    return found == object.end() ? kEmpty : *found;
  }

  /// In the order of the file: the first attribute tells how many vertices there are.
  template <typename Visit>
  void for_each_in_order(const Json& attributes, const Place& place, Visit visit) const {
    const auto names = link_.attribute_names.find(place.pointer());
    if (names == link_.attribute_names.end()) return;
    for (const std::string& name : names->second) {
      const auto found = attributes.find(name);
      if (found != attributes.end()) visit(name, *found);
    }
  }

  /// Null where there is no such accessor.
  const Accessor* accessor(const Json& index) const {
    if (!index.is_number_unsigned() && index.get<std::int64_t>() < 0) return nullptr;
    const auto i = index.get<std::size_t>();
    return link_.references.exists(Collection::accessors, i) ? &link_.model.accessors[i] : nullptr;
  }

  void check_format(const Accessor& accessor, std::string_view name, bool in_target, const Place& place) {
    std::vector<Format> formats;
    const bool quantized = link_.schema.has_extension("KHR_mesh_quantization");
    for (const AttributeFormat& candidate : kAttributeFormats) {
      const bool fits = candidate.semantic == semantic_of(name) && (quantized || !candidate.is_quantized) &&
                        (in_target ? candidate.in_targets : candidate.in_primitives);
      if (fits) formats.push_back(candidate.format);
    }
    if (formats.empty()) {
      if (accessor.component_type == kUnsignedInt && !in_target) {
        link_.issues.add(kMeshPrimitiveAttributesAccessorUnsignedInt, place);
      }
    } else if (!is_one_of(accessor, formats)) {
      link_.issues.add(kMeshPrimitiveAttributesAccessorInvalidFormat, place,
                       {accessor.format(), list_of(formats)});
    } else if (!in_target) {
      schedule(name, accessor, place);
    }
  }

  void schedule(std::string_view name, const Accessor& accessor, const Place& place) {
    using Kind = DataCheck::Kind;
    const auto index = static_cast<std::size_t>(&accessor - link_.model.accessors.data());
    if (name == "NORMAL") link_.data_checks.push_back({Kind::unit_vectors, index, place.pointer()});
    if (name == "TANGENT") link_.data_checks.push_back({Kind::unit_vectors_and_sign, index, place.pointer()});
    if (name == "COLOR_0" && accessor.component_type == kFloat) {
      link_.data_checks.push_back({Kind::clamped, index, place.pointer()});
    }
  }

  /// What holds for attributes and morph targets alike.
  void link_vertices(const Accessor& accessor, std::string_view name, bool in_target, const Place& place) {
    const auto index = static_cast<std::size_t>(&accessor - link_.model.accessors.data());
    link_.use_accessor(index, AccessorUsage::vertex_attribute, place);
    link_.use_view(accessor.view, ViewUsage::vertices, place);
    if (name == "POSITION" && (accessor.min.empty() || accessor.max.empty())) {
      link_.issues.add(kMeshPrimitivePositionAccessorWithoutBounds, place);
    }
    check_format(accessor, name, in_target, place);
    const bool is_packed = accessor.view != kNone && link_.model.views[accessor.view].stride == 0;
    const bool is_odd = accessor.is_complete() && accessor.element_bytes() % 4 != 0;
    if (accessor.offset % 4 != 0 || (is_odd && is_packed)) {
      link_.issues.add(kMeshPrimitiveAccessorUnaligned, place);
    }
    if (!is_packed) return;
    std::set<std::size_t>& sharers = packed_views_[accessor.view];
    if (sharers.insert(index).second && sharers.size() > 1) {
      link_.issues.add(kMeshPrimitiveAccessorWithoutBytestride, place);
    }
  }

  void link_attribute(std::string_view name, const Json& index, const Place& place) {
    const Accessor* source = accessor(index);
    if (source == nullptr) return;
    link_vertices(*source, name, false, place);
    if (vertices_ == 0) {
      vertices_ = source->count;
    } else if (vertices_ != source->count) {
      link_.issues.add(kMeshPrimitiveUnequalAccessorCount, place);
    }
    count_ = vertices_;
  }

  std::size_t mode() const { return primitive_.value("mode", std::size_t{kTriangles}); }

  void link_indices(const Place& place) {
    const auto found = primitive_.find("indices");
    const Accessor* source = found == primitive_.end() ? nullptr : accessor(*found);
    if (source == nullptr) return;
    const auto index = found->get<std::size_t>();
    count_ = source->count;
    link_.use_accessor(index, AccessorUsage::primitive_indices, place);
    link_.use_view(source->view, ViewUsage::indices, place);
    if (source->view != kNone && link_.model.views[source->view].stride != 0) {
      link_.issues.add(kMeshPrimitiveIndicesAccessorWithBytestride, place);
    }
    if (!is_one_of(*source, kIndexFormats)) {
      link_.issues.add(kMeshPrimitiveIndicesAccessorInvalidFormat, place,
                       {source->format(), list_of(kIndexFormats)});
    } else {
      link_.data_checks.push_back(
          {DataCheck::Kind::indices, index, place.pointer(), vertices_, mode() == kTriangles});
    }
  }

  void check_mode() {
    const bool fits = mode() == kLines                                     ? count_ % 2 == 0
                      : mode() == kLineLoop || mode() == kLineStrip        ? count_ >= 2
                      : mode() == kTriangles                               ? count_ % 3 == 0
                      : mode() == kTriangleStrip || mode() == kTriangleFan ? count_ >= 3
                                                                           : true;
    if (fits || count_ == 0) return;
    link_.issues.add(kMeshPrimitiveIncompatibleMode, place_,
                     {std::to_string(count_), std::string(kModes[mode()])});
  }

  void need_texcoords(std::size_t material, const Place& place) {
    for (const auto& [pointer, set] : link_.materials[material].texcoords) {
      if (set < texcoord_used_.size()) {
        texcoord_used_[set] = true;
      } else {
        link_.issues.add(kMeshPrimitiveTooFewTexcoords, place, {pointer, std::to_string(set)});
      }
    }
  }

  void link_material(const Json& attributes, const Place& attributes_place) {
    const std::size_t material = index_of(primitive_, "material", link_.materials.size());
    const Place place(place_, "material");
    const bool needs_tangents = material != kNone && link_.materials[material].tangents;
    if (needs_tangents && !(attributes.contains("NORMAL") && attributes.contains("TANGENT"))) {
      const bool has_normal_texture = link_.array("materials")[material].contains("normalTexture");
      link_.issues.add(
          has_normal_texture ? kMeshPrimitiveGeneratedTangentSpace : kMeshPrimitiveNoTangentSpace, place);
    }
    if (material != kNone) need_texcoords(material, place);
    if (attributes.contains("TANGENT") && !needs_tangents) {
      link_.issues.add(kUnusedMeshTangent, Place(attributes_place, "TANGENT"));
    }
  }

  /// KHR_materials_variants: other materials for the same primitive.
  void link_variants() {
    const Json& extension = object_in(object_in(primitive_, "extensions"), "KHR_materials_variants");
    const Json& mappings = array_of(extension, "mappings");
    if (!link_.schema.has_extension("KHR_materials_variants")) return;
    const Place extensions_place(place_, "extensions"),
        extension_place(extensions_place, "KHR_materials_variants");
    const Place mappings_place(extension_place, "mappings");
    std::set<std::size_t> seen;
    for (std::size_t i = 0; i < mappings.size(); ++i) {
      const Place mapping_place(mappings_place, i), variants_place(mapping_place, "variants");
      const Json& variants = array_of(mappings[i], "variants");
      for (std::size_t v = 0; v < variants.size(); ++v) {
        if (!variants[v].is_number_unsigned() && variants[v].get<std::int64_t>() < 0) continue;
        if (seen.insert(variants[v].get<std::size_t>()).second) continue;
        link_.issues.add(kVariantsNonUniqueVariant, Place(variants_place, v));
      }
      const std::size_t material = index_of(mappings[i], "material", link_.materials.size());
      if (material != kNone) need_texcoords(material, Place(mapping_place, "material"));
    }
  }

  void link_targets(const Json& attributes) {
    const Json& targets = array_of(primitive_, "targets");
    const Place targets_place(place_, "targets");
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const Place target_place(targets_place, i);
      for_each_in_order(targets[i], target_place, [&](const std::string& name, const Json& index) {
        const Accessor* source = accessor(index);
        if (source == nullptr) return;
        const Place place(target_place, name);
        link_vertices(*source, name, true, place);
        const auto base_index = attributes.find(name);
        const Accessor* base = base_index == attributes.end() ? nullptr : accessor(*base_index);
        if (base == nullptr) {
          link_.issues.add(kMeshPrimitiveMorphTargetNoBaseAccessor, place);
        } else if (base->count != source->count) {
          link_.issues.add(kMeshPrimitiveMorphTargetInvalidAttributeCount, place,
                           {std::to_string(source->count), std::to_string(base->count)});
        }
      });
    }
  }

  Link& link_;
  std::map<std::size_t, std::set<std::size_t>>& packed_views_;  ///< Accessors by view without a stride.
  const Json& primitive_;
  const Place& place_;
  AttributeSets sets_;
  std::uint64_t vertices_ = 0;
  std::uint64_t count_ = 0;  ///< Indices, or vertices where there are none.
  std::vector<bool> texcoord_used_;
};

}  // namespace

void link_meshes(Link& link) {
  std::map<std::size_t, std::set<std::size_t>> packed_views;
  const Json& meshes = link.array("meshes");
  const Place root, meshes_place(root, "meshes");
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    if (!meshes[m].is_object()) continue;
    const Json& primitives = array_of(meshes[m], "primitives");
    const Place mesh_place(meshes_place, m), primitives_place(mesh_place, "primitives");
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const Place place(primitives_place, p);
      PrimitiveLink(link, packed_views, primitives[p], place).run();
    }
  }
}

}  // namespace barrido::scene::validation
