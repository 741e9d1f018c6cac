#include "raster/textures/texture.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "raster/textures/texture_builder.h"

namespace barrido::raster {
namespace {

std::string size_text(int width, int height) {
  return std::to_string(width) + " × " + std::to_string(height) + " texels";
}

void check(const Pixels8& pixels) {
  if (pixels.width < 1 || pixels.height < 1 || pixels.width > kMaxTextureSide ||
      pixels.height > kMaxTextureSide) {
    throw std::invalid_argument("texture of " + size_text(pixels.width, pixels.height) +
                                ": each side must be in 1.." + std::to_string(kMaxTextureSide));
  }
  const std::size_t expected =
      static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height) * 4;
  if (pixels.rgba.size() != expected) {
    throw std::invalid_argument("texture of " + size_text(pixels.width, pixels.height) + ": " +
                                std::to_string(pixels.rgba.size()) + " bytes given, " +
                                std::to_string(expected) + " needed");
  }
}

}  // namespace

Texture Texture::make_2d(const Pixels8& base, const TextureOptions& options) {
  check(base);
  return TextureBuilder::build({&base, 1}, 1, true, options);
}

Texture Texture::make_2d_levels(std::span<const Pixels8> levels, const TextureOptions& options) {
  if (levels.empty()) throw std::invalid_argument("texture without levels");
  for (std::size_t k = 0; k < levels.size(); ++k) {
    check(levels[k]);
    if (k == 0) continue;
    const Pixels8& above = levels[k - 1];
    const int width = std::max(1, above.width / 2);
    const int height = std::max(1, above.height / 2);
    const bool chain_ended = above.width == 1 && above.height == 1;
    if (chain_ended || levels[k].width != width || levels[k].height != height) {
      throw std::invalid_argument(
          "texture level " + std::to_string(k) + " of " + size_text(levels[k].width, levels[k].height) +
          ": " + (chain_ended ? "level 1 × 1 was the last" : size_text(width, height) + " expected"));
    }
  }
  return TextureBuilder::build(levels, 1, false, options);
}

Texture Texture::make_cube(std::span<const Pixels8, kCubeFaces> faces, const TextureOptions& options) {
  for (const Pixels8& face : faces) {
    check(face);
    if (face.width != face.height || face.width != faces[0].width) {
      throw std::invalid_argument("cube map face of " + size_text(face.width, face.height) +
                                  ": six squares of one size needed");
    }
  }
  return TextureBuilder::build(faces, kCubeFaces, true, options);
}

std::array<float, 4> Texture::texel(int level, int face, int i, int j) const {
  const MipLevel& where = this->level(level, face);
  const std::size_t index = static_cast<std::size_t>(j + 1) * static_cast<std::size_t>(where.pitch_texels) +
                            static_cast<std::size_t>(i + 1);
  const std::uint8_t* base = data_.data() + where.offset_bytes;
  std::array<float, 4> color{};
  for (std::size_t c = 0; c < 4; ++c) {
    color[c] =
        format_ == TexelFormat::rgba8
            ? static_cast<float>(base[index * 4 + c]) / 255.0f
            : static_cast<float>(reinterpret_cast<const std::uint16_t*>(base)[index * 4 + c]) / 65535.0f;
  }
  return color;
}

std::vector<std::uint8_t> Texture::level_rgba8(int level, int face) const {
  const MipLevel& where = this->level(level, face);
  const std::size_t row_channels = static_cast<std::size_t>(where.width) * 4;
  std::vector<std::uint8_t> bytes(row_channels * static_cast<std::size_t>(where.height));
  for (std::size_t j = 0; j < static_cast<std::size_t>(where.height); ++j) {
    const std::size_t first = ((j + 1) * static_cast<std::size_t>(where.pitch_texels) + 1) * 4;
    const std::uint8_t* base = data_.data() + where.offset_bytes;
    for (std::size_t k = 0; k < row_channels; ++k) {
      bytes[j * row_channels + k] =
          format_ == TexelFormat::rgba8
              ? base[first + k]
              : static_cast<std::uint8_t>(
                    (reinterpret_cast<const std::uint16_t*>(base)[first + k] * 255u + 32767u) / 65535u);
    }
  }
  return bytes;
}

}  // namespace barrido::raster
