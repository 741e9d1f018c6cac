#include "pipeline/scene/surface_builder.h"

#include "pipeline/scene/texture_placement.h"

namespace barrido::scene {
namespace {

glm::mat4 texture_matrix(const glm::mat3& transform) {
  glm::mat4 matrix(1.0f);
  matrix[0] = {transform[0].x, transform[0].y, 0, 0};
  matrix[1] = {transform[1].x, transform[1].y, 0, 0};
  matrix[3] = {transform[2].x, transform[2].y, 0, 1};
  return matrix;
}

/// The other way round.
glm::mat3 transform_of(const glm::mat4& m) {
  return {glm::vec3(m[0].x, m[0].y, 0), glm::vec3(m[1].x, m[1].y, 0), glm::vec3(m[3].x, m[3].y, 1)};
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

}  // namespace

void SurfaceBuilder::add_base_color(const Material& material) {
  const TextureChoice& choice = material.texture;
  if (choice.solid && options_.textures) return add_solid(material);
  if (!can_use(material.base_color_texture)) return;
  TexelUse texels;
  texels.opaque = surface_.alpha_mode == AlphaMode::opaque;
  texels.mip_colors = options_.mip_colors;
  texels.encoding = options_.encoding;
  add_texture(material.base_color_texture, texels, raster::TextureEnvMode::modulate);
  raster::TextureUnit& unit = surface_.units[static_cast<std::size_t>(surface_.unit_count - 1)];
  unit.tiles = choice.tiles.value_or(raster::TileChange::none);
  if (choice.mapping) place(choice);
}

void SurfaceBuilder::place(const TextureChoice& choice) {
  const auto index = static_cast<std::size_t>(surface_.unit_count - 1);
  surface_.placed_unit = surface_.unit_count - 1;
  surface_.placed = choice;
  if (choice.mapping) surface_.units[index].mapping = mapping_of(*choice.mapping);
  surface_.texcoord_set[index] = kNone;
}

void SurfaceBuilder::add_solid(const Material& material) {
  const SolidTexture& solid = *material.texture.solid;
  const bool on_surface = solid.space == SolidTexture::Space::surface;
  const auto index = static_cast<std::size_t>(surface_.unit_count);
  raster::TextureUnit& unit = next_unit();
  unit.env_mode = raster::TextureEnvMode::modulate;
  unit.pattern = solid.pattern;
  unit.procedure = on_surface ? &raster::kSurfacePattern : &raster::kSolidPattern;
  if (surface_.alpha_mode == AlphaMode::opaque) {
    for (std::array<float, 4>& color : unit.pattern.colors) color[3] = 1.0f;
  }
  TextureChoice choice = material.texture;
  if (!on_surface) choice.mapping.reset();
  const float cells = solid.scale > 0.0f ? 1.0f / solid.scale : 8.0f;
  if (choice.mapping) {
    choice.mapping->repeats *= cells;
    choice.mapping->offset *= cells;
  }
  if (!on_surface || choice.mapping) return place(choice);
  surface_.texcoord_set[index] = material.base_color_texture.texcoord_set;
  glm::mat4& matrix = surface_.texture_matrix[index] = texture_matrix(material.base_color_texture.transform);
  for (int c = 0; c < 4; ++c) {
    matrix[c].x *= cells;
    matrix[c].y *= cells;
  }
}

void SurfaceBuilder::add_factor(const TextureUse& use, TexelUse::Channels channels, float factor) {
  TexelUse texels;
  texels.channels = channels;
  texels.opaque = true;
  texels.factor = glm::vec3(factor);
  add_texture(use, texels, raster::TextureEnvMode::modulate);
}

void SurfaceBuilder::add_emissive(const TextureUse& use, const glm::vec3& factor) {
  TexelUse texels;
  texels.opaque = true;  // The mode `add` multiplies alphas.
  texels.factor = factor;
  texels.encoding = options_.encoding;
  add_texture(use, texels, raster::TextureEnvMode::add);
}

void SurfaceBuilder::add_reflection(const glm::vec3& reflectance) {
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

void SurfaceBuilder::add_constant(const glm::vec3& color) {
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

void SurfaceBuilder::add_opacity(const TextureUse& use) {
  TexelUse texels;
  texels.channels = TexelUse::Channels::red_as_alpha;
  if (can_use(use) && has_room()) add_texture(use, texels, raster::TextureEnvMode::modulate);
}

void SurfaceBuilder::add_map(const TextureUse& use, raster::TextureRole role, float strength,
                             const TexelUse& texels) {
  if (!can_use(use) || !has_room()) return;
  add_texture(use, texels, raster::TextureEnvMode::modulate);
  set_role(role, strength);
}

void SurfaceBuilder::add_map(const UserMap& map, raster::TextureRole role, float strength) {
  if (!map.picture || !has_room()) return;
  const auto index = static_cast<std::size_t>(surface_.unit_count);
  raster::TextureUnit& unit = next_unit();
  unit.min_filter = options_.min_filter.value_or(raster::MinFilter::linear_mipmap_linear);
  unit.mag_filter = options_.mag_filter.value_or(raster::MagFilter::linear);
  unit.max_anisotropy = options_.max_anisotropy;
  unit.texture = map.picture.get();
  unit.bump_form = map.form;
  surface_.texcoord_set[index] = 0;
  surface_.texture_matrix[index] =
      texture_matrix({glm::vec3(map.repeat.x, 0, 0), glm::vec3(0, map.repeat.y, 0), glm::vec3(0, 0, 1)});
  set_role(role, strength);
}

void SurfaceBuilder::set_bump_form(raster::BumpForm form) {
  if (surface_.normal_unit == kNone) return;
  surface_.units[static_cast<std::size_t>(surface_.normal_unit)].bump_form = form;
}

void SurfaceBuilder::add_texture(const TextureUse& use, TexelUse texels, raster::TextureEnvMode mode) {
  const Texture& source = textures_.sampler(use.texture);
  const auto index = static_cast<std::size_t>(surface_.unit_count);
  raster::TextureUnit& unit = next_unit();
  unit.min_filter = options_.min_filter.value_or(source.min_filter);
  unit.mag_filter = options_.mag_filter.value_or(source.mag_filter);
  unit.max_anisotropy = options_.max_anisotropy;
  unit.env_mode = mode;
  texels.mipmaps = uses_mipmaps(unit.min_filter);
  unit.texture = &textures_.get(use.texture, texels);
  surface_.texcoord_set[index] = use.texcoord_set;
  surface_.texture_matrix[index] = texture_matrix(use.transform);
}

/// Of the unit added last.
void SurfaceBuilder::set_role(raster::TextureRole role, float strength) {
  const int number = surface_.unit_count - 1;
  const auto index = static_cast<std::size_t>(number);
  surface_.units[index].role = role;
  surface_.units[index].strength = strength;
  if (role != raster::TextureRole::normal && role != raster::TextureRole::bump) return;
  surface_.normal_unit = number;
  surface_.tangents = {surface_.texcoord_set[index], transform_of(surface_.texture_matrix[index]),
                       role == raster::TextureRole::bump};
}

}  // namespace barrido::scene
