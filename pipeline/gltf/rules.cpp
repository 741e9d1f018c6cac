// glTF 2.0's properties (section 5 of the specification), those of the extensions that are supported, and
// those of extras.barrido (docs/barrido-extras.schema.json), each as one line of a table.
#include "pipeline/gltf/rules.h"

namespace barrido::scene::gltf {
namespace {

constexpr double kMaxBytes = 9007199254740992.0;  // 2^53: every integer below is exact in JSON.
constexpr double kMaxInt = 2147483647.0;

constexpr PropertyRule boolean(std::string_view name) { return {.name = name, .kind = ValueKind::boolean}; }
constexpr PropertyRule integer(std::string_view name, double min, double max) {
  return {.name = name, .kind = ValueKind::integer, .min = min, .max = max};
}
constexpr PropertyRule stride(std::string_view name) {
  return {.name = name, .kind = ValueKind::integer, .min = 0, .max = 252, .multiple_of = 4};
}
constexpr PropertyRule number(std::string_view name) { return {.name = name, .kind = ValueKind::number}; }
constexpr PropertyRule number(std::string_view name, double min, double max) {
  return {.name = name, .kind = ValueKind::number, .min = min, .max = max};
}
constexpr PropertyRule positive(std::string_view name) {
  return {.name = name, .kind = ValueKind::number, .positive = true, .min = 0};
}
constexpr PropertyRule text(std::string_view name, std::string_view choices = {}) {
  return {.name = name, .kind = ValueKind::text, .choices = choices};
}
constexpr PropertyRule texts(std::string_view name) { return {.name = name, .kind = ValueKind::texts}; }
constexpr PropertyRule index(std::string_view name, Target target) {
  return {.name = name, .kind = ValueKind::index, .target = target};
}
constexpr PropertyRule indices(std::string_view name, Target target) {
  return {.name = name, .kind = ValueKind::indices, .target = target};
}
constexpr PropertyRule numbers(std::string_view name, std::size_t min_items, std::size_t max_items) {
  return {.name = name, .kind = ValueKind::numbers, .min_items = min_items, .max_items = max_items};
}
constexpr PropertyRule numbers(std::string_view name, std::size_t items) {
  return numbers(name, items, items);
}
constexpr PropertyRule object(std::string_view name, const ObjectRule& rule) {
  return {.name = name, .kind = ValueKind::object, .object = &rule};
}
constexpr PropertyRule objects(std::string_view name, const ObjectRule& rule) {
  return {.name = name, .kind = ValueKind::objects, .object = &rule};
}
constexpr PropertyRule extras(const ObjectRule& rule) {
  return {.name = "extras", .kind = ValueKind::free_object, .object = &rule};
}
constexpr PropertyRule required(PropertyRule rule) {
  rule.required = true;
  return rule;
}
constexpr PropertyRule at_least(PropertyRule rule, double min) {
  rule.min = min;
  return rule;
}

// extras.barrido

constexpr PropertyRule kBarridoMaterialProperties[] = {
    at_least(numbers("ambient", 3), 0), at_least(numbers("diffuse", 3), 0),
    at_least(numbers("specular", 3), 0), at_least(numbers("emission", 3), 0), number("shininess", 0, 1e6)};
constexpr ObjectRule kBarridoMaterial{kBarridoMaterialProperties, true};
constexpr PropertyRule kBarridoLightProperties[] = {
    number("intensity"), at_least(numbers("attenuation", 3), 0), number("spotExponent", 0, 1e6)};
constexpr ObjectRule kBarridoLight{kBarridoLightProperties, true};
constexpr PropertyRule kFogProperties[] = {required(text("mode", "linear|exp|exp2")),
                                           at_least(number("density"), 0), at_least(number("start"), 0),
                                           at_least(number("end"), 0), at_least(numbers("color", 3, 4), 0)};
constexpr ObjectRule kFog{kFogProperties, true};
constexpr PropertyRule kBarridoSceneProperties[] = {
    at_least(numbers("ambient", 3), 0), at_least(numbers("background", 3, 4), 0), object("fog", kFog)};
constexpr ObjectRule kBarridoScene{kBarridoSceneProperties, true};

constexpr PropertyRule kMaterialExtrasProperties[] = {object("barrido", kBarridoMaterial)};
constexpr ObjectRule kMaterialExtras{kMaterialExtrasProperties};
constexpr PropertyRule kLightExtrasProperties[] = {object("barrido", kBarridoLight)};
constexpr ObjectRule kLightExtras{kLightExtrasProperties};
constexpr PropertyRule kSceneExtrasProperties[] = {object("barrido", kBarridoScene)};
constexpr ObjectRule kSceneExtras{kSceneExtrasProperties};

// Extensions

constexpr ObjectRule kAnyObject{};
constexpr PropertyRule kTextureTransformProperties[] = {numbers("offset", 2), number("rotation"),
                                                        numbers("scale", 2), integer("texCoord", 0, kMaxInt)};
constexpr ObjectRule kTextureTransform{kTextureTransformProperties};
constexpr PropertyRule kTextureInfoExtensionsProperties[] = {
    object("KHR_texture_transform", kTextureTransform)};
constexpr ObjectRule kTextureInfoExtensions{kTextureInfoExtensionsProperties};
constexpr PropertyRule kEmissiveStrengthProperties[] = {at_least(number("emissiveStrength"), 0)};
constexpr ObjectRule kEmissiveStrength{kEmissiveStrengthProperties};
constexpr PropertyRule kMaterialExtensionsProperties[] = {
    object("KHR_materials_unlit", kAnyObject), object("KHR_materials_emissive_strength", kEmissiveStrength)};
constexpr ObjectRule kMaterialExtensions{kMaterialExtensionsProperties};
constexpr PropertyRule kSpotProperties[] = {number("innerConeAngle"), number("outerConeAngle")};
constexpr ObjectRule kSpot{kSpotProperties};
constexpr PropertyRule kLightProperties[] = {
    text("name"),        required(text("type", "directional|point|spot")),
    numbers("color", 3), number("intensity"),
    number("range"),     object("spot", kSpot),
    extras(kLightExtras)};
constexpr ObjectRule kLight{kLightProperties};
constexpr PropertyRule kLightsProperties[] = {required(objects("lights", kLight))};
constexpr ObjectRule kLights{kLightsProperties};
constexpr PropertyRule kDocumentExtensionsProperties[] = {object("KHR_lights_punctual", kLights)};
constexpr ObjectRule kDocumentExtensions{kDocumentExtensionsProperties};
constexpr PropertyRule kNodeLightProperties[] = {required(index("light", Target::lights))};
constexpr ObjectRule kNodeLight{kNodeLightProperties};
constexpr PropertyRule kNodeExtensionsProperties[] = {object("KHR_lights_punctual", kNodeLight)};
constexpr ObjectRule kNodeExtensions{kNodeExtensionsProperties};

// Data

constexpr PropertyRule kBufferProperties[] = {text("uri"), required(integer("byteLength", 1, kMaxBytes))};
constexpr ObjectRule kBuffer{kBufferProperties};
constexpr PropertyRule kBufferViewProperties[] = {
    required(index("buffer", Target::buffers)), integer("byteOffset", 0, kMaxBytes),
    required(integer("byteLength", 1, kMaxBytes)), stride("byteStride"), integer("target", 0, kMaxInt)};
constexpr ObjectRule kBufferView{kBufferViewProperties};
constexpr PropertyRule kSparseIndicesProperties[] = {required(index("bufferView", Target::buffer_views)),
                                                     integer("byteOffset", 0, kMaxInt),
                                                     required(integer("componentType", 5121, 5125))};
constexpr ObjectRule kSparseIndices{kSparseIndicesProperties};
constexpr PropertyRule kSparseValuesProperties[] = {required(index("bufferView", Target::buffer_views)),
                                                    integer("byteOffset", 0, kMaxInt)};
constexpr ObjectRule kSparseValues{kSparseValuesProperties};
constexpr PropertyRule kSparseProperties[] = {required(integer("count", 1, kMaxInt)),
                                              required(object("indices", kSparseIndices)),
                                              required(object("values", kSparseValues))};
constexpr ObjectRule kSparse{kSparseProperties};
constexpr PropertyRule kAccessorProperties[] = {
    text("name"),
    index("bufferView", Target::buffer_views),
    integer("byteOffset", 0, kMaxBytes),
    required(integer("componentType", 5120, 5126)),
    boolean("normalized"),
    required(integer("count", 1, kMaxBytes)),
    required(text("type", "SCALAR|VEC2|VEC3|VEC4|MAT2|MAT3|MAT4")),
    object("sparse", kSparse)};
constexpr ObjectRule kAccessor{kAccessorProperties};

// Pictures and materials

constexpr PropertyRule kImageProperties[] = {text("name"), text("uri"), text("mimeType"),
                                             index("bufferView", Target::buffer_views)};
constexpr ObjectRule kImage{kImageProperties};
constexpr PropertyRule kSamplerProperties[] = {integer("magFilter", -1, kMaxInt),
                                               integer("minFilter", -1, kMaxInt),
                                               integer("wrapS", -1, kMaxInt), integer("wrapT", -1, kMaxInt)};
constexpr ObjectRule kSampler{kSamplerProperties};
constexpr PropertyRule kTextureProperties[] = {text("name"), index("sampler", Target::samplers),
                                               index("source", Target::images)};
constexpr ObjectRule kTexture{kTextureProperties};
constexpr PropertyRule kTextureInfoProperties[] = {
    required(index("index", Target::textures)), integer("texCoord", 0, kMaxInt), number("scale"),
    number("strength"), object("extensions", kTextureInfoExtensions)};
constexpr ObjectRule kTextureInfo{kTextureInfoProperties};
constexpr PropertyRule kMetallicRoughnessProperties[] = {
    numbers("baseColorFactor", 4), object("baseColorTexture", kTextureInfo), number("metallicFactor"),
    number("roughnessFactor"), object("metallicRoughnessTexture", kTextureInfo)};
constexpr ObjectRule kMetallicRoughness{kMetallicRoughnessProperties};
constexpr PropertyRule kMaterialProperties[] = {text("name"),
                                                object("pbrMetallicRoughness", kMetallicRoughness),
                                                object("normalTexture", kTextureInfo),
                                                object("occlusionTexture", kTextureInfo),
                                                object("emissiveTexture", kTextureInfo),
                                                numbers("emissiveFactor", 3),
                                                text("alphaMode"),
                                                number("alphaCutoff"),
                                                boolean("doubleSided"),
                                                object("extensions", kMaterialExtensions),
                                                extras(kMaterialExtras)};
constexpr ObjectRule kMaterial{kMaterialProperties};

// Meshes, nodes, scenes

constexpr PropertyRule kPrimitiveProperties[] = {
    {.name = "attributes", .kind = ValueKind::index_map, .required = true, .target = Target::accessors},
    index("indices", Target::accessors),
    index("material", Target::materials),
    integer("mode", 0, 6),
    {.name = "targets", .kind = ValueKind::index_maps, .target = Target::accessors}};
constexpr ObjectRule kPrimitive{kPrimitiveProperties};
constexpr PropertyRule kMeshProperties[] = {text("name"), required(objects("primitives", kPrimitive)),
                                            numbers("weights", 0, SIZE_MAX)};
constexpr ObjectRule kMesh{kMeshProperties};
constexpr PropertyRule kNodeProperties[] = {text("name"),
                                            index("camera", Target::cameras),
                                            indices("children", Target::nodes),
                                            index("skin", Target::skins),
                                            numbers("matrix", 16),
                                            index("mesh", Target::meshes),
                                            numbers("rotation", 4),
                                            numbers("scale", 3),
                                            numbers("translation", 3),
                                            numbers("weights", 0, SIZE_MAX),
                                            object("extensions", kNodeExtensions)};
constexpr ObjectRule kNode{kNodeProperties};
constexpr PropertyRule kSkinProperties[] = {text("name"), index("inverseBindMatrices", Target::accessors),
                                            index("skeleton", Target::nodes),
                                            required(indices("joints", Target::nodes))};
constexpr ObjectRule kSkin{kSkinProperties};
constexpr PropertyRule kSceneProperties[] = {text("name"), indices("nodes", Target::nodes),
                                             extras(kSceneExtras)};
constexpr ObjectRule kScene{kSceneProperties};

// Cameras and animations

constexpr PropertyRule kPerspectiveProperties[] = {positive("aspectRatio"), required(positive("yfov")),
                                                   positive("zfar"), required(positive("znear"))};
constexpr ObjectRule kPerspective{kPerspectiveProperties};
constexpr PropertyRule kOrthographicProperties[] = {required(number("xmag")), required(number("ymag")),
                                                    required(positive("zfar")),
                                                    required(at_least(number("znear"), 0))};
constexpr ObjectRule kOrthographic{kOrthographicProperties};
constexpr PropertyRule kCameraProperties[] = {
    text("name"), required(text("type", "perspective|orthographic")), object("perspective", kPerspective),
    object("orthographic", kOrthographic)};
constexpr ObjectRule kCamera{kCameraProperties};
constexpr PropertyRule kAnimationSamplerProperties[] = {required(index("input", Target::accessors)),
                                                        text("interpolation", "LINEAR|STEP|CUBICSPLINE"),
                                                        required(index("output", Target::accessors))};
constexpr ObjectRule kAnimationSampler{kAnimationSamplerProperties};
constexpr PropertyRule kChannelTargetProperties[] = {index("node", Target::nodes), required(text("path"))};
constexpr ObjectRule kChannelTarget{kChannelTargetProperties};
constexpr PropertyRule kChannelProperties[] = {required(integer("sampler", 0, kMaxInt)),
                                               required(object("target", kChannelTarget))};
constexpr ObjectRule kChannel{kChannelProperties};
constexpr PropertyRule kAnimationProperties[] = {text("name"), required(objects("channels", kChannel)),
                                                 required(objects("samplers", kAnimationSampler))};
constexpr ObjectRule kAnimation{kAnimationProperties};

constexpr PropertyRule kAssetProperties[] = {required(text("version")), text("minVersion"), text("generator"),
                                             text("copyright")};
constexpr ObjectRule kAsset{kAssetProperties};
constexpr PropertyRule kDocumentProperties[] = {required(object("asset", kAsset)),
                                                texts("extensionsUsed"),
                                                texts("extensionsRequired"),
                                                objects("accessors", kAccessor),
                                                objects("animations", kAnimation),
                                                objects("buffers", kBuffer),
                                                objects("bufferViews", kBufferView),
                                                objects("cameras", kCamera),
                                                objects("images", kImage),
                                                objects("materials", kMaterial),
                                                objects("meshes", kMesh),
                                                objects("nodes", kNode),
                                                objects("samplers", kSampler),
                                                index("scene", Target::scenes),
                                                objects("scenes", kScene),
                                                objects("skins", kSkin),
                                                objects("textures", kTexture),
                                                object("extensions", kDocumentExtensions)};
constexpr ObjectRule kDocument{kDocumentProperties};

}  // namespace

const ObjectRule& document_rule() { return kDocument; }

}  // namespace barrido::scene::gltf
