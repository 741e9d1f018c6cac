// Materials, lights, meshes and nodes.
#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/validate/semantics.h"
#include "pipeline/validate/value_checks.h"

namespace barrido::scene::validation {
namespace {

/// The extension's object of a material; null where there is none.
const Json* extension_of(const Json& object, const char* name) {
  const auto extensions = object.find("extensions");
  if (extensions == object.end()) return nullptr;
  const auto found = extensions->find(name);
  return found == extensions->end() ? nullptr : &*found;
}

/// A texture of its own that is to use the coordinates of the material's normal texture.
void check_same_texcoord(SchemaWalk& walk, const Json& material, const char* extension_name,
                         const char* texture_name, const Code& code, const Place& extensions_place) {
  const Json* extension = extension_of(material, extension_name);
  const auto normal = material.find("normalTexture");
  if (extension == nullptr || normal == material.end() || !extension->contains(texture_name)) return;
  if (extension->at(texture_name).value("texCoord", 0u) == normal->value("texCoord", 0u)) return;
  const Place extension_place(extensions_place, extension_name);
  walk.issues().add(code, Place(extension_place, texture_name));
}

void check_volume(SchemaWalk& walk, const Json& material, const Place& place) {
  const Json* volume = extension_of(material, "KHR_materials_volume");
  if (volume == nullptr) return;
  // An extension that is not known may let light through.
  bool lets_light_through = extension_of(material, "KHR_materials_transmission") != nullptr;
  for (const auto& [name, unused] : material["extensions"].items()) {
    lets_light_through = lets_light_through || !walk.has_extension(name);
  }
  if (!lets_light_through) walk.issues().add(kVolumeNoTransmission, place);
  if (material.value("doubleSided", false) && volume->value("thicknessFactor", 0.0) > 0) {
    walk.issues().add(kVolumeDoubleSided, place);
  }
}

bool is_black(const Json& material) {
  const auto factor = material.find("emissiveFactor");
  return factor == material.end() || std::all_of(factor->begin(), factor->end(), [](const Json& component) {
           return component.get<double>() == 0;
         });
}

double length(const Json& vector) {
  double sum = 0;
  for (const Json& component : vector) sum += component.get<double>() * component.get<double>();
  return std::sqrt(sum);
}

/// Columns of the upper 3×3 part, which must be at right angles, of a length, and over a last row 0 0 0 1.
bool is_trs(const std::array<double, 16>& m) {
  if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) return false;
  constexpr double kMaxCosine = 1e-3;
  const auto dot = [&](std::size_t a, std::size_t b) {
    return m[4 * a] * m[4 * b] + m[4 * a + 1] * m[4 * b + 1] + m[4 * a + 2] * m[4 * b + 2];
  };
  for (std::size_t a = 0; a < 3; ++a) {
    if (dot(a, a) == 0) return false;
    for (std::size_t b = 0; b < a; ++b) {
      if (std::abs(dot(a, b)) > kMaxCosine * std::sqrt(dot(a, a)) * std::sqrt(dot(b, b))) return false;
    }
  }
  return true;
}

bool is_identity(const std::array<double, 16>& m) {
  for (std::size_t i = 0; i < 16; ++i) {
    if (m[i] != (i % 5 == 0 ? 1 : 0)) return false;
  }
  return true;
}

}  // namespace

void note_texture_info(SchemaWalk& walk, Json& info, const Place& place) {
  if (walk.material() == nullptr) return;
  walk.material()->texcoords.emplace_back(place.pointer(), info.value("texCoord", std::size_t{0}));
}

void note_normal_texture_info(SchemaWalk& walk, Json& info, const Place& place) {
  note_texture_info(walk, info, place);
  if (walk.material() != nullptr) walk.material()->tangents = true;
}

void note_texture_transform(SchemaWalk& walk, Json& transform, const Place& place) {
  if (transform.contains("texCoord")) note_texture_info(walk, transform, place);
}

void check_material_values(SchemaWalk& walk, Json& material, const Place& place) {
  if (material.contains("alphaCutoff") && material.value("alphaMode", std::string("OPAQUE")) != "MASK") {
    walk.issues().add(kMaterialAlphaCutoffInvalidMode, Place(place, "alphaCutoff"));
  }
  if (!material.contains("extensions")) return;
  const Place extensions_place(place, "extensions");
  const Json* anisotropy = extension_of(material, "KHR_materials_anisotropy");
  if (anisotropy != nullptr && anisotropy->contains("anisotropyTexture")) walk.material()->tangents = true;
  check_same_texcoord(walk, material, "KHR_materials_anisotropy", "anisotropyTexture",
                      kAnisotropyTextureTexcoord, extensions_place);
  check_same_texcoord(walk, material, "KHR_materials_clearcoat", "clearcoatNormalTexture",
                      kClearcoatNormalTextureTexcoord, extensions_place);
  check_volume(walk, material, Place(extensions_place, "KHR_materials_volume"));
  if (extension_of(material, "KHR_materials_dispersion") != nullptr &&
      extension_of(material, "KHR_materials_volume") == nullptr) {
    walk.issues().add(kDispersionNoVolume, Place(extensions_place, "KHR_materials_dispersion"));
  }
  const Json* strength = extension_of(material, "KHR_materials_emissive_strength");
  if (strength != nullptr && strength->value("emissiveStrength", 1.0) != 1.0 && is_black(material)) {
    walk.issues().add(kEmissiveStrengthZeroFactor,
                      Place(extensions_place, "KHR_materials_emissive_strength"));
  }
}

void check_iridescence_values(SchemaWalk& walk, Json& iridescence, const Place& place) {
  constexpr double kDefaultMinimum = 100, kDefaultMaximum = 400;
  if (!iridescence.contains("iridescenceThicknessTexture")) {
    if (!iridescence.contains("iridescenceThicknessMinimum")) return;
    walk.issues().add(kIridescenceThicknessRangeWithoutTexture, Place(place, "iridescenceThicknessMinimum"));
  } else if (iridescence.value("iridescenceThicknessMinimum", kDefaultMinimum) ==
             iridescence.value("iridescenceThicknessMaximum", kDefaultMaximum)) {
    walk.issues().add(kIridescenceThicknessTextureUnused, Place(place, "iridescenceThicknessTexture"));
  }
}

void check_light_values(SchemaWalk& walk, Json& light, const Place& place) {
  const std::string type = light.value("type", std::string());
  if (type != "spot" && light.contains("spot")) walk.issues().add(kExtraProperty, Place(place, "spot"));
  if (type == "directional" && light.contains("range"))
    walk.issues().add(kExtraProperty, Place(place, "range"));
}

void check_spot_values(SchemaWalk& walk, Json& spot, const Place& place) {
  constexpr double kDefaultInner = 0, kDefaultOuter = 0.7853981633974483;
  const double inner = spot.value("innerConeAngle", kDefaultInner);
  const double outer = spot.value("outerConeAngle", kDefaultOuter);
  if (outer > inner) return;
  walk.issues().add(kLightSpotAngles, Place(place, "outerConeAngle"), {shown(inner), shown(outer)});
}

void check_mesh_values(SchemaWalk& walk, Json& mesh, const Place& place) {
  const auto primitives = mesh.find("primitives");
  if (primitives == mesh.end()) return;
  const auto targets_of = [&](std::size_t i) { return count_of((*primitives)[i], "targets"); };
  const Place primitives_place(place, "primitives");
  for (std::size_t i = 1; i < primitives->size(); ++i) {
    if (targets_of(i) == targets_of(0)) continue;
    const Place primitive_place(primitives_place, i);
    walk.issues().add(kMeshPrimitivesUnequalTargetsCount,
                      targets_of(i) > 0 ? Place(primitive_place, "targets") : primitive_place);
  }
  const std::size_t weights = count_of(mesh, "weights");
  if (weights == 0 || weights == targets_of(0)) return;
  walk.issues().add(kMeshInvalidWeightsCount, Place(place, "weights"),
                    {std::to_string(weights), std::to_string(targets_of(0))});
}

void check_primitive_values(SchemaWalk& walk, Json& primitive, const Place& place) {
  const auto attributes = primitive.find("attributes");
  if (attributes != primitive.end())
    check_attribute_names(walk.issues(), *attributes, Place(place, "attributes"));
  const auto targets = primitive.find("targets");
  if (targets == primitive.end()) return;
  const Place targets_place(place, "targets");
  for (std::size_t i = 0; i < targets->size(); ++i) {
    check_target_names(walk.issues(), (*targets)[i], Place(targets_place, i));
  }
}

void check_node_values(SchemaWalk& walk, Json& node, const Place& place) {
  Issues& issues = walk.issues();
  constexpr double kUnitThreshold =
      0.00769;  // The reference validator's, for quaternions of 8-bit components.
  if (node.contains("rotation") && std::abs(length(node["rotation"]) - 1) > kUnitThreshold) {
    issues.add(kRotationNonUnit, Place(place, "rotation"), {shown(length(node["rotation"]))});
  }
  if (!node.contains("mesh")) {
    for (const char* name : {"skin", "weights"}) {
      if (node.contains(name)) issues.add(kUnsatisfiedDependency, Place(place, name), {"mesh"});
    }
  }
  if (!node.contains("matrix")) return;
  const Place matrix_place(place, "matrix");
  if (node.contains("translation") || node.contains("rotation") || node.contains("scale")) {
    issues.add(kNodeMatrixTrs, matrix_place);
  }
  const auto matrix = node["matrix"].get<std::array<double, 16>>();
  if (is_identity(matrix)) {
    issues.add(kNodeMatrixDefault, matrix_place);
  } else if (!is_trs(matrix)) {
    issues.add(kNodeMatrixNonTrs, matrix_place);
  }
}

}  // namespace barrido::scene::validation
