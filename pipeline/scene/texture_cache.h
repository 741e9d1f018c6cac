// Textures built once from a scene's pictures. Enters: which picture, how it is wrapped, filtered and
// encoded; leaves: textures that live as long as the cache, and means of pictures.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <tuple>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "pipeline/scene/scene.h"
#include "raster/textures/texture.h"

namespace barrido::scene {

/// What a texture is used for, as far as its texels depend on it.
struct TexelUse {
  /// The picture's own; greys, of its red or alpha for factors, or of 1 − red; white with the red as alpha.
  enum class Channels : std::uint8_t { color, red, one_minus_red, alpha, red_as_alpha };
  Channels channels = Channels::color;
  raster::Encoding encoding = raster::Encoding::linear;
  bool mipmaps = true;
  bool opaque = false;        ///< Alpha counts as 1 in every texel.
  glm::vec3 factor{1, 1, 1};  ///< The colours are multiplied by this, and clamped, before filtering.
  bool mip_colors =
      false;  ///< Each level has a colour of its own in place of the picture's; see mip_colors.h.
};

bool uses_mipmaps(raster::MinFilter filter);

/// In place of the number of a scene's texture: the picture that the user gave, repeated and filtered as
/// glTF's default is.
inline constexpr int kGivenPicture = -2;

class TextureCache {
 public:
  explicit TextureCache(const Scene& scene) : scene_(scene) {}

  /// The picture that kGivenPicture means from now on; null: none.
  void give(const std::shared_ptr<const Image>& picture);

  /// Whether the scene's texture `texture` (or kNone, or kGivenPicture) has a picture that could be read.
  bool usable(int texture) const;

  /// How the texture is wrapped and filtered.
  const Texture& sampler(int texture) const { return source(texture); }

  /// Texture `texture` of the scene, which must be usable.
  const raster::Texture& get(int texture, const TexelUse& use);

  /// One white texel, for units that only combine constants.
  const raster::Texture& white();

  /// Mean of the picture's colours, decoded to linear light first when `encoding` is srgb.
  glm::vec3 mean(int texture, raster::Encoding encoding);

  /// The texel at these coordinates, wrapped; its colour decoded to linear light when `encoding` is srgb.
  glm::vec4 texel(int texture, const glm::vec2& coordinates, raster::Encoding encoding) const;

 private:
  using Key = std::tuple<int, raster::Wrap, raster::Wrap, raster::Encoding, bool, bool, bool,
                         TexelUse::Channels, std::array<float, 3>>;

  const Texture& source(int texture) const;
  const Image& image(int image) const;
  bool has_alpha(int image);
  raster::Texture build(const Image& image, const TexelUse& use, bool removes_alpha,
                        const raster::TextureOptions& options);

  const Scene& scene_;
  std::shared_ptr<const Image> given_;
  std::map<int, bool> has_alpha_;
  std::map<Key, raster::Texture> textures_;
  std::map<std::pair<int, raster::Encoding>, glm::vec3> means_;
  std::unique_ptr<raster::Texture> white_;
};

}  // namespace barrido::scene
