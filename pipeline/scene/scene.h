// A scene as plain data: what a glTF file holds, in Barrido's terms, checked and ready to draw. Indices refer
// to the vectors of Scene and are either valid or kNone; nodes form strict trees. Linear RGB throughout.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "pipeline/geometry.h"
#include "pipeline/pictures/image.h"
#include "pipeline/scene/texture_choice.h"
#include "raster/fragments/fragment_state.h"
#include "raster/textures/texture.h"

namespace barrido::scene {

inline constexpr int kNone = -1;

/// Floats that either belong to this object or are viewed in a buffer that `owner` keeps alive.
class FloatArray {
 public:
  FloatArray() = default;
  explicit FloatArray(std::vector<float> values)
      : owner_(std::make_shared<const std::vector<float>>(std::move(values))) {
    const auto& owned = *static_cast<const std::vector<float>*>(owner_.get());
    values_ = {owned.data(), owned.size()};
  }
  FloatArray(std::span<const float> view, std::shared_ptr<const void> owner)
      : owner_(std::move(owner)), values_(view) {}

  bool empty() const { return values_.empty(); }
  std::size_t size() const { return values_.size(); }
  const float* data() const { return values_.data(); }
  std::span<const float> values() const { return values_; }

 private:
  std::shared_ptr<const void> owner_;
  std::span<const float> values_;
};

/// Vertex indices, shared like a FloatArray: many primitives of a file may use the same ones.
class IndexArray {
 public:
  IndexArray() = default;
  IndexArray(
      std::vector<std::uint32_t> values)  // NOLINT(google-explicit-constructor): a list of indices is one
      : owner_(std::make_shared<const std::vector<std::uint32_t>>(std::move(values))) {
    const auto& owned = *static_cast<const std::vector<std::uint32_t>*>(owner_.get());
    values_ = {owned.data(), owned.size()};
  }
  IndexArray(std::initializer_list<std::uint32_t> values) : IndexArray(std::vector<std::uint32_t>(values)) {}
  IndexArray(std::span<const std::uint32_t> view, std::shared_ptr<const void> owner)
      : owner_(std::move(owner)), values_(view) {}

  bool empty() const { return values_.empty(); }
  std::size_t size() const { return values_.size(); }
  const std::uint32_t* data() const { return values_.data(); }
  const std::uint32_t* begin() const { return values_.data(); }
  const std::uint32_t* end() const { return values_.data() + values_.size(); }
  std::uint32_t operator[](std::size_t i) const { return values_[i]; }
  std::span<const std::uint32_t> values() const { return values_; }

 private:
  std::shared_ptr<const void> owner_;
  std::span<const std::uint32_t> values_;
};

/// A picture with its sampler; filters as OpenGL names them.
struct Texture {
  int image = kNone;
  int fallback_image =
      kNone;  ///< In its place where it cannot be read (EXT_texture_webp, KHR_texture_basisu).
  raster::MinFilter min_filter = raster::MinFilter::linear_mipmap_linear;
  raster::MagFilter mag_filter = raster::MagFilter::linear;
  raster::Wrap wrap_s = raster::Wrap::repeat;
  raster::Wrap wrap_t = raster::Wrap::repeat;
};

/// A use of a texture by a material.
struct TextureUse {
  int texture = kNone;
  int texcoord_set = 0;       ///< 0 or 1: TEXCOORD_n
  glm::mat3 transform{1.0f};  ///< KHR_texture_transform: (u, v, 1) → (u', v', 1)
};

/// Heights whose slopes tilt normals (T14). extras.barrido of a material.
struct BumpMap {
  TextureUse texture;    ///< Mean of R, G and B
  float height = 0.05f;  ///< Of white over black, in the model's units, or in repeats of the map where `form`
                         ///< is invariant
  raster::BumpForm form = raster::BumpForm::invariant;
};

/// extras.barrido of a material: exact fixed-function values; what is absent comes from the conversion.
struct ExactMaterial {
  std::optional<glm::vec3> ambient, diffuse, specular, emission;
  std::optional<float> shininess;
};

/// How far the points of a surface are moved along their normals before anything else is done with it (Cook
/// 1984; T15): bias + scale·height, the height in [0, 1].
struct Displacement {
  float scale = 0.1f;  ///< In the mesh's own units, as `bias`; skinned meshes': the world's
  float bias = 0.0f;
  int pieces =
      0;  ///< That each edge of a triangle is cut into, 1..kMaxDisplacedPieces; 0: as the heights ask for
};
inline constexpr int kMaxDisplacedPieces = 256;

/// extras.barrido.displacement of a material: heights from a picture's red channel.
struct MaterialDisplacement {
  Displacement by;
  TextureUse texture;
};

enum class AlphaMode : std::uint8_t { opaque, mask, blend };

/// KHR_materials_pbrSpecularGlossiness; the material's base colour is the diffuse one.
struct SpecularGlossiness {
  glm::vec3 specular{1, 1, 1};
  float glossiness = 1.0f;
  TextureUse texture;  ///< RGB specular, A glossiness
};

/// What extensions add to a material (KHR_materials_…), each property at the value that changes nothing.
struct MaterialLayers {
  std::optional<SpecularGlossiness> specular_glossiness;
  float ior = 1.5f;
  float specular = 1.0f;
  glm::vec3 specular_color{1, 1, 1};
  glm::vec3 sheen_color{0, 0, 0};
  float clearcoat = 0.0f, clearcoat_roughness = 0.0f;
  float iridescence = 0.0f, iridescence_ior = 1.3f, iridescence_thickness_nm = 400.0f;
  float anisotropy = 0.0f;
  float transmission = 0.0f;
  float thickness = 0.0f;             ///< In the mesh's own units
  float attenuation_distance = 0.0f;  ///< 0: endless
  glm::vec3 attenuation_color{1, 1, 1};
  TextureUse specular_texture;             ///< A
  TextureUse specular_color_texture;       ///< RGB
  TextureUse sheen_color_texture;          ///< RGB
  TextureUse clearcoat_texture;            ///< R
  TextureUse clearcoat_roughness_texture;  ///< G
  TextureUse iridescence_texture;          ///< R
  TextureUse transmission_texture;         ///< R
  TextureUse thickness_texture;            ///< G
};

struct Material {
  std::string name;
  glm::vec4 base_color{1, 1, 1, 1};
  float metallic = 1.0f;
  float roughness = 1.0f;
  glm::vec3 emissive{0, 0, 0};
  TextureUse base_color_texture;
  TextureUse metallic_roughness_texture;  ///< G roughness, B metallic
  TextureUse normal_texture;
  float normal_scale = 1.0f;     ///< Of x and y
  TextureUse occlusion_texture;  ///< R
  float occlusion_strength = 1.0f;
  TextureUse emissive_texture;
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false;
  bool unlit = false;                            ///< KHR_materials_unlit
  std::shared_ptr<const MaterialLayers> layers;  ///< Null where no extension asks for one.
  // extras.barrido
  ExactMaterial exact;
  BumpMap bump;
  TextureUse transparency_texture;                           ///< R: 0 lets all through, 1 is opaque (T16)
  TextureUse specularity_texture;                            ///< RGB: factor of the highlights (T16)
  TextureChoice texture;                                     ///< extras.barrido; never a picture.
  std::shared_ptr<const MaterialDisplacement> displacement;  ///< Null: none.
};

/// Differences, one element a vertex; each may be empty.
struct MorphTarget {
  FloatArray positions;                 ///< 3 floats
  FloatArray normals;                   ///< 3 floats
  FloatArray tangents;                  ///< 3 floats; of the file's tangents
  std::array<FloatArray, 2> texcoords;  ///< 2 floats
  FloatArray colors;                    ///< 4 floats
};

/// One primitive of a mesh. Arrays are tightly packed, one element a vertex; all but positions may be empty.
struct Primitive {
  pipeline::PrimitiveMode mode = pipeline::PrimitiveMode::triangles;
  std::uint32_t vertex_count = 0;
  FloatArray positions;                 ///< 3 floats
  FloatArray normals;                   ///< 3 floats, unit length
  FloatArray tangents;                  ///< 4 floats
  std::array<FloatArray, 2> texcoords;  ///< 2 floats
  FloatArray colors;                    ///< 4 floats
  std::vector<std::array<std::uint16_t, 4>> joints;
  FloatArray weights;  ///< 4 floats, sum 1
  std::vector<MorphTarget> morph_targets;
  IndexArray indices;                    ///< Each below vertex_count; empty: vertices in order.
  int material = kNone;                  ///< kNone: glTF's default material
  std::map<int, int> variant_materials;  ///< In its place, by Scene::variants (KHR_materials_variants)
};

struct Mesh {
  std::string name;
  std::vector<Primitive> primitives;
  std::vector<float> morph_weights;
};

/// Local transform, either as a matrix or as translation, rotation and scale (which animations need).
struct Transform {
  glm::dvec3 translation{0, 0, 0};
  glm::quat rotation{1, 0, 0, 0};
  glm::vec3 scale{1, 1, 1};
  std::optional<glm::dmat4> matrix;
};

struct Node {
  std::string name;
  int parent = kNone;
  std::vector<int> children;
  Transform transform;
  int mesh = kNone;
  int skin = kNone;
  int camera = kNone;
  int light = kNone;
  std::vector<float> morph_weights;  ///< Empty: the mesh's.
};

struct Camera {
  enum class Kind : std::uint8_t { perspective, orthographic };
  std::string name;
  Kind kind = Kind::perspective;
  float vertical_fov_rad = 0.8f;
  float aspect = 0.0f;                          ///< 0: the frame's
  float half_width = 1.0f, half_height = 1.0f;  ///< xmag, ymag
  float near_plane = 0.1f;
  float far_plane = 0.0f;  ///< 0: infinite (perspective only)
};

/// A light source of a node; it shines along the node's −Z.
struct Light {
  enum class Kind : std::uint8_t { directional, point, spot };
  std::string name;
  Kind kind = Kind::directional;
  glm::vec3 color{1, 1, 1};
  float intensity = 1.0f;  ///< lux (directional) or candela; the course's I_p where `exact_intensity` is set
  float range = 0.0f;      ///< 0: endless
  float inner_cone_rad = 0.0f;
  float outer_cone_rad = 0.785398163f;
  // extras.barrido
  std::optional<float> exact_intensity;             ///< I_p, may be negative (V5)
  std::optional<std::array<float, 3>> attenuation;  ///< kc, kl, kq (L4)
  std::optional<float> spot_exponent;
};

struct Skin {
  std::vector<int> joints;                       ///< Nodes
  std::vector<glm::mat4> inverse_bind_matrices;  ///< One a joint
};

struct AnimationChannel {
  enum class Path : std::uint8_t { translation, rotation, scale, weights };
  enum class Interpolation : std::uint8_t { step, linear, cubic_spline };
  int node = kNone;
  Path path = Path::translation;
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times_s;  ///< Ascending seconds
  std::vector<float> values;   ///< times × (3 if cubic) × components
};

/// A property of a material, light or camera that moves (KHR_animation_pointer).
struct PropertyChannel {
  enum class Property : std::uint8_t {
    base_color,
    metallic,
    roughness,
    emissive_factor,
    emissive_strength,
    alpha_cutoff,
    texture_offset,
    texture_rotation,
    texture_scale,
    light_color,
    light_intensity,
    light_range,
    light_inner_cone,
    light_outer_cone,
    camera_fov,
    camera_half_width,
    camera_half_height,
    camera_near,
    camera_far,
  };
  Property property = Property::base_color;
  int index = kNone;                    ///< Of the material, light or camera
  TextureUse Material::*use = nullptr;  ///< Whose transform, of a texture_… property
  /// What the property is a part of, where only some parts move: offset, rotation and scale; or the emissive
  /// factor and its strength.
  std::array<float, 5> rest{};
  AnimationChannel keys;  ///< Times and values; its node and path say nothing.
};

struct Animation {
  std::string name;
  std::vector<AnimationChannel> channels;
  std::vector<PropertyChannel> properties;
  float duration_s = 0.0f;
};

/// extras.barrido of a glTF scene.
struct SceneSettings {
  std::optional<glm::vec3> ambient;
  std::optional<glm::vec4> background;
  std::optional<raster::FogState> fog;
};

struct SceneRoot {
  std::string name;
  std::vector<int> nodes;
  SceneSettings settings;
};

/// How well a feature found in a file is drawn; for `barrido info`.
struct Feature {
  enum class Support : std::uint8_t { exact, approximated, ignored };
  std::string name;  ///< "KHR_materials_unlit", "material: metallic-roughness", …
  Support support = Support::exact;
  std::string note;
};

struct Scene {
  std::string source;     ///< Path as given
  std::string generator;  ///< asset.generator
  std::vector<Image> images;
  std::vector<Texture> textures;
  std::vector<Material> materials;
  std::vector<std::string> variants;  ///< Names (KHR_materials_variants)
  std::vector<Mesh> meshes;
  std::vector<Node> nodes;
  std::vector<Camera> cameras;
  std::vector<Light> lights;
  std::vector<Skin> skins;
  std::vector<Animation> animations;
  std::vector<SceneRoot> scenes;
  int default_scene = 0;
  std::vector<Feature> features;
  std::vector<std::string>
      warnings;  ///< One line each: an optional feature that is not supported, and so on.
};

}  // namespace barrido::scene
