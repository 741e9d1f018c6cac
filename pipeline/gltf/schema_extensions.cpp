// The ratified extensions that add properties, each property as one row of a table.
#include <algorithm>

#include "pipeline/gltf/schema_parts.h"

namespace barrido::scene::gltf {
namespace {

constexpr double kHalfPi = 1.5707963267948966;
constexpr Range kUnit{0, 1};

constexpr Schema kEmpty{};
constexpr Property kWebpProperties[] = {index("source", Collection::images)};
constexpr Schema kWebp{.properties = kWebpProperties};
constexpr Property kTextureTransformProperties[] = {numbers("offset", 2), number("rotation"),
                                                    numbers("scale", 2),
                                                    drawn_from(0, kMaxInt, integer("texCoord", 0))};
constexpr Schema kTextureTransform{ObjectType::texture_transform, kTextureTransformProperties};
constexpr Property kVisibilityProperties[] = {boolean("visible")};
constexpr Schema kVisibility{.properties = kVisibilityProperties};
constexpr Property kAnimationPointerProperties[] = {required(text("pointer"))};
constexpr Schema kAnimationPointer{ObjectType::animation_pointer, kAnimationPointerProperties};

// Lights

constexpr Property kSpotProperties[] = {
    {.name = "innerConeAngle", .kind = Kind::number, .below_max = true, .range = {0, kHalfPi}},
    {.name = "outerConeAngle", .kind = Kind::number, .above_min = true, .range = {0, kHalfPi}}};
constexpr Schema kSpot{ObjectType::spot, kSpotProperties};
constexpr Property kBarridoLightProperties[] = {
    number("intensity"), fatal(numbers("attenuation", 3, {.min = 0})), fatal(number("spotExponent", 0, 1e6))};
constexpr Schema kBarridoLight{.properties = kBarridoLightProperties, .closed = true};
constexpr Property kLightProperties[] = {text("name"),
                                         fatal(required(text("type", "directional|point|spot"))),
                                         numbers("color", 3, kUnit),
                                         number("intensity", 0),
                                         positive("range"),
                                         of_type(object("spot", kSpot))};
constexpr Schema kLight{ObjectType::light, kLightProperties, &kBarridoLight};
constexpr Property kLightsProperties[] = {required(objects("lights", kLight))};
constexpr Schema kLights{.properties = kLightsProperties};
constexpr Property kNodeLightProperties[] = {required(index("light", Collection::lights))};
constexpr Schema kNodeLight{.properties = kNodeLightProperties};

// Variants of materials

constexpr Property kVariantProperties[] = {required(text("name"))};
constexpr Schema kVariant{.properties = kVariantProperties};
constexpr Property kVariantsProperties[] = {required(objects("variants", kVariant))};
constexpr Schema kVariants{.properties = kVariantsProperties};
constexpr Property kMappingProperties[] = {required(indices("variants", Collection::variants)),
                                           required(index("material", Collection::materials)), text("name")};
constexpr Schema kMapping{.properties = kMappingProperties};
constexpr Property kMappingsProperties[] = {required(objects("mappings", kMapping))};
constexpr Schema kMappings{.properties = kMappingsProperties};

// Materials

constexpr Property kAnisotropyProperties[] = {number("anisotropyStrength", 0, 1),
                                              number("anisotropyRotation"),
                                              object("anisotropyTexture", kTextureInfo)};
constexpr Schema kAnisotropy{.properties = kAnisotropyProperties};
constexpr Property kClearcoatProperties[] = {
    number("clearcoatFactor", 0, 1), object("clearcoatTexture", kTextureInfo),
    number("clearcoatRoughnessFactor", 0, 1), object("clearcoatRoughnessTexture", kTextureInfo),
    object("clearcoatNormalTexture", kNormalTexture)};
constexpr Schema kClearcoat{.properties = kClearcoatProperties};
constexpr Property kDispersionProperties[] = {number("dispersion", 0)};
constexpr Schema kDispersion{.properties = kDispersionProperties};
constexpr Property kEmissiveStrengthProperties[] = {fatal(number("emissiveStrength", 0))};
constexpr Schema kEmissiveStrength{.properties = kEmissiveStrengthProperties};
constexpr Property kIorProperties[] = {
    {.name = "ior", .kind = Kind::number, .range = {.min = 1}, .or_else = 0}};
constexpr Schema kIor{.properties = kIorProperties};
constexpr Property kIridescenceProperties[] = {number("iridescenceFactor", 0, 1),
                                               object("iridescenceTexture", kTextureInfo),
                                               number("iridescenceIor", 1),
                                               number("iridescenceThicknessMinimum", 0),
                                               number("iridescenceThicknessMaximum", 0),
                                               object("iridescenceThicknessTexture", kTextureInfo)};
constexpr Schema kIridescence{ObjectType::iridescence, kIridescenceProperties};
constexpr Property kSpecularGlossinessProperties[] = {
    numbers("diffuseFactor", 4, kUnit), object("diffuseTexture", kTextureInfo),
    numbers("specularFactor", 3, kUnit), number("glossinessFactor", 0, 1),
    object("specularGlossinessTexture", kTextureInfo)};
constexpr Schema kSpecularGlossiness{.properties = kSpecularGlossinessProperties};
constexpr Property kSheenProperties[] = {
    numbers("sheenColorFactor", 3, kUnit), object("sheenColorTexture", kTextureInfo),
    number("sheenRoughnessFactor", 0, 1), object("sheenRoughnessTexture", kTextureInfo)};
constexpr Schema kSheen{.properties = kSheenProperties};
constexpr Property kSpecularProperties[] = {
    number("specularFactor", 0, 1), object("specularTexture", kTextureInfo),
    numbers("specularColorFactor", 3, {.min = 0}), object("specularColorTexture", kTextureInfo)};
constexpr Schema kSpecular{.properties = kSpecularProperties};
constexpr Property kTransmissionProperties[] = {number("transmissionFactor", 0, 1),
                                                object("transmissionTexture", kTextureInfo)};
constexpr Schema kTransmission{.properties = kTransmissionProperties};
constexpr Property kVolumeProperties[] = {numbers("attenuationColor", 3, kUnit),
                                          positive("attenuationDistance"), number("thicknessFactor", 0),
                                          object("thicknessTexture", kTextureInfo)};
constexpr Schema kVolume{.properties = kVolumeProperties};

constexpr Extension kExtensions[] = {
    {"EXT_texture_webp"},
    {"KHR_animation_pointer"},
    {"KHR_lights_punctual"},
    {"KHR_materials_anisotropy"},
    {"KHR_materials_clearcoat"},
    {"KHR_materials_dispersion"},
    {"KHR_materials_emissive_strength"},
    {"KHR_materials_ior"},
    {"KHR_materials_iridescence"},
    {"KHR_materials_pbrSpecularGlossiness"},
    {"KHR_materials_sheen"},
    {"KHR_materials_specular"},
    {"KHR_materials_transmission"},
    {"KHR_materials_unlit"},
    {"KHR_materials_variants"},
    {"KHR_materials_volume"},
    {"KHR_mesh_quantization", true},
    {"KHR_node_visibility"},
    {"KHR_texture_transform"},
};

constexpr ExtensionObject kExtensionObjects[] = {
    {"EXT_texture_webp", ObjectType::texture, &kWebp},
    {"KHR_animation_pointer", ObjectType::channel_target, &kAnimationPointer},
    {"KHR_lights_punctual", ObjectType::document, &kLights, Drawing::form},
    {"KHR_lights_punctual", ObjectType::node, &kNodeLight, Drawing::form},
    {"KHR_materials_anisotropy", ObjectType::material, &kAnisotropy},
    {"KHR_materials_clearcoat", ObjectType::material, &kClearcoat},
    {"KHR_materials_dispersion", ObjectType::material, &kDispersion},
    {"KHR_materials_emissive_strength", ObjectType::material, &kEmissiveStrength, Drawing::form},
    {"KHR_materials_ior", ObjectType::material, &kIor},
    {"KHR_materials_iridescence", ObjectType::material, &kIridescence},
    {"KHR_materials_pbrSpecularGlossiness", ObjectType::material, &kSpecularGlossiness, Drawing::ignored,
     true},
    {"KHR_materials_sheen", ObjectType::material, &kSheen},
    {"KHR_materials_specular", ObjectType::material, &kSpecular},
    {"KHR_materials_transmission", ObjectType::material, &kTransmission},
    {"KHR_materials_unlit", ObjectType::material, &kEmpty, Drawing::form, true},
    {"KHR_materials_variants", ObjectType::document, &kVariants},
    {"KHR_materials_variants", ObjectType::primitive, &kMappings},
    {"KHR_materials_volume", ObjectType::material, &kVolume},
    {"KHR_node_visibility", ObjectType::node, &kVisibility},
    {"KHR_texture_transform", ObjectType::texture_info, &kTextureTransform, Drawing::form},
    {"KHR_texture_transform", ObjectType::normal_texture_info, &kTextureTransform, Drawing::form},
    {"KHR_texture_transform", ObjectType::occlusion_texture_info, &kTextureTransform, Drawing::form},
};

}  // namespace

std::span<const ExtensionObject> extension_objects() { return kExtensionObjects; }

const Extension* find_extension(std::string_view name) {
  const auto found = std::find_if(std::begin(kExtensions), std::end(kExtensions),
                                  [&](const Extension& known) { return known.name == name; });
  return found == std::end(kExtensions) ? nullptr : found;
}

const ExtensionObject* find_extension_object(std::string_view name, ObjectType type) {
  const auto found =
      std::find_if(std::begin(kExtensionObjects), std::end(kExtensionObjects),
                   [&](const ExtensionObject& known) { return known.name == name && known.type == type; });
  return found == std::end(kExtensionObjects) ? nullptr : found;
}

}  // namespace barrido::scene::gltf
