// The texture units of a surface, one after the other, in the order of the texturing. Enters: uses of
// textures; leaves: units with their pictures, procedures, coordinates and environments.
#pragma once

#include "pipeline/scene/surface.h"

namespace barrido::scene {

/// Adds units to a surface, first to last in the order of the texturing.
class SurfaceBuilder {
 public:
  SurfaceBuilder(const SurfaceOptions& options, TextureCache& textures, SurfaceState& surface)
      : options_(options), textures_(textures), surface_(surface) {}

  bool can_use(const TextureUse& use) const { return options_.textures && textures_.usable(use.texture); }

  /// The base colour's texture, if there is one: a procedure, or a picture, which a mapping may place.
  void add_base_color(const Material& material);
  /// One channel of a picture, as greys, times `factor`.
  void add_factor(const TextureUse& use, TexelUse::Channels channels, float factor);
  void add_emissive(const TextureUse& use, const glm::vec3& factor);
  /// previous·(1 − reflectance) + map·reflectance
  void add_reflection(const glm::vec3& reflectance);
  /// previous + color
  void add_constant(const glm::vec3& color);
  /// The picture's red becomes the opacity.
  void add_opacity(const TextureUse& use);

  // Maps for stages of their own; nothing where there is no picture or no unit left.
  void add_map(const TextureUse& use, raster::TextureRole role, float strength, const TexelUse& texels = {});
  void add_map(const UserMap& map, raster::TextureRole role, float strength);
  void set_bump_form(raster::BumpForm form);

 private:
  bool has_room() const { return surface_.unit_count < raster::kMaxTextureUnits; }
  raster::TextureUnit& next_unit() { return surface_.units[static_cast<std::size_t>(surface_.unit_count++)]; }
  void add_texture(const TextureUse& use, TexelUse texels, raster::TextureEnvMode mode);
  void add_solid(const Material& material);
  /// The last unit's coordinates come from the draw's positions.
  void place(const TextureChoice& choice);
  void set_role(raster::TextureRole role, float strength);

  const SurfaceOptions& options_;
  TextureCache& textures_;
  SurfaceState& surface_;
};

}  // namespace barrido::scene
