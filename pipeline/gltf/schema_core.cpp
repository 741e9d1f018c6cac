// glTF 2.0, section 5, each property as one row of a table, with extras.barrido
// (docs/barrido-extras.schema.json). Drawing looks at the rows in their order and names the first that is
// wrong.
#include "pipeline/gltf/schema_parts.h"
#include "pipeline/scene/scene.h"
#include "raster/textures/pattern.h"

namespace barrido::scene::gltf {
namespace {

constexpr int kComponentTypes[] = {5120, 5121, 5122, 5123, 5125, 5126};
constexpr int kIndexTypes[] = {5121, 5123, 5125};
constexpr int kTargets[] = {34962, 34963};
constexpr int kMagFilters[] = {9728, 9729};
constexpr int kMinFilters[] = {9728, 9729, 9984, 9985, 9986, 9987};
constexpr int kWraps[] = {33071, 33648, 10497};
constexpr Range kUnit{0, 1};

/// Checked when type and component type of the accessor are known.
constexpr Property bounds(std::string_view name) { return {.name = name, .drawing = Drawing::ignored}; }
/// Red, green, blue and perhaps alpha.
constexpr Property color(std::string_view name) {
  return {.name = name, .kind = Kind::numbers, .range = {.min = 0}, .min_items = 3, .max_items = 4};
}

// extras.barrido

constexpr Range kFromZero{.min = 0};
constexpr Property unit_color(std::string_view name) {
  return {.name = name, .kind = Kind::numbers, .range = kUnit, .min_items = 3, .max_items = 4};
}
constexpr Property kBarridoTextureProperties[] = {
    fatal(required(text("procedure", "stripes|checker|noise|wood|marble"))),
    fatal(positive("scale")),
    fatal(numbers("axis", 3)),
    fatal(text("space", "object|world|surface")),
    fatal(unit_color("dark")),
    fatal(unit_color("light")),
    fatal(integer("octaves", 1, raster::kMaxOctaves)),
    fatal(number("gain", 0.01, 1)),
    fatal(number("turbulence", -100, 100)),
    fatal(number("threshold", -1, 1))};
constexpr Schema kBarridoTexture{.properties = kBarridoTextureProperties, .closed = true};
constexpr Property kBarridoMappingProperties[] = {
    fatal(required(text("surface", "planar|cylinder|sphere|box"))),
    fatal(text("from", "surface|centre|normal|reflection")),
    fatal(text("at", "fragments|vertices")),
    fatal(numbers("axis", 3)),
    fatal(numbers("centre", 3)),
    fatal(positive("size")),
    fatal(numbers("repeats", 2)),
    fatal(numbers("offset", 2))};
constexpr Schema kBarridoMapping{.properties = kBarridoMappingProperties, .closed = true};
constexpr Property kDisplacementProperties[] = {
    object("texture", kTextureInfo), fatal(number("scale", -1e6, 1e6)), fatal(number("bias", -1e6, 1e6)),
    integer("pieces", 1, kMaxDisplacedPieces)};
constexpr Schema kDisplacement{.properties = kDisplacementProperties, .closed = true};
constexpr Property kMapProperties[] = {fatal(required(index("index", Collection::textures))),
                                       fatal(integer("texCoord", 0))};
constexpr Schema kMap{.properties = kMapProperties, .closed = true};
constexpr Property kBumpProperties[] = {fatal(required(index("index", Collection::textures))),
                                        fatal(integer("texCoord", 0)), fatal(number("height", -1e6, 1e6)),
                                        fatal(text("form", "invariant|blinn"))};
constexpr Schema kBump{.properties = kBumpProperties, .closed = true};
constexpr Property kBarridoMaterialProperties[] = {fatal(numbers("ambient", 3, kFromZero)),
                                                   fatal(numbers("diffuse", 3, kFromZero)),
                                                   fatal(numbers("specular", 3, kFromZero)),
                                                   fatal(numbers("emission", 3, kFromZero)),
                                                   fatal(number("shininess", 0, 1e6)),
                                                   fatal(object("bump", kBump)),
                                                   fatal(object("transparencyTexture", kMap)),
                                                   fatal(object("specularityTexture", kMap)),
                                                   object("texture", kBarridoTexture),
                                                   object("mapping", kBarridoMapping),
                                                   fatal(text("tiles", "none|rotate|shift|both")),
                                                   object("displacement", kDisplacement)};
constexpr Schema kBarridoMaterial{.properties = kBarridoMaterialProperties, .closed = true};
constexpr Property kFogProperties[] = {fatal(required(text("mode", "linear|exp|exp2"))),
                                       fatal(number("density", 0)), fatal(number("start", 0)),
                                       fatal(number("end", 0)), fatal(color("color"))};
constexpr Schema kFog{.properties = kFogProperties, .closed = true};
constexpr Property kBarridoSceneProperties[] = {fatal(numbers("ambient", 3, kFromZero)),
                                                fatal(color("background")), object("fog", kFog)};
constexpr Schema kBarridoScene{.properties = kBarridoSceneProperties, .closed = true};

// Data

constexpr Property kBufferProperties[] = {text("uri"), required(integer("byteLength", 1)),
                                          ignored(text("name"))};
constexpr Schema kBuffer{.properties = kBufferProperties};
constexpr Property kByteStride{
    .name = "byteStride", .kind = Kind::integer, .range = {4, 252}, .multiple_of = 4, .drawn = {0, 252}};
constexpr Property kBufferViewProperties[] = {required(index("buffer", Collection::buffers)),
                                              integer("byteOffset", 0),
                                              required(integer("byteLength", 1)),
                                              kByteStride,
                                              drawn_from(0, kMaxInt, integer_of("target", kTargets)),
                                              ignored(text("name"))};
constexpr Schema kBufferView{ObjectType::buffer_view, kBufferViewProperties};
constexpr Property kSparseIndicesProperties[] = {required(index("bufferView", Collection::buffer_views)),
                                                 drawn_from(0, kMaxInt, integer("byteOffset", 0)),
                                                 required(integer_of("componentType", kIndexTypes))};
constexpr Schema kSparseIndices{.properties = kSparseIndicesProperties};
constexpr Property kSparseValuesProperties[] = {required(index("bufferView", Collection::buffer_views)),
                                                drawn_from(0, kMaxInt, integer("byteOffset", 0))};
constexpr Schema kSparseValues{.properties = kSparseValuesProperties};
constexpr Property kSparseProperties[] = {required(drawn_from(1, kMaxInt, integer("count", 1))),
                                          required(object("indices", kSparseIndices)),
                                          required(object("values", kSparseValues))};
constexpr Schema kSparse{.properties = kSparseProperties};
constexpr Property kAccessorProperties[] = {
    text("name"),
    index("bufferView", Collection::buffer_views),
    integer("byteOffset", 0),
    required(integer_of("componentType", kComponentTypes)),
    boolean("normalized"),
    required(integer("count", 1)),
    fatal(required(text("type", "SCALAR|VEC2|VEC3|VEC4|MAT2|MAT3|MAT4"))),
    bounds("max"),
    bounds("min"),
    object("sparse", kSparse)};
constexpr Schema kAccessor{ObjectType::accessor, kAccessorProperties};

// Pictures and materials

constexpr Property kImageProperties[] = {text("name"), text("uri"), text("mimeType"),
                                         index("bufferView", Collection::buffer_views)};
constexpr Schema kImage{ObjectType::image, kImageProperties};
constexpr Property kSamplerProperties[] = {drawn_from(-1, kMaxInt, integer_of("magFilter", kMagFilters)),
                                           drawn_from(-1, kMaxInt, integer_of("minFilter", kMinFilters)),
                                           drawn_from(-1, kMaxInt, integer_of("wrapS", kWraps)),
                                           drawn_from(-1, kMaxInt, integer_of("wrapT", kWraps)),
                                           ignored(text("name"))};
constexpr Schema kSampler{.properties = kSamplerProperties};
constexpr Property kTextureProperties[] = {text("name"), index("sampler", Collection::samplers),
                                           index("source", Collection::images)};
constexpr Schema kTexture{ObjectType::texture, kTextureProperties};
constexpr Property kOcclusionTextureProperties[] = {required(index("index", Collection::textures)),
                                                    drawn_from(0, kMaxInt, integer("texCoord", 0)),
                                                    number("strength", 0, 1)};
constexpr Schema kOcclusionTexture{ObjectType::occlusion_texture_info, kOcclusionTextureProperties};
constexpr Property kMetallicRoughnessProperties[] = {
    numbers("baseColorFactor", 4, kUnit), object("baseColorTexture", kTextureInfo),
    number("metallicFactor", 0, 1), number("roughnessFactor", 0, 1),
    object("metallicRoughnessTexture", kTextureInfo)};
constexpr Schema kMetallicRoughness{.properties = kMetallicRoughnessProperties};
constexpr Property kMaterialProperties[] = {text("name"),
                                            object("pbrMetallicRoughness", kMetallicRoughness),
                                            object("normalTexture", kNormalTexture),
                                            object("occlusionTexture", kOcclusionTexture),
                                            object("emissiveTexture", kTextureInfo),
                                            numbers("emissiveFactor", 3, kUnit),
                                            text("alphaMode", "OPAQUE|MASK|BLEND"),
                                            number("alphaCutoff", 0),
                                            boolean("doubleSided")};
constexpr Schema kMaterial{ObjectType::material, kMaterialProperties, &kBarridoMaterial};

// Meshes, nodes, scenes

constexpr Property kPrimitiveProperties[] = {
    {.name = "attributes", .kind = Kind::index_map, .required = true, .target = Collection::accessors},
    index("indices", Collection::accessors),
    index("material", Collection::materials),
    integer("mode", 0, 6),
    {.name = "targets", .kind = Kind::index_maps, .target = Collection::accessors}};
constexpr Schema kPrimitive{ObjectType::primitive, kPrimitiveProperties};
constexpr Property kMeshProperties[] = {text("name"), required(objects("primitives", kPrimitive)),
                                        any_numbers("weights")};
constexpr Schema kMesh{ObjectType::mesh, kMeshProperties};
constexpr Property kNodeProperties[] = {text("name"),
                                        index("camera", Collection::cameras),
                                        indices("children", Collection::nodes),
                                        index("skin", Collection::skins),
                                        numbers("matrix", 16),
                                        index("mesh", Collection::meshes),
                                        numbers("rotation", 4, {-1, 1}),
                                        numbers("scale", 3),
                                        numbers("translation", 3),
                                        any_numbers("weights")};
constexpr Schema kNode{ObjectType::node, kNodeProperties};
constexpr Property kSkinProperties[] = {
    text("name"),
    index("inverseBindMatrices", Collection::accessors),
    {.name = "skeleton", .kind = Kind::index, .unused = true, .target = Collection::nodes},
    required(indices("joints", Collection::nodes))};
constexpr Schema kSkin{.properties = kSkinProperties};
constexpr Property kSceneProperties[] = {text("name"), indices("nodes", Collection::nodes)};
constexpr Schema kScene{.properties = kSceneProperties, .barrido = &kBarridoScene};

// Cameras and animations

constexpr Property kPerspectiveProperties[] = {fatal(positive("aspectRatio")),
                                               fatal(required(positive("yfov"))), fatal(positive("zfar")),
                                               fatal(required(positive("znear")))};
constexpr Schema kPerspective{ObjectType::perspective, kPerspectiveProperties};
constexpr Property kOrthographicProperties[] = {required(number("xmag")), required(number("ymag")),
                                                fatal(required(positive("zfar"))),
                                                fatal(required(number("znear", 0)))};
constexpr Schema kOrthographic{ObjectType::orthographic, kOrthographicProperties};
constexpr Property kCameraProperties[] = {
    text("name"), fatal(required(text("type", "perspective|orthographic"))),
    of_type(object("perspective", kPerspective)), of_type(object("orthographic", kOrthographic))};
constexpr Schema kCamera{ObjectType::camera, kCameraProperties};
constexpr Property kAnimationSamplerProperties[] = {required(index("input", Collection::accessors)),
                                                    fatal(text("interpolation", "LINEAR|STEP|CUBICSPLINE")),
                                                    required(index("output", Collection::accessors))};
constexpr Schema kAnimationSampler{.properties = kAnimationSamplerProperties};
constexpr Property kChannelTargetProperties[] = {index("node", Collection::nodes), required(text("path"))};
constexpr Schema kChannelTarget{ObjectType::channel_target, kChannelTargetProperties};
constexpr Property kChannelProperties[] = {required(index("sampler", Collection::count)),
                                           required(object("target", kChannelTarget))};
constexpr Schema kChannel{.properties = kChannelProperties};
constexpr Property kAnimationProperties[] = {text("name"), required(objects("channels", kChannel)),
                                             required(objects("samplers", kAnimationSampler))};
constexpr Schema kAnimation{.properties = kAnimationProperties};

// The document

constexpr Property kAssetProperties[] = {required(text("version")), text("minVersion"), text("generator"),
                                         text("copyright")};
constexpr Schema kAsset{ObjectType::asset, kAssetProperties};
constexpr Property kDocumentProperties[] = {required(object("asset", kAsset)),
                                            texts("extensionsUsed"),
                                            texts("extensionsRequired"),
                                            collection("accessors", kAccessor),
                                            collection("animations", kAnimation),
                                            collection("buffers", kBuffer),
                                            collection("bufferViews", kBufferView),
                                            collection("cameras", kCamera),
                                            collection("images", kImage),
                                            collection("materials", kMaterial),
                                            collection("meshes", kMesh),
                                            collection("nodes", kNode),
                                            collection("samplers", kSampler),
                                            index("scene", Collection::scenes),
                                            collection("scenes", kScene),
                                            collection("skins", kSkin),
                                            collection("textures", kTexture)};
constexpr Schema kDocument{.type = ObjectType::document, .properties = kDocumentProperties};

}  // namespace

const Schema& document_schema() { return kDocument; }

}  // namespace barrido::scene::gltf
