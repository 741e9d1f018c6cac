// glTF 2.0, section 5, each property as one line of a table.
#include "pipeline/validate/schema_parts.h"

namespace barrido::scene::validation {
namespace {

constexpr int kComponentTypes[] = {5120, 5121, 5122, 5123, 5125, 5126};
constexpr int kIndexTypes[] = {5121, 5123, 5125};
constexpr int kTargets[] = {34962, 34963};
constexpr int kMagFilters[] = {9728, 9729};
constexpr int kMinFilters[] = {9728, 9729, 9984, 9985, 9986, 9987};
constexpr int kWraps[] = {33071, 33648, 10497};

// Data

constexpr Property kBufferProperties[] = {text("uri"), required(integer("byteLength", 1)), text("name")};
constexpr Schema kBuffer{.properties = kBufferProperties};
constexpr Property kBufferViewProperties[] = {required(index("buffer", Collection::buffers)),
                                              integer("byteOffset", 0),
                                              required(integer("byteLength", 1)),
                                              integer("byteStride", 4, 252),
                                              integer_of("target", kTargets),
                                              text("name")};
constexpr Schema kBufferView{.properties = kBufferViewProperties, .check = check_buffer_view_values};
constexpr Property kSparseIndicesProperties[] = {required(index("bufferView", Collection::buffer_views)),
                                                 integer("byteOffset", 0),
                                                 required(integer_of("componentType", kIndexTypes))};
constexpr Schema kSparseIndices{.properties = kSparseIndicesProperties};
constexpr Property kSparseValuesProperties[] = {required(index("bufferView", Collection::buffer_views)),
                                                integer("byteOffset", 0)};
constexpr Schema kSparseValues{.properties = kSparseValuesProperties};
constexpr Property kSparseProperties[] = {required(integer("count", 1)),
                                          required(object("indices", kSparseIndices)),
                                          required(object("values", kSparseValues))};
constexpr Schema kSparse{.properties = kSparseProperties};
constexpr Property kAccessorProperties[] = {index("bufferView", Collection::buffer_views),
                                            integer("byteOffset", 0),
                                            required(integer_of("componentType", kComponentTypes)),
                                            required(integer("count", 1)),
                                            required(text("type", "SCALAR|VEC2|VEC3|VEC4|MAT2|MAT3|MAT4")),
                                            boolean("normalized"),
                                            any("max"),
                                            any("min"),
                                            object("sparse", kSparse),
                                            text("name")};
constexpr Schema kAccessor{.properties = kAccessorProperties, .check = check_accessor_values};

// Pictures and materials

constexpr Property kImageProperties[] = {index("bufferView", Collection::buffer_views), any("mimeType"),
                                         text("uri"), text("name")};
constexpr Schema kImage{ObjectType::image, kImageProperties, check_image_values};
constexpr Property kSamplerProperties[] = {integer_of("magFilter", kMagFilters),
                                           integer_of("minFilter", kMinFilters), integer_of("wrapS", kWraps),
                                           integer_of("wrapT", kWraps), text("name")};
constexpr Schema kSampler{.properties = kSamplerProperties};
constexpr Property kTextureProperties[] = {index("sampler", Collection::samplers),
                                           index("source", Collection::images), text("name")};
constexpr Schema kTexture{.type = ObjectType::texture, .properties = kTextureProperties};
constexpr Property kOcclusionTextureProperties[] = {required(index("index", Collection::textures)),
                                                    integer("texCoord", 0), number("strength", 0, 1)};
constexpr Schema kOcclusionTexture{ObjectType::occlusion_texture_info, kOcclusionTextureProperties,
                                   note_texture_info};
constexpr Property kMetallicRoughnessProperties[] = {
    numbers("baseColorFactor", 4, 0, 1), object("baseColorTexture", kTextureInfo),
    number("metallicFactor", 0, 1), number("roughnessFactor", 0, 1),
    object("metallicRoughnessTexture", kTextureInfo)};
constexpr Schema kMetallicRoughness{.properties = kMetallicRoughnessProperties};
constexpr Property kMaterialProperties[] = {object("pbrMetallicRoughness", kMetallicRoughness),
                                            object("normalTexture", kNormalTexture),
                                            object("occlusionTexture", kOcclusionTexture),
                                            object("emissiveTexture", kTextureInfo),
                                            numbers("emissiveFactor", 3, 0, 1),
                                            text("alphaMode", "OPAQUE|MASK|BLEND"),
                                            number("alphaCutoff", 0),
                                            boolean("doubleSided"),
                                            text("name")};
constexpr Schema kMaterial{ObjectType::material, kMaterialProperties, check_material_values};

// Meshes, nodes, scenes

constexpr Property kPrimitiveProperties[] = {
    {.name = "attributes", .kind = Kind::index_map, .required = true, .target = Collection::accessors},
    index("indices", Collection::accessors),
    index("material", Collection::materials),
    integer("mode", 0, 6),
    {.name = "targets", .kind = Kind::index_maps, .target = Collection::accessors}};
constexpr Schema kPrimitive{ObjectType::primitive, kPrimitiveProperties, check_primitive_values};
constexpr Property kMeshProperties[] = {required(objects("primitives", kPrimitive)), numbers("weights", 0),
                                        text("name")};
constexpr Schema kMesh{.properties = kMeshProperties, .check = check_mesh_values};
constexpr Property kNodeProperties[] = {index("camera", Collection::cameras),
                                        indices("children", Collection::nodes),
                                        index("skin", Collection::skins),
                                        numbers("matrix", 16),
                                        index("mesh", Collection::meshes),
                                        numbers("rotation", 4, -1, 1),
                                        numbers("scale", 3),
                                        numbers("translation", 3),
                                        numbers("weights", 0),
                                        text("name")};
constexpr Schema kNode{ObjectType::node, kNodeProperties, check_node_values};
constexpr Property kSkinProperties[] = {
    index("inverseBindMatrices", Collection::accessors),
    {.name = "skeleton", .kind = Kind::index, .target = Collection::nodes, .unused = true},
    required(indices("joints", Collection::nodes)),
    text("name")};
constexpr Schema kSkin{.properties = kSkinProperties};
constexpr Property kSceneProperties[] = {indices("nodes", Collection::nodes), text("name")};
constexpr Schema kScene{.properties = kSceneProperties};

// Cameras and animations

constexpr Property kPerspectiveProperties[] = {positive("aspectRatio"), required(positive("yfov")),
                                               positive("zfar"), required(positive("znear"))};
constexpr Schema kPerspective{.properties = kPerspectiveProperties, .check = check_perspective_values};
constexpr Property kOrthographicProperties[] = {required(number("xmag")), required(number("ymag")),
                                                required(positive("zfar")), required(number("znear", 0))};
constexpr Schema kOrthographic{.properties = kOrthographicProperties, .check = check_orthographic_values};
constexpr Property kCameraProperties[] = {required(text("type", "orthographic|perspective")),
                                          any("orthographic"), any("perspective"), text("name")};
constexpr Schema kCamera{ObjectType::camera, kCameraProperties, check_camera_values};
constexpr Property kAnimationSamplerProperties[] = {required(index("input", Collection::accessors)),
                                                    text("interpolation", "LINEAR|STEP|CUBICSPLINE"),
                                                    required(index("output", Collection::accessors))};
constexpr Schema kAnimationSampler{.properties = kAnimationSamplerProperties};
constexpr Property kChannelTargetProperties[] = {index("node", Collection::nodes), required(any("path"))};
constexpr Schema kChannelTarget{ObjectType::channel_target, kChannelTargetProperties,
                                check_channel_target_values};
constexpr Property kChannelProperties[] = {required(object("target", kChannelTarget)),
                                           required(index("sampler", Collection::count))};
constexpr Schema kChannel{.properties = kChannelProperties};
constexpr Property kAnimationProperties[] = {required(objects("channels", kChannel)),
                                             required(objects("samplers", kAnimationSampler)), text("name")};
constexpr Schema kAnimation{.properties = kAnimationProperties};

// The document

constexpr Property kAssetProperties[] = {text("copyright"), text("generator"), required(text("version")),
                                         text("minVersion")};
constexpr Schema kAsset{.properties = kAssetProperties, .check = check_asset_values};
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
const Schema& perspective_schema() { return kPerspective; }
const Schema& orthographic_schema() { return kOrthographic; }

}  // namespace barrido::scene::validation
