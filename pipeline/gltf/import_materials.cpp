// Materials: glTF's metallic-roughness factors and texture uses as they stand (their conversion to fixed
// function is the renderer's), with KHR_texture_transform, KHR_materials_unlit and
// KHR_materials_emissive_strength; import_layers.cpp has the other extensions.
#include <algorithm>
#include <cmath>

#include "pipeline/gltf/import_parts.h"
#include "pipeline/gltf/values.h"
#include "pipeline/scene/moving_properties.h"

namespace barrido::scene::gltf {
namespace {

raster::Wrap wrap_of(Import& import, int value) {
  switch (value) {
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
      return raster::Wrap::clamp_to_edge;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
      return raster::Wrap::mirrored_repeat;
    case TINYGLTF_TEXTURE_WRAP_REPEAT:
      return raster::Wrap::repeat;
    default:
      import.report.warn("unknown wrap mode " + std::to_string(value) + " of a sampler: repeat is used");
      return raster::Wrap::repeat;
  }
}

raster::MinFilter min_filter_of(Import& import, int value) {
  switch (value) {
    case TINYGLTF_TEXTURE_FILTER_NEAREST:
      return raster::MinFilter::nearest;
    case TINYGLTF_TEXTURE_FILTER_LINEAR:
      return raster::MinFilter::linear;
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
      return raster::MinFilter::nearest_mipmap_nearest;
    case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST:
      return raster::MinFilter::linear_mipmap_nearest;
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR:
      return raster::MinFilter::nearest_mipmap_linear;
    case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR:
    case -1:  // Not given: the best one.
      return raster::MinFilter::linear_mipmap_linear;
    default:
      import.report.warn("unknown filter " + std::to_string(value) + " of a sampler: the default is used");
      return raster::MinFilter::linear_mipmap_linear;
  }
}

raster::MagFilter mag_filter_of(Import& import, int value) {
  if (value == TINYGLTF_TEXTURE_FILTER_NEAREST) return raster::MagFilter::nearest;
  if (value != TINYGLTF_TEXTURE_FILTER_LINEAR && value != -1) {
    import.report.warn("unknown filter " + std::to_string(value) + " of a sampler: the default is used");
  }
  return raster::MagFilter::linear;
}

/// EXT_texture_webp and KHR_texture_basisu name another picture; the texture's own is for who cannot read
/// that.
void choose_images(Import& import, const tinygltf::Texture& source, Texture& texture) {
  texture.image = source.source < 0 ? kNone : source.source;
  const auto images = static_cast<int>(import.document.image_count());
  for (const char* name : {"KHR_texture_basisu", "EXT_texture_webp"}) {
    const tinygltf::Value& number = member(member(source.extensions, name), "source");
    if (!number.IsNumber()) continue;
    const int image = whole_number(number);
    if (image < 0 || image >= images) {
      import.report.fail(std::string("textures: ") + name,
                         "must name an image, and there are " + std::to_string(images));
    }
    texture.fallback_image = texture.image;
    texture.image = image;
  }
}

void import_textures(Import& import) {
  const tinygltf::Model& model = import.document.model();
  import.scene.textures.reserve(model.textures.size());
  for (const tinygltf::Texture& source : model.textures) {
    Texture texture;
    choose_images(import, source, texture);
    if (source.sampler >= 0) {
      const tinygltf::Sampler& sampler = model.samplers[static_cast<std::size_t>(source.sampler)];
      texture.min_filter = min_filter_of(import, sampler.minFilter);
      texture.mag_filter = mag_filter_of(import, sampler.magFilter);
      texture.wrap_s = wrap_of(import, sampler.wrapS);
      texture.wrap_t = wrap_of(import, sampler.wrapT);
    }
    import.scene.textures.push_back(texture);
  }
}

glm::vec2 vec2_of(const tinygltf::Value& parent, const char* name, glm::vec2 otherwise) {
  const tinygltf::Value& value = member(parent, name);
  if (!value.IsArray()) return otherwise;
  return {to_float(number(item(value, 0))), to_float(number(item(value, 1)))};
}

glm::mat3 matrix_of(const tinygltf::Value& transform) {
  return texture_matrix(vec2_of(transform, "offset", {0, 0}), number(member(transform, "rotation")),
                        vec2_of(transform, "scale", {1, 1}));
}

template <typename TextureInfo>
TextureUse texture_use(Import& import, const TextureInfo& info) {
  return texture_use(import, info.index, info.texCoord, info.extensions);
}

float unit_range(double value) { return std::clamp(to_float(value), 0.0f, 1.0f); }

AlphaMode alpha_mode_of(Import& import, const std::string& text) {
  if (text == "MASK") return AlphaMode::mask;
  if (text == "BLEND") return AlphaMode::blend;
  if (text != "OPAQUE")
    import.report.warn("unknown alphaMode \"" + one_line(text, 40) + "\": OPAQUE is used");
  return AlphaMode::opaque;
}

glm::vec3 emissive_of(const tinygltf::Material& source) {
  double strength = 1.0;
  const auto extension = source.extensions.find("KHR_materials_emissive_strength");
  if (extension != source.extensions.end() && extension->second.Has("emissiveStrength")) {
    strength = extension->second.Get("emissiveStrength").GetNumberAsDouble();
  }
  glm::vec3 emissive;
  for (int c = 0; c < 3; ++c) {
    const double factor = std::max(source.emissiveFactor[static_cast<std::size_t>(c)], 0.0);
    emissive[c] = to_float(factor * strength);
  }
  return emissive;
}

Material material_of(Import& import, const tinygltf::Material& source, const std::string& place) {
  const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
  Material material;
  material.name = source.name;
  for (int c = 0; c < 4; ++c) {
    material.base_color[c] = unit_range(pbr.baseColorFactor[static_cast<std::size_t>(c)]);
  }
  material.metallic = unit_range(pbr.metallicFactor);
  material.roughness = unit_range(pbr.roughnessFactor);
  material.emissive = emissive_of(source);
  material.base_color_texture = texture_use(import, pbr.baseColorTexture);
  material.metallic_roughness_texture = texture_use(import, pbr.metallicRoughnessTexture);
  material.normal_texture = texture_use(import, source.normalTexture);
  material.normal_scale = to_float(source.normalTexture.scale);
  material.occlusion_texture = texture_use(import, source.occlusionTexture);
  material.occlusion_strength = unit_range(source.occlusionTexture.strength);
  material.emissive_texture = texture_use(import, source.emissiveTexture);
  material.alpha_mode = alpha_mode_of(import, source.alphaMode);
  material.alpha_cutoff = std::max(to_float(source.alphaCutoff), 0.0f);
  material.double_sided = source.doubleSided;
  material.unlit = source.extensions.count("KHR_materials_unlit") != 0;
  material.layers = layers_of(import, source, place);
  if (material.layers && material.layers->specular_glossiness) {
    use_specular_glossiness(import, source, place, material);
  }
  return material;
}

}  // namespace

TextureUse texture_use(Import& import, int index, int set, const tinygltf::ExtensionMap& extensions) {
  TextureUse use;
  if (index < 0) return use;
  const auto extension = extensions.find("KHR_texture_transform");
  if (extension != extensions.end()) {
    use.transform = matrix_of(extension->second);
    if (const int other = whole_number(member(extension->second, "texCoord")); other >= 0) set = other;
  }
  if (import.scene.textures[static_cast<std::size_t>(index)].image == kNone) {
    import.report.warn("a texture without a PNG or JPEG image is not drawn");
    return use;
  }
  if (set > 1) {
    import.report.warn("texture coordinates beyond TEXCOORD_1 are not supported: TEXCOORD_0 is used");
    set = 0;
  }
  use.texture = index;
  use.texcoord_set = set;
  return use;
}

void import_materials(Import& import) {
  import_textures(import);
  const tinygltf::Model& model = import.document.model();
  import.scene.materials.reserve(model.materials.size());
  for (std::size_t i = 0; i < model.materials.size(); ++i) {
    import.scene.materials.push_back(material_of(import, model.materials[i], element("materials", i)));
  }
  import_material_extras(import);
}

}  // namespace barrido::scene::gltf
