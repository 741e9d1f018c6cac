#include "random_textures.h"

namespace barrido::raster::testing {
namespace {

constexpr int kWraps = 5;

std::vector<std::uint8_t> random_pixels(RandomBits& random, int width, int height) {
  std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  for (std::uint8_t& byte : rgba) byte = static_cast<std::uint8_t>(random.bits() >> 56);
  return rgba;
}

TextureOptions random_options(RandomBits& random) {
  TextureOptions options;
  options.border_color = random.color(0.0f, 1.0f);
  options.encoding = random.pick({Encoding::linear, Encoding::srgb});
  options.mipmaps = random.chance(85);
  options.seamless = random.chance(60);
  return options;
}

}  // namespace

TexturePool::TexturePool(std::uint64_t seed) {
  RandomBits random(seed);
  // Every pair of wrap modes in both texel formats.
  for (int index = 0; index < kWraps * kWraps * 2; ++index) {
    const int width = random.pick({1, 2, 3, 5, 16, 37, 64, 100, 128});
    const int height = random.pick({1, 2, 3, 7, 16, 20, 64, 75});
    TextureOptions options = random_options(random);
    options.wrap_s = static_cast<Wrap>(index % kWraps);
    options.wrap_t = static_cast<Wrap>(index / kWraps % kWraps);
    options.encoding = index / (kWraps * kWraps) == 0 ? Encoding::linear : Encoding::srgb;
    flat_.push_back(Texture::make_2d({width, height, random_pixels(random, width, height)}, options));
  }
  for (const int side : {1, 2, 5, 8, 16, 33, 64}) {
    for (const Encoding encoding : {Encoding::linear, Encoding::srgb}) {
      std::array<std::vector<std::uint8_t>, kCubeFaces> pixels;
      std::array<Pixels8, kCubeFaces> faces;
      for (std::size_t f = 0; f < kCubeFaces; ++f) {
        pixels[f] = random_pixels(random, side, side);
        faces[f] = {side, side, pixels[f]};
      }
      TextureOptions options = random_options(random);
      options.encoding = encoding;
      cubes_.push_back(Texture::make_cube(faces, options));
    }
  }
}

const Texture& TexturePool::flat(RandomBits& random) const {
  return flat_[static_cast<std::size_t>(random.between(0, static_cast<int>(flat_.size()) - 1))];
}

const Texture& TexturePool::cube(RandomBits& random) const {
  return cubes_[static_cast<std::size_t>(random.between(0, static_cast<int>(cubes_.size()) - 1))];
}

}  // namespace barrido::raster::testing
