// KHR_materials_variants: the names of the variants, and the material of each primitive in each.
#include "pipeline/gltf/import_parts.h"
#include "pipeline/gltf/values.h"

namespace barrido::scene::gltf {
namespace {

constexpr const char* kName = "KHR_materials_variants";

/// A whole number in [0, size). @throws InputError.
int index_in(const Import& import, const tinygltf::Value& value, std::size_t size, const std::string& place) {
  const int index = whole_number(value);
  if (index < 0 || static_cast<std::size_t>(index) >= size) {
    import.report.fail(place, "must be a number from 0, and below " + std::to_string(size));
  }
  return index;
}

}  // namespace

void import_variants(Import& import) {
  const tinygltf::Model& model = import.document.model();
  const tinygltf::Value& variants = member(member(model.extensions, kName), "variants");
  for (std::size_t i = 0; i < variants.ArrayLen(); ++i) {
    const tinygltf::Value& name = member(item(variants, i), "name");
    import.scene.variants.push_back(name.IsString() ? one_line(name.Get<std::string>(), 80) : std::string());
  }
}

std::map<int, int> variant_materials_of(const Import& import, const tinygltf::Primitive& source,
                                        const std::string& primitive_place) {
  std::map<int, int> materials;
  const tinygltf::Value& mappings = member(member(source.extensions, kName), "mappings");
  for (std::size_t i = 0; i < mappings.ArrayLen(); ++i) {
    const std::string place = primitive_place + ".extensions." + kName + '.' + element("mappings", i);
    const tinygltf::Value& mapping = item(mappings, i);
    const int material =
        index_in(import, member(mapping, "material"), import.scene.materials.size(), place + ".material");
    const tinygltf::Value& variants = member(mapping, "variants");
    for (std::size_t v = 0; v < variants.ArrayLen(); ++v) {
      const int variant =
          index_in(import, item(variants, v), import.scene.variants.size(), place + ".variants");
      materials.emplace(variant, material);
    }
  }
  return materials;
}

}  // namespace barrido::scene::gltf
