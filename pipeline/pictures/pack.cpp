#include "pipeline/pictures/pack.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>

#include "pipeline/pictures/transfer.h"

namespace barrido::scene {
namespace {

void check_view(const ImageView& image) {
  const bool positive = image.width > 0 && image.height > 0;
  const std::size_t values =
      positive ? static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4 : 0;
  const bool bytes_fit = image.rgba8.empty() || image.rgba8.size() == values;
  const bool floats_fit = image.rgba_float.empty() || image.rgba_float.size() == values;
  const bool any = !image.rgba8.empty() || !image.rgba_float.empty();
  if (!positive || !bytes_fit || !floats_fit || !any) {
    throw std::invalid_argument("ImageView: the arrays do not hold width × height × 4 values");
  }
}

/// Four bytes, the first one lowest.
std::uint32_t pixel_at(std::span<const std::uint8_t> rgba, std::size_t i) {
  std::uint32_t pixel;
  std::memcpy(&pixel, rgba.data() + i, sizeof(pixel));
  static_assert(std::endian::native == std::endian::little);
  return pixel;
}

}  // namespace

std::span<const std::uint8_t> bytes_of(const ImageView& image, PixelBytes& storage) {
  check_view(image);
  if (!image.rgba8.empty()) return image.rgba8;
  storage.resize(image.rgba_float.size());
  for (std::size_t i = 0; i < storage.size(); i += 4) {
    for (std::size_t c = 0; c < 3; ++c) storage[i + c] = srgb8_from_linear(image.rgba_float[i + c]);
    storage[i + 3] = byte_from_fraction(image.rgba_float[i + 3]);
  }
  return storage;
}

std::span<const float> floats_of(const ImageView& image, std::vector<float>& storage) {
  check_view(image);
  if (!image.rgba_float.empty()) return image.rgba_float;
  storage.resize(image.rgba8.size());
  for (std::size_t i = 0; i < storage.size(); i += 4) {
    for (std::size_t c = 0; c < 3; ++c) storage[i + c] = linear_from_srgb8(image.rgba8[i + c]);
    storage[i + 3] = static_cast<float>(image.rgba8[i + 3]) / 255.0f;
  }
  return storage;
}

bool is_opaque(std::span<const std::uint8_t> rgba) {
  constexpr std::size_t kBlock = 4096;  // Bytes looked at between two chances to stop.
  for (std::size_t begin = 0; begin < rgba.size(); begin += kBlock) {
    const std::size_t end = std::min(begin + kBlock, rgba.size());
    std::uint32_t all = ~std::uint32_t{0};
    for (std::size_t i = begin; i < end; i += 4) all &= pixel_at(rgba, i);
    if (all >> 24 != 255) return false;
  }
  return true;
}

void compose_over_black(std::span<const std::uint8_t> rgba, std::uint8_t* rgb) {
  for (std::size_t i = 0; i < rgba.size(); i += 4, rgb += 3) {
    const unsigned alpha = rgba[i + 3];
    for (std::size_t c = 0; c < 3; ++c) {
      rgb[c] = static_cast<std::uint8_t>((rgba[i + c] * alpha + 127) / 255);
    }
  }
}

void drop_alpha(std::span<const std::uint8_t> rgba, std::uint8_t* rgb) {
  const std::size_t pixels = rgba.size() / 4;
  for (std::size_t i = 0; i < pixels; ++i) {
    const std::uint32_t pixel = pixel_at(rgba, 4 * i);
    // A fourth byte goes along, for the next pixel to overwrite; not after the last one.
    std::memcpy(rgb + 3 * i, &pixel, i + 1 < pixels ? 4 : 3);
  }
}

std::vector<float> compose_over_black(std::span<const float> rgba) {
  std::vector<float> rgb(rgba.size() / 4 * 3);
  for (std::size_t i = 0, out = 0; i < rgba.size(); i += 4, out += 3) {
    for (std::size_t c = 0; c < 3; ++c) rgb[out + c] = rgba[i + c] * rgba[i + 3];
  }
  return rgb;
}

std::vector<float> associate_alpha(std::span<const float> rgba) {
  std::vector<float> out(rgba.begin(), rgba.end());
  for (std::size_t i = 0; i < out.size(); i += 4) {
    for (std::size_t c = 0; c < 3; ++c) out[i + c] *= out[i + 3];
  }
  return out;
}

}  // namespace barrido::scene
