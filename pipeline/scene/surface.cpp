#include "pipeline/scene/surface.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace barrido::scene {
namespace {

glm::mat4 texture_matrix(const glm::mat3& transform) {
  glm::mat4 matrix(1.0f);
  matrix[0] = {transform[0].x, transform[0].y, 0, 0};
  matrix[1] = {transform[1].x, transform[1].y, 0, 0};
  matrix[3] = {transform[2].x, transform[2].y, 0, 1};
  return matrix;
}

/// A combination for the colour that leaves the alpha alone.
raster::CombineState combine_colors(raster::CombineFunction function,
                                    std::array<raster::CombineSource, 3> sources) {
  raster::CombineState combine;
  combine.rgb.function = function;
  combine.rgb.source = sources;
  combine.rgb.operand.fill(raster::CombineOperand::color);
  combine.alpha.function = raster::CombineFunction::replace;
  combine.alpha.source[0] = raster::CombineSource::previous;
  return combine;
}

/// Adds units to a surface, first to last in the order of the texturing.
class SurfaceBuilder {
 public:
  SurfaceBuilder(const Scene& scene, const SurfaceOptions& options, TextureCache& textures,
                 SurfaceState& surface)
      : scene_(scene), options_(options), textures_(textures), surface_(surface) {}

  bool can_use(const TextureUse& use) const { return options_.textures && textures_.usable(use.texture); }

  void add_base_color(const TextureUse& use) {
    TexelUse texels;
    texels.opaque = surface_.alpha_mode == AlphaMode::opaque;
    texels.mip_colors = options_.mip_colors;
    add_texture(use, texels, raster::TextureEnvMode::modulate);
  }

  /// One channel of a picture, as greys, times `factor`.
  void add_factor(const TextureUse& use, TexelUse::Channels channels, float factor) {
    TexelUse texels;
    texels.channels = channels;
    texels.opaque = true;
    texels.factor = glm::vec3(factor);
    texels.encoding = raster::Encoding::linear;
    add_texture(use, texels, raster::TextureEnvMode::modulate);
  }

  void add_emissive(const TextureUse& use, const glm::vec3& factor) {
    TexelUse texels;
    texels.opaque = true;  // The mode `add` multiplies alphas.
    texels.factor = factor;
    add_texture(use, texels, raster::TextureEnvMode::add);
  }

  /// previous·(1 − reflectance) + map·reflectance
  void add_reflection(const glm::vec3& reflectance) {
    using Source = raster::CombineSource;
    raster::TextureUnit& unit = next_unit();
    surface_.reflection_unit = surface_.unit_count - 1;
    unit.min_filter = options_.min_filter.value_or(raster::MinFilter::linear_mipmap_linear);
    unit.mag_filter = options_.mag_filter.value_or(raster::MagFilter::linear);
    unit.env_mode = raster::TextureEnvMode::combine;
    unit.combine = combine_colors(raster::CombineFunction::interpolate,
                                  {Source::texture, Source::previous, Source::constant});
    unit.env_color = {reflectance.r, reflectance.g, reflectance.b, 1.0f};
  }

  /// previous + color
  void add_constant(const glm::vec3& color) {
    using Source = raster::CombineSource;
    raster::TextureUnit& unit = next_unit();
    unit.texture = &textures_.white();
    unit.min_filter = raster::MinFilter::nearest;
    unit.mag_filter = raster::MagFilter::nearest;
    unit.env_mode = raster::TextureEnvMode::combine;
    unit.combine =
        combine_colors(raster::CombineFunction::add, {Source::previous, Source::constant, Source::constant});
    unit.env_color = {color.r, color.g, color.b, 0.0f};
  }

 private:
  raster::TextureUnit& next_unit() { return surface_.units[static_cast<std::size_t>(surface_.unit_count++)]; }

  void add_texture(const TextureUse& use, TexelUse texels, raster::TextureEnvMode mode) {
    const Texture& source = scene_.textures[static_cast<std::size_t>(use.texture)];
    const auto index = static_cast<std::size_t>(surface_.unit_count);
    raster::TextureUnit& unit = next_unit();
    unit.min_filter = options_.min_filter.value_or(source.min_filter);
    unit.mag_filter = options_.mag_filter.value_or(source.mag_filter);
    unit.env_mode = mode;
    if (texels.channels == TexelUse::Channels::color) texels.encoding = options_.encoding;
    texels.mipmaps = uses_mipmaps(unit.min_filter);
    unit.texture = &textures_.get(use.texture, texels);
    surface_.texcoord_set[index] = use.texcoord_set;
    surface_.texture_matrix[index] = texture_matrix(use.transform);
  }

  const Scene& scene_;
  const SurfaceOptions& options_;
  TextureCache& textures_;
  SurfaceState& surface_;
};

SurfaceContext context_of(const Material& material, bool has_colors, const SurfaceOptions& options,
                          TextureCache& textures) {
  SurfaceContext context;
  context.vertex_colors = has_colors;
  if (options.textures && textures.usable(material.base_color_texture.texture)) {
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
  if (builder.can_use(material.base_color_texture)) builder.add_base_color(material.base_color_texture);
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

void set_lit(SurfaceState& surface, const Material& material, bool has_colors, const SurfaceOptions& options,
             TextureCache& textures, SurfaceBuilder& builder) {
  const SurfaceCoefficients coefficients = convert_material(
      material, context_of(material, has_colors, options, textures), options.reflections, options.limits);
  set_material(surface, coefficients, material.exact, options);
  if (has_colors) {
    surface.color = coefficients.diffuse;
    surface.color_material = material.exact.ambient ? pipeline::ColorMaterial::diffuse
                                                    : pipeline::ColorMaterial::ambient_and_diffuse;
  }
  const bool reflects = coefficients.reflectance != glm::vec3(0.0f);
  if (reflects && coefficients.reflection_before_texture) builder.add_reflection(coefficients.reflectance);
  if (builder.can_use(material.base_color_texture)) builder.add_base_color(material.base_color_texture);
  if (reflects && !coefficients.reflection_before_texture) builder.add_reflection(coefficients.reflectance);
  set_emission(surface, material, coefficients.emission, options, textures, builder);
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

  /// The material by itself.
  SurfaceState base(Material source) const {
    SurfaceState surface = start(source);
    SurfaceBuilder builder(scene, options, textures, surface);
    if (source.layers && source.layers->specular_glossiness) {
      source.roughness = 1.0f - source.layers->specular_glossiness->glossiness;
    }
    if (source.unlit || !use.has_normals) {
      set_unlit(surface, source, builder);
    } else {
      set_lit(surface, source, use.has_colors, options, textures, builder);
    }
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
    SurfaceBuilder builder(scene, options, textures, surface);
    glm::vec3 tint = transmitted(source, use.scale);
    if (builder.can_use(layers.transmission_texture)) {
      builder.add_factor(layers.transmission_texture, TexelUse::Channels::red, layers.transmission);
    } else {
      tint *= layers.transmission;
    }
    surface.color = glm::vec4(tint, source.base_color.a);
    if (builder.can_use(source.base_color_texture)) builder.add_base_color(source.base_color_texture);
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
      SurfaceBuilder(scene, options, textures, surface)
          .add_factor(picture, TexelUse::Channels::one_minus_red, factor);
    }
    return surface;
  }

 private:
  SurfaceState start(const Material& source) const {
    SurfaceState surface;
    surface.texture_matrix.fill(glm::mat4(1.0f));
    surface.alpha_mode = source.alpha_mode;
    surface.alpha_cutoff = source.alpha_cutoff;
    surface.double_sided = source.double_sided;
    if (source.alpha_mode == AlphaMode::blend) surface.blending = Blending::over;
    return surface;
  }
};

}  // namespace

std::vector<SurfaceState> make_surfaces(const Scene& scene, const SurfaceUse& use,
                                        const SurfaceOptions& options, TextureCache& textures) {
  static const Material kDefaultMaterial;
  Material source = changed(
      use.material == kNone ? kDefaultMaterial : scene.materials[static_cast<std::size_t>(use.material)],
      options.material);
  if (source.unlit || !use.has_normals) source.layers = nullptr;
  const SurfaceMaker maker{scene, use, options, textures};
  if (!source.layers) return {maker.base(source)};
  source.layers = with_texels(*source.layers, *use.primitive, options, textures);
  std::vector<SurfaceState> surfaces;
  if (source.layers->transmission > 0.0f) {
    surfaces.push_back(maker.filter(source));
    surfaces.push_back(maker.light(source));
  } else {
    surfaces.push_back(maker.base(source));
  }
  if (source.layers->clearcoat > 0.0f) {
    surfaces.push_back(maker.base(clearcoat_of(source)));
    surfaces.back().blending = surfaces.front().blending == Blending::none ? Blending::coat : Blending::add;
  }
  return surfaces;
}

}  // namespace barrido::scene
