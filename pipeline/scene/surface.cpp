#include "pipeline/scene/surface.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "pipeline/scene/surface_builder.h"
#include "pipeline/scene/texture_placement.h"

namespace barrido::scene {
namespace {

SurfaceContext context_of(const Material& material, bool has_colors, const SurfaceOptions& options,
                          TextureCache& textures) {
  SurfaceContext context;
  context.vertex_colors = has_colors;
  if (options.textures && material.texture.solid) {
    context.base_color = mean_color(material.texture.solid->pattern);
  } else if (options.textures && textures.usable(material.base_color_texture.texture)) {
    context.base_color = textures.mean(material.base_color_texture.texture, options.encoding);
  }
  if (textures.usable(material.metallic_roughness_texture.texture)) {
    const glm::vec3 mean =
        textures.mean(material.metallic_roughness_texture.texture, raster::Encoding::linear);
    context.roughness = mean.g;
    context.metallic = mean.b;
  }
  return context;
}

void set_unlit(SurfaceState& surface, const Material& material, SurfaceBuilder& builder) {
  surface.lit = false;
  surface.color = material.base_color;
  builder.add_base_color(material);
}

void set_material(SurfaceState& surface, const SurfaceCoefficients& coefficients, const ExactMaterial& exact,
                  const SurfaceOptions& options) {
  surface.material.ambient = glm::vec4(coefficients.ambient, 1.0f);
  surface.material.diffuse = coefficients.diffuse;
  surface.material.specular = glm::vec4(coefficients.specular, 1.0f);
  const bool is_phong = options.specular_model == pipeline::SpecularModel::phong;
  surface.reflection_exponent = coefficients.reflection_exponent;
  // An exact exponent belongs to the model the user chose.
  surface.material.shininess =
      is_phong && !exact.shininess ? phong_shininess(coefficients.shininess) : coefficients.shininess;
}

/// The light that the surface gives off is added last, where no texture can multiply it.
void set_emission(SurfaceState& surface, const Material& material, const glm::vec3& emission,
                  const SurfaceOptions& options, TextureCache& textures, SurfaceBuilder& builder) {
  if (emission == glm::vec3(0.0f)) return;
  if (builder.can_use(material.emissive_texture)) {
    builder.add_emissive(material.emissive_texture, emission);
    return;
  }
  glm::vec3 color = emission;
  if (textures.usable(material.emissive_texture.texture)) {
    color *= textures.mean(material.emissive_texture.texture, options.encoding);
  }
  if (surface.unit_count == 0) {
    surface.material.emission = glm::vec4(color, 1.0f);
  } else {
    builder.add_constant(color);
  }
}

/// Whether the pictures of KHR_materials_specular are drawn as they are: then all that shines is multiplied
/// by them. Of a material with metal, only a part is.
bool shines_by_picture(const Material& material, const SurfaceOptions& options,
                       const TextureCache& textures) {
  const auto usable = [&](const TextureUse& use) { return options.textures && textures.usable(use.texture); };
  const MaterialLayers* layers = material.layers.get();
  return options.maps.drawn && layers != nullptr && !layers->specular_glossiness &&
         material.metallic == 0.0f && !material.exact.specular && !material.exact.diffuse &&
         layers->iridescence == 0.0f &&
         (usable(layers->specular_texture) || usable(layers->specular_color_texture));
}

TexelUse colors_of(const SurfaceOptions& options) {
  TexelUse texels;
  texels.encoding = options.encoding;
  return texels;
}

/// What changes normals before light, or is a factor of ambient light or highlights.
void add_maps(SurfaceState& surface, const Material& material, const SurfaceOptions& options,
              SurfaceBuilder& builder) {
  using Role = raster::TextureRole;
  const MapOverride& own = options.maps;
  if (!own.drawn) return;
  const bool has_bump = builder.can_use(material.bump.texture);
  const bool has_normals = own.bump.has_value() || has_bump || builder.can_use(material.normal_texture);
  surface.drops_normals = has_normals && !options.fragment_normals;
  if (options.fragment_normals && own.bump) {
    builder.add_map(*own.bump, Role::bump, own.bump->height);
  } else if (options.fragment_normals && has_bump) {
    builder.add_map(material.bump.texture, Role::bump, material.bump.height);
    builder.set_bump_form(material.bump.form);
  } else if (options.fragment_normals) {
    builder.add_map(material.normal_texture, Role::normal, material.normal_scale);
  }
  surface.drops_occlusion = builder.can_use(material.occlusion_texture) && !options.fragment_light;
  if (options.fragment_light) {
    builder.add_map(material.occlusion_texture, Role::occlusion, material.occlusion_strength);
  }
  if (own.specularity) {
    builder.add_map(*own.specularity, Role::shine, 1.0f);
  } else {
    builder.add_map(material.specularity_texture, Role::shine, 1.0f, colors_of(options));
  }
}

void set_lit(SurfaceState& surface, const Material& material, const Material* highlights, bool has_colors,
             const SurfaceOptions& options, TextureCache& textures, SurfaceBuilder& builder) {
  const SurfaceContext context = context_of(material, has_colors, options, textures);
  SurfaceCoefficients coefficients = convert_material(material, context, options.reflections, options.limits);
  if (highlights != nullptr) {
    coefficients.specular =
        convert_material(*highlights, context, options.reflections, options.limits).specular;
  }
  set_material(surface, coefficients, material.exact, options);
  if (has_colors) {
    surface.color = coefficients.diffuse;
    surface.color_material = material.exact.ambient ? pipeline::ColorMaterial::diffuse
                                                    : pipeline::ColorMaterial::ambient_and_diffuse;
  }
  const bool reflects = coefficients.reflectance != glm::vec3(0.0f);
  if (reflects && coefficients.reflection_before_texture) builder.add_reflection(coefficients.reflectance);
  builder.add_base_color(material);
  if (reflects && !coefficients.reflection_before_texture) builder.add_reflection(coefficients.reflectance);
  set_emission(surface, material, coefficients.emission, options, textures, builder);
  add_maps(surface, material, options, builder);
  if (highlights == nullptr) return;
  TexelUse alphas;
  alphas.channels = TexelUse::Channels::alpha;
  builder.add_map(highlights->layers->specular_texture, raster::TextureRole::shine, 1.0f, alphas);
  builder.add_map(highlights->layers->specular_color_texture, raster::TextureRole::shine, 1.0f,
                  colors_of(options));
}

/// The mean of the texels at the vertices: pictures of factors can be followed from draw to draw, not from
/// pixel to pixel.
glm::vec4 mean_at_vertices(const TextureUse& use, const Primitive& primitive, raster::Encoding encoding,
                           const TextureCache& textures) {
  constexpr std::size_t kMostSamples = 256;
  const FloatArray& coordinates = primitive.texcoords[static_cast<std::size_t>(use.texcoord_set)];
  const std::size_t vertices = coordinates.size() / 2;
  const std::size_t step = std::max<std::size_t>(1, vertices / kMostSamples);
  glm::dvec4 sum(0.0);
  std::size_t count = 0;
  for (std::size_t i = 0; i < vertices; i += step, ++count) {
    const glm::vec3 at =
        use.transform * glm::vec3(coordinates.data()[2 * i], coordinates.data()[2 * i + 1], 1);
    sum += glm::dvec4(textures.texel(use.texture, glm::vec2(at), encoding));
  }
  if (count == 0) return textures.texel(use.texture, glm::vec2(0.0f), encoding);
  return glm::vec4(sum / static_cast<double>(count));
}

/// The layers with their pictures' means as factors; transmission keeps its picture where that can be drawn.
std::shared_ptr<const MaterialLayers> with_texels(MaterialLayers layers, const Primitive& primitive,
                                                  const SurfaceOptions& options,
                                                  const TextureCache& textures) {
  const auto texel = [&](const TextureUse& use, raster::Encoding encoding) {
    return textures.usable(use.texture) ? mean_at_vertices(use, primitive, encoding, textures)
                                        : glm::vec4(1.0f);
  };
  using raster::Encoding;
  if (layers.specular_glossiness) {
    const glm::vec4 mean = texel(layers.specular_glossiness->texture, options.encoding);
    layers.specular_glossiness->specular *= glm::vec3(mean);
    layers.specular_glossiness->glossiness *= mean.a;
  }
  layers.specular *= texel(layers.specular_texture, Encoding::linear).a;
  layers.specular_color *= glm::vec3(texel(layers.specular_color_texture, options.encoding));
  layers.sheen_color *= glm::vec3(texel(layers.sheen_color_texture, options.encoding));
  layers.clearcoat *= texel(layers.clearcoat_texture, Encoding::linear).r;
  layers.clearcoat_roughness *= texel(layers.clearcoat_roughness_texture, Encoding::linear).g;
  layers.iridescence *= texel(layers.iridescence_texture, Encoding::linear).r;
  layers.thickness *= texel(layers.thickness_texture, Encoding::linear).g;
  return std::make_shared<const MaterialLayers>(std::move(layers));
}

template <class Value>
void replace(std::optional<Value>& value, const std::optional<Value>& by) {
  if (by) value = by;
}

/// The file's material with what the user gave in its place. A colour, metalness or roughness given is meant
/// to be seen, so exact coefficients of the file give way to it.
Material changed(Material material, const MaterialOverride& by) {
  if (by.base_color || by.metallic || by.roughness) material.exact = {};
  if (by.base_color) material.base_color = glm::vec4(*by.base_color, material.base_color.a);
  material.metallic = by.metallic.value_or(material.metallic);
  material.roughness = by.roughness.value_or(material.roughness);
  replace(material.exact.ambient, by.exact.ambient);
  replace(material.exact.diffuse, by.exact.diffuse);
  replace(material.exact.specular, by.exact.specular);
  replace(material.exact.emission, by.exact.emission);
  replace(material.exact.shininess, by.exact.shininess);
  return material;
}

/// Makes the surfaces of one use.
struct SurfaceMaker {
  const Scene& scene;
  const SurfaceUse& use;
  const SurfaceOptions& options;
  TextureCache& textures;
  /// The material with highlights that its pictures have yet to weaken; null where nothing is left to them.
  const Material* highlights = nullptr;

  /// The material by itself.
  SurfaceState base(Material source) const {
    SurfaceState surface = start(source);
    SurfaceBuilder builder(options, textures, surface);
    if (source.layers && source.layers->specular_glossiness) {
      source.roughness = 1.0f - source.layers->specular_glossiness->glossiness;
    }
    if (source.unlit || !use.has_normals) {
      set_unlit(surface, source, builder);
    } else {
      set_lit(surface, source, highlights, use.has_colors, options, textures, builder);
    }
    add_transparency(source, builder);
    if (surface.alpha_mode == AlphaMode::opaque) surface.color.a = surface.material.diffuse.a = 1.0f;
    return surface;
  }

  /// What multiplies the light that comes from behind.
  SurfaceState filter(Material source) const {
    source.metallic *= context_of(source, use.has_colors, options, textures).metallic;
    const MaterialLayers& layers = *source.layers;
    SurfaceState surface = start(source);
    surface.blending = Blending::filter;
    surface.lit = false;
    SurfaceBuilder builder(options, textures, surface);
    glm::vec3 tint = transmitted(source, use.scale);
    if (builder.can_use(layers.transmission_texture)) {
      builder.add_factor(layers.transmission_texture, TexelUse::Channels::red, layers.transmission);
    } else {
      tint *= layers.transmission;
    }
    surface.color = glm::vec4(tint, source.base_color.a);
    builder.add_base_color(source);
    return surface;
  }

  /// What glass sends to the eye itself: the rest of its diffuse light, highlights, reflections.
  SurfaceState light(Material source) const {
    if (!textures.usable(source.layers->transmission_texture.texture) || !options.textures) {
      SurfaceState surface = base(std::move(source));
      surface.blending = Blending::add;
      return surface;
    }
    auto layers = std::make_shared<MaterialLayers>(*source.layers);
    const TextureUse picture = layers->transmission_texture;
    const float factor = layers->transmission;
    layers->transmission = 0.0f;
    source.layers = std::move(layers);
    SurfaceState surface = base(std::move(source));
    surface.blending = Blending::add;
    if (surface.unit_count < raster::kMaxTextureUnits) {
      SurfaceBuilder(options, textures, surface)
          .add_factor(picture, TexelUse::Channels::one_minus_red, factor);
    }
    return surface;
  }

 private:
  /// An opaque material becomes one that is blended: otherwise its opacity would count for nothing.
  void add_transparency(const Material& source, SurfaceBuilder& builder) const {
    if (!has_transparency(source)) return;
    if (options.maps.transparency && options.maps.transparency->picture) {
      builder.add_map(*options.maps.transparency, raster::TextureRole::environment, 1.0f);
    } else {
      builder.add_opacity(source.transparency_texture);
    }
  }

  bool has_transparency(const Material& source) const {
    if (!options.maps.drawn) return false;
    return (options.maps.transparency && options.maps.transparency->picture) ||
           (options.textures && textures.usable(source.transparency_texture.texture));
  }

  SurfaceState start(const Material& source) const {
    SurfaceState surface;
    surface.texture_matrix.fill(glm::mat4(1.0f));
    surface.alpha_mode = source.alpha_mode;
    if (surface.alpha_mode == AlphaMode::opaque && has_transparency(source))
      surface.alpha_mode = AlphaMode::blend;
    surface.alpha_cutoff = source.alpha_cutoff;
    surface.double_sided = source.double_sided;
    if (surface.alpha_mode == AlphaMode::blend) surface.blending = Blending::over;
    return surface;
  }
};

}  // namespace

std::vector<SurfaceState> make_surfaces(const Scene& scene, const SurfaceUse& use,
                                        const SurfaceOptions& given, TextureCache& textures) {
  static const Material kDefaultMaterial;
  Material source = changed(
      use.material == kNone ? kDefaultMaterial : scene.materials[static_cast<std::size_t>(use.material)],
      given.material);
  source.texture = chosen(std::move(source.texture), given.texture);
  if (given.texture.picture) source.base_color_texture = {kGivenPicture};
  if (source.unlit || !use.has_normals) source.layers = nullptr;
  const bool has_place = use.primitive == nullptr || !use.primitive->texcoords[0].empty();
  if (!has_place && (given.maps.bump || given.maps.transparency || given.maps.specularity)) {
    SurfaceOptions without = given;
    without.maps = {};
    without.maps.drawn = given.maps.drawn;
    return make_surfaces(scene, use, without, textures);
  }
  const SurfaceOptions& options = given;
  SurfaceMaker maker{scene, use, options, textures};
  if (!source.layers) return {maker.base(source)};
  Material highlights = source;
  if (shines_by_picture(source, options, textures)) maker.highlights = &highlights;
  source.layers = with_texels(*source.layers, *use.primitive, options, textures);
  std::vector<SurfaceState> surfaces;
  if (source.layers->transmission > 0.0f) {
    surfaces.push_back(maker.filter(source));
    surfaces.push_back(maker.light(source));
  } else {
    surfaces.push_back(maker.base(source));
  }
  if (source.layers->clearcoat > 0.0f) {
    maker.highlights = nullptr;  // the coat is another material
    surfaces.push_back(maker.base(clearcoat_of(source)));
    surfaces.back().blending = surfaces.front().blending == Blending::none ? Blending::coat : Blending::add;
  }
  return surfaces;
}

}  // namespace barrido::scene
