#include "raster/textures/texture_builder.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "raster/base/parallel_rows.h"
#include "raster/textures/texture_srgb.h"

namespace barrido::raster {
namespace {

/// Levels start at multiples of this many bytes from the first.
constexpr std::size_t kLevelAlignment = 64;

/// Readable texels after the last level besides one row: filters load two or four texels at once.
constexpr std::size_t kPaddingTexels = 8;

void load_row(const std::uint8_t* bytes, int width, Encoding, std::uint8_t* out) {
  std::copy_n(bytes, static_cast<std::size_t>(width) * 4, out);
}

std::uint16_t from_8_bits(std::uint8_t byte) { return static_cast<std::uint16_t>(byte * 257); }

void load_row(const std::uint8_t* bytes, int width, Encoding encoding, std::uint16_t* out) {
  const auto load = [&](auto&& decode) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(width) * 4; k += 4) {
      // One store a texel.
      const std::array<std::uint16_t, 4> texel{decode(bytes[k]), decode(bytes[k + 1]), decode(bytes[k + 2]),
                                               from_8_bits(bytes[k + 3])};
      std::memcpy(out + k, texel.data(), sizeof(texel));
    }
  };
  if (encoding == Encoding::srgb) {
    load([](std::uint8_t byte) { return kLinear16FromSrgb8[byte]; });
  } else {
    load(from_8_bits);
  }
}

template <class Channel>
void load_interior(const Pixels8& pixels, Encoding encoding, const LevelView<Channel>& level) {
  const std::size_t row_bytes = static_cast<std::size_t>(pixels.width) * 4;
  for_each_row(pixels.width, pixels.height, [&](int j) {
    load_row(pixels.rgba.data() + static_cast<std::size_t>(j) * row_bytes, pixels.width, encoding,
             level.at(0, j));
  });
}

/// The border colour is given in linear light, so it is never decoded.
template <class Channel>
void quantize_border(const std::array<float, 4>& color, Channel out[4]) {
  const float scale = static_cast<float>(static_cast<Channel>(~Channel{0}));
  for (std::size_t c = 0; c < 4; ++c) {
    out[c] = static_cast<Channel>(std::min(std::max(color[c], 0.0f), 1.0f) * scale + 0.5f);
  }
}

std::size_t bytes_per_texel(TexelFormat format) { return format == TexelFormat::rgba8 ? 4 : 8; }

TexelLevels list_levels(const Texture& texture) {
  const std::size_t texel_bytes = bytes_per_texel(texture.format());
  TexelLevels list{};
  for (int entry = 0; entry < TexelLevels::kMaxLevels; ++entry) {
    const int number = std::min(entry, texture.level_count() - 1);
    const MipLevel& level = texture.level(number);
    list.width[entry] = level.width;
    list.height[entry] = level.height;
    list.pitch[entry] = level.pitch_texels;
    list.origin[entry] = static_cast<std::int32_t>(level.offset_bytes / texel_bytes) + level.pitch_texels + 1;
    if (texture.is_cube()) {
      const std::size_t face_bytes = texture.level(number, 1).offset_bytes - level.offset_bytes;
      list.face_stride[entry] = static_cast<std::int32_t>(face_bytes / texel_bytes);
    }
  }
  return list;
}

}  // namespace

Texture TextureBuilder::build(std::span<const Pixels8> base_levels, int face_count, bool complete_chain,
                              const TextureOptions& options) {
  Texture texture;
  texture.options_ = options;
  texture.format_ = options.encoding == Encoding::srgb ? TexelFormat::rgba16 : TexelFormat::rgba8;
  texture.face_count_ = face_count;
  lay_out(texture, base_levels, complete_chain && options.mipmaps);
  if (texture.format_ == TexelFormat::rgba8) {
    fill<std::uint8_t>(texture, base_levels);
  } else {
    fill<std::uint16_t>(texture, base_levels);
  }
  return texture;
}

void TextureBuilder::lay_out(Texture& texture, std::span<const Pixels8> base_levels, bool complete_chain) {
  const std::size_t texel_bytes = bytes_per_texel(texture.format_);
  const int given_levels = static_cast<int>(base_levels.size()) / texture.face_count_;
  int width = base_levels[0].width;
  int height = base_levels[0].height;
  std::size_t bytes = 0;
  std::size_t row_bytes = 0;
  for (texture.level_count_ = 0;; ++texture.level_count_) {
    for (int face = 0; face < texture.face_count_; ++face) {
      const MipLevel level{width, height, width + 2, bytes};
      row_bytes = static_cast<std::size_t>(level.pitch_texels) * texel_bytes;
      bytes += row_bytes * static_cast<std::size_t>(height + 2);
      bytes = (bytes + kLevelAlignment - 1) / kLevelAlignment * kLevelAlignment;
      texture.levels_.push_back(level);
    }
    const bool more_given = texture.level_count_ + 1 < given_levels;
    const bool more_filtered = complete_chain && (width > 1 || height > 1);
    if (!more_given && !more_filtered) break;
    width = std::max(1, width / 2);
    height = std::max(1, height / 2);
  }
  ++texture.level_count_;
  texture.texel_levels_ = list_levels(texture);
  texture.data_.resize(bytes + row_bytes + kPaddingTexels * texel_bytes);
  clear_between_levels(texture, texel_bytes);
}

/// The levels, aprons included, are written whole; what lies between and behind them may be read along.
void TextureBuilder::clear_between_levels(Texture& texture, std::size_t texel_bytes) {
  for (std::size_t i = 0; i < texture.levels_.size(); ++i) {
    const MipLevel& level = texture.levels_[i];
    const std::size_t end = level.offset_bytes + static_cast<std::size_t>(level.pitch_texels) *
                                                     static_cast<std::size_t>(level.height + 2) * texel_bytes;
    const bool is_last = i + 1 == texture.levels_.size();
    const std::size_t next = is_last ? texture.data_.size() : texture.levels_[i + 1].offset_bytes;
    std::memset(texture.data_.data() + end, 0, next - end);
  }
}

template <class Channel>
LevelView<Channel> TextureBuilder::view(Texture& texture, int level, int face) {
  return view_level<Channel>(texture.data_.data(), texture.level(level, face));
}

template <class Channel>
void TextureBuilder::fill(Texture& texture, std::span<const Pixels8> base_levels) {
  const int faces = texture.face_count_;
  const int given_levels = static_cast<int>(base_levels.size()) / faces;
  for (int level = 0; level < texture.level_count_; ++level) {
    for (int face = 0; face < faces; ++face) {
      const LevelView<Channel> target = view<Channel>(texture, level, face);
      if (level < given_levels) {
        load_interior(base_levels[static_cast<std::size_t>(level * faces + face)], texture.options_.encoding,
                      target);
      } else {
        halve_level(view<Channel>(texture, level - 1, face), target);
      }
    }
    fill_aprons<Channel>(texture, level);
  }
}

template <class Channel>
void TextureBuilder::fill_aprons(Texture& texture, int level) {
  const TextureOptions& options = texture.options_;
  if (texture.is_cube()) {
    LevelView<Channel> faces[kCubeFaces];
    for (int face = 0; face < kCubeFaces; ++face) faces[face] = view<Channel>(texture, level, face);
    fill_cube_aprons(faces, options.seamless);
    return;
  }
  Channel border[4];
  quantize_border(options.border_color, border);
  fill_apron(view<Channel>(texture, level, 0), options.wrap_s, options.wrap_t, border);
}

}  // namespace barrido::raster
