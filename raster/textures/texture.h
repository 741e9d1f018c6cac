// Textures as the fragment stage samples them: mip chains of texels with a one-texel apron that holds what
// the wrap modes (or a cube map's neighbouring faces) put outside each level. Enters: straight RGBA8 or
// linear RGBA16 pixels. Must not know: files, materials, scenes.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "raster/base/memory.h"

namespace barrido::raster {

inline constexpr int kMaxTextureSide = 16384;

/// GL_TEXTURE_MIN_FILTER (OpenGL 1.3, section 3.8.8), and two filters of the pixel's footprint: the
/// parallelogram that the pixel covers of the texture.
enum class MinFilter : std::uint8_t {
  nearest,
  linear,
  nearest_mipmap_nearest,
  linear_mipmap_nearest,
  nearest_mipmap_linear,
  linear_mipmap_linear,
  footprint,  ///< The mean of all texels under it (Catmull 1978; T18).
  corners,    ///< The mean of the texels at its four corners (Crow 1981; T19).
};

/// GL_TEXTURE_MAG_FILTER.
enum class MagFilter : std::uint8_t { nearest, linear };

/// GL_TEXTURE_WRAP_S/T (OpenGL 1.3 section 3.8.7, 1.4 for mirrored_repeat). `clamp` is OpenGL 1.0's: the
/// coordinate is clamped to [0, 1], so that linear filters blend with the border colour at the edge.
enum class Wrap : std::uint8_t { repeat, mirrored_repeat, clamp_to_edge, clamp_to_border, clamp };

enum class TexelFormat : std::uint8_t {
  rgba8,   ///< Four bytes, used as they are.
  rgba16,  ///< Four 16-bit numbers in linear light, for pictures encoded in sRGB or with high range.
};

/// How the colour bytes of a picture are to be understood.
enum class Encoding : std::uint8_t {
  linear,  ///< Texels are used as they are: OpenGL 1.x and the course.
  srgb,    ///< Colour channels are decoded to linear light before any filter sees them; alpha is linear.
};

/// Pixels of one picture: straight RGBA, 4 bytes each, row-major; row 0 is t = 0.
struct Pixels8 {
  int width = 0;
  int height = 0;
  std::span<const std::uint8_t> rgba;  ///< width × height × 4
};

struct TextureOptions {
  Wrap wrap_s = Wrap::repeat;
  Wrap wrap_t = Wrap::repeat;
  std::array<float, 4> border_color{0, 0, 0, 0};
  Encoding encoding = Encoding::linear;
  bool mipmaps = true;   ///< Build every level down to 1 × 1 (T20).
  bool seamless = true;  ///< Cube maps: filters cross the edges of faces. OpenGL before 3.2 does not.
};

/// One level of one face. Texel (i, j), i in [-1, width], j in [-1, height], stands at
/// data[(j + 1) × pitch_texels + (i + 1)] × (4 or 8 bytes).
struct MipLevel {
  int width = 0;
  int height = 0;
  int pitch_texels = 0;
  std::size_t offset_bytes = 0;  ///< Of texel (-1, -1) from Texture::data().
};

/// Where the levels stand, in texels from Texture::data(), by level number: what address arithmetic looks up.
/// Entries past the last level repeat it.
struct TexelLevels {
  static constexpr int kMaxLevels = 16;
  std::int32_t width[kMaxLevels];
  std::int32_t height[kMaxLevels];
  std::int32_t pitch[kMaxLevels];
  std::int32_t origin[kMaxLevels];       ///< Of texel (0, 0) of face 0.
  std::int32_t face_stride[kMaxLevels];  ///< From one face to the next; 0 when there is one face.
};

/// Order of a cube map's faces, OpenGL's: +X −X +Y −Y +Z −Z.
inline constexpr int kCubeFaces = 6;

/// An immutable two-dimensional texture or cube map with its mip chain.
class Texture {
 public:
  /// @throws std::invalid_argument for sides outside 1..16384 or a wrong number of bytes.
  static Texture make_2d(const Pixels8& base, const TextureOptions& options);
  /// Levels given by the caller, base first, each side max(1, previous / 2).
  static Texture make_2d_levels(std::span<const Pixels8> levels, const TextureOptions& options);
  /// Six square faces of one size in OpenGL's order and orientation (OpenGL 1.3, table 3.19).
  static Texture make_cube(std::span<const Pixels8, kCubeFaces> faces, const TextureOptions& options);

  bool is_cube() const { return face_count_ == kCubeFaces; }
  int face_count() const { return face_count_; }
  TexelFormat format() const { return format_; }
  int level_count() const { return level_count_; }
  int width() const { return levels_[0].width; }
  int height() const { return levels_[0].height; }
  const TextureOptions& options() const { return options_; }

  const MipLevel& level(int level, int face = 0) const {
    return levels_[static_cast<std::size_t>(level * face_count_ + face)];
  }
  const TexelLevels& texel_levels() const { return texel_levels_; }
  const std::uint8_t* data() const { return data_.data(); }

  /// The texel at (i, j) of a level, apron included, in [0, 1]; for tests, views and the scalar reference.
  std::array<float, 4> texel(int level, int face, int i, int j) const;
  /// The interior of one level as bytes (rounded where the texels have 16 bits), row-major without apron.
  std::vector<std::uint8_t> level_rgba8(int level, int face = 0) const;

 private:
  Texture() = default;
  friend class TextureBuilder;

  TextureOptions options_;
  TexelFormat format_ = TexelFormat::rgba8;
  int face_count_ = 1;
  int level_count_ = 0;
  std::vector<MipLevel> levels_;  // level-major: level × face_count_ + face
  TexelLevels texel_levels_{};
  UnclearedArray<std::uint8_t> data_;
};

}  // namespace barrido::raster
