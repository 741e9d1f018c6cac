#include "pipeline/scene/texture_cache.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include "pipeline/pictures/pack.h"
#include "pipeline/pictures/transfer.h"
#include "pipeline/scene/mip_colors.h"
#include "raster/base/parallel_rows.h"

namespace barrido::scene {
namespace {

using ByteTable = std::array<std::uint8_t, 256>;

/// What each byte of a channel becomes when the light it stands for is multiplied by `factor`.
ByteTable multiplied(float factor, raster::Encoding encoding) {
  ByteTable table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto byte = static_cast<std::uint8_t>(i);
    table[i] = encoding == raster::Encoding::srgb
                   ? srgb8_from_linear(linear_from_srgb8(byte) * factor)
                   : byte_from_fraction(static_cast<float>(byte) / 255.0f * factor);
  }
  return table;
}

PixelBytes changed_texels(const Image& image, const TexelUse& use) {
  std::array<ByteTable, 3> tables;
  for (int channel = 0; channel < 3; ++channel) {
    tables[static_cast<std::size_t>(channel)] = multiplied(use.factor[channel], use.encoding);
  }
  // Where greys are made, every channel comes from one.
  using Channels = TexelUse::Channels;
  const bool is_grey = use.channels != Channels::color;
  const std::size_t red = use.channels == Channels::alpha ? 3 : 0;
  const std::size_t green = is_grey ? red : 1, blue = is_grey ? red : 2;
  if (is_grey) tables[1] = tables[2] = tables[0];
  if (use.channels == Channels::one_minus_red) {
    for (ByteTable& table : tables) {
      for (std::uint8_t& byte : table) byte = static_cast<std::uint8_t>(255 - byte);
    }
  }
  const std::size_t opacity = use.channels == Channels::red_as_alpha ? 0 : 3;
  if (use.channels == Channels::red_as_alpha) {
    for (ByteTable& table : tables) table.fill(255);
  }
  PixelBytes changed(image.rgba.size());
  const std::size_t pitch = static_cast<std::size_t>(image.width) * 4;
  const std::uint8_t alpha = use.opaque ? 255 : 0;
  raster::for_each_row(image.width, image.height, [&](int row) {
    const std::uint8_t* in = image.rgba.data() + static_cast<std::size_t>(row) * pitch;
    std::uint8_t* out = changed.data() + static_cast<std::size_t>(row) * pitch;
    for (std::size_t i = 0; i < pitch; i += 4) {
      // One store a texel.
      const std::array<std::uint8_t, 4> texel{tables[0][in[i + red]], tables[1][in[i + green]],
                                              tables[2][in[i + blue]],
                                              static_cast<std::uint8_t>(in[i + opacity] | alpha)};
      std::memcpy(out + i, texel.data(), texel.size());
    }
  });
  return changed;
}

int nearest_texel(float coordinate, int size, raster::Wrap wrap) {
  if (!(coordinate > -1e6f && coordinate < 1e6f)) return 0;
  const float whole = std::floor(coordinate);
  float place = coordinate;
  if (wrap == raster::Wrap::repeat || wrap == raster::Wrap::mirrored_repeat) place -= whole;
  if (wrap == raster::Wrap::mirrored_repeat && std::fmod(whole, 2.0f) != 0.0f) place = 1.0f - place;
  return std::clamp(static_cast<int>(std::floor(place * static_cast<float>(size))), 0, size - 1);
}

/// How often each byte stands in red, green and blue.
using Histogram = std::array<std::array<std::uint64_t, 256>, 3>;

Histogram color_histogram(std::span<const std::uint8_t> rgba) {
  using Pixels = tbb::blocked_range<std::size_t>;
  constexpr std::size_t kPixelsAPiece = std::size_t{1} << 16;
  const auto count = [rgba](const Pixels& pixels, Histogram histogram) {
    for (std::size_t i = pixels.begin() * 4; i < pixels.end() * 4; i += 4) {
      for (std::size_t channel = 0; channel < 3; ++channel) ++histogram[channel][rgba[i + channel]];
    }
    return histogram;
  };
  const auto join = [](Histogram a, const Histogram& b) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      for (std::size_t byte = 0; byte < 256; ++byte) a[channel][byte] += b[channel][byte];
    }
    return a;
  };
  return tbb::parallel_reduce(Pixels(0, rgba.size() / 4, kPixelsAPiece), Histogram{}, count, join);
}

/// A texture of this size whose levels are of one colour each.
raster::Texture colored_levels(int width, int height, const raster::TextureOptions& options) {
  std::vector<std::vector<std::uint8_t>> texels;
  std::vector<raster::Pixels8> levels;
  for (int level = 0; level == 0 || (options.mipmaps && (width > 1 || height > 1)); ++level) {
    if (level > 0) {
      width = std::max(1, width / 2);
      height = std::max(1, height / 2);
    }
    const MipColor& color = mip_color(level);
    std::vector<std::uint8_t>& rgba = texels.emplace_back();
    rgba.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    for (std::int64_t i = 0; i < std::int64_t{width} * height; ++i) {
      rgba.insert(rgba.end(), {color[0], color[1], color[2], 255});
    }
    levels.push_back({width, height, {}});
  }
  for (std::size_t i = 0; i < levels.size(); ++i) levels[i].rgba = texels[i];
  return raster::Texture::make_2d_levels(levels, options);
}

}  // namespace

bool uses_mipmaps(raster::MinFilter filter) {
  return filter != raster::MinFilter::nearest && filter != raster::MinFilter::linear;
}

void TextureCache::give(const std::shared_ptr<const Image>& picture) {
  if (picture == given_) return;
  given_ = picture;
  has_alpha_.erase(kGivenPicture);
  std::erase_if(textures_, [](const auto& entry) { return std::get<0>(entry.first) == kGivenPicture; });
  std::erase_if(means_, [](const auto& entry) { return entry.first.first == kGivenPicture; });
}

const Texture& TextureCache::source(int texture) const {
  static const Texture kGiven = [] {
    Texture given;
    given.image = kGivenPicture;
    return given;
  }();
  return texture == kGivenPicture ? kGiven : scene_.textures[static_cast<std::size_t>(texture)];
}

const Image& TextureCache::image(int image) const {
  return image == kGivenPicture ? *given_ : scene_.images[static_cast<std::size_t>(image)];
}

bool TextureCache::usable(int texture) const {
  if (texture == kNone || (texture == kGivenPicture && !given_)) return false;
  const int number = source(texture).image;
  return number != kNone && !image(number).rgba.empty();
}

bool TextureCache::has_alpha(int image) {
  const auto [slot, is_new] = has_alpha_.try_emplace(image, false);
  if (is_new) slot->second = !is_opaque(this->image(image).rgba);
  return slot->second;
}

const raster::Texture& TextureCache::get(int texture, const TexelUse& use) {
  const Texture& source = this->source(texture);
  const bool removes_alpha = use.opaque && has_alpha(source.image);
  const Key key{source.image,   source.wrap_s, source.wrap_t,
                use.encoding,   use.mipmaps,   removes_alpha,
                use.mip_colors, use.channels,  {use.factor.r, use.factor.g, use.factor.b}};
  const auto found = textures_.find(key);
  if (found != textures_.end()) return found->second;

  const Image& image = this->image(source.image);
  raster::TextureOptions options;
  options.wrap_s = source.wrap_s;
  options.wrap_t = source.wrap_t;
  options.encoding = use.encoding;
  options.mipmaps = use.mipmaps;
  return textures_.emplace(key, build(image, use, removes_alpha, options)).first->second;
}

raster::Texture TextureCache::build(const Image& image, const TexelUse& use, bool removes_alpha,
                                    const raster::TextureOptions& options) {
  if (use.mip_colors) return colored_levels(image.width, image.height, options);
  PixelBytes own;
  std::span<const std::uint8_t> rgba = image.rgba;
  const bool is_grey = use.channels != TexelUse::Channels::color;
  if (use.factor != glm::vec3(1.0f) || removes_alpha || is_grey) rgba = own = changed_texels(image, use);
  return raster::Texture::make_2d({image.width, image.height, rgba}, options);
}

const raster::Texture& TextureCache::white() {
  if (!white_) {
    const std::array<std::uint8_t, 4> texel{255, 255, 255, 255};
    white_ = std::make_unique<raster::Texture>(raster::Texture::make_2d({1, 1, texel}, {}));
  }
  return *white_;
}

glm::vec4 TextureCache::texel(int texture, const glm::vec2& coordinates, raster::Encoding encoding) const {
  const Texture& source = this->source(texture);
  const Image& image = this->image(source.image);
  const auto column = static_cast<std::size_t>(nearest_texel(coordinates.x, image.width, source.wrap_s));
  const auto row = static_cast<std::size_t>(nearest_texel(coordinates.y, image.height, source.wrap_t));
  const std::uint8_t* rgba = image.rgba.data() + 4 * (row * static_cast<std::size_t>(image.width) + column);
  glm::vec4 texel;
  for (int c = 0; c < 4; ++c) {
    texel[c] = c < 3 && encoding == raster::Encoding::srgb ? linear_from_srgb8(rgba[c])
                                                           : static_cast<float>(rgba[c]) / 255.0f;
  }
  return texel;
}

glm::vec3 TextureCache::mean(int texture, raster::Encoding encoding) {
  const int index = source(texture).image;
  const auto [slot, is_new] = means_.try_emplace({index, encoding}, glm::vec3(0.0f));
  if (!is_new) return slot->second;
  // Histograms first: sums of integers do not depend on the order, and decoding is done 256 times only.
  const Image& image = this->image(index);
  const Histogram histogram = color_histogram(image.rgba);
  const auto texels = static_cast<double>(std::max<std::size_t>(image.rgba.size() / 4, 1));
  for (int channel = 0; channel < 3; ++channel) {
    double sum = 0.0;
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const auto code = static_cast<std::uint8_t>(byte);
      const double value = encoding == raster::Encoding::srgb ? linear_from_srgb8(code) : code / 255.0;
      sum += value * static_cast<double>(histogram[static_cast<std::size_t>(channel)][byte]);
    }
    slot->second[channel] = static_cast<float>(sum / texels);
  }
  return slot->second;
}

}  // namespace barrido::scene
