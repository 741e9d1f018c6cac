// From an ImageView to the channels a file stores: bytes or floats, with alpha or composed over black.
// Must not know: codecs, paths.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pipeline/pictures/image_io.h"

namespace barrido::scene {

/// The view's bytes, or its floats clamped to [0, 1] and encoded as sRGB where it has no bytes; `storage`
/// holds the latter. @throws std::invalid_argument where the arrays do not fit the size.
std::span<const std::uint8_t> bytes_of(const ImageView& image, PixelBytes& storage);

/// The view's floats, or its bytes decoded from sRGB where it has no floats; `storage` holds the latter.
/// @throws std::invalid_argument where the arrays do not fit the size.
std::span<const float> floats_of(const ImageView& image, std::vector<float>& storage);

bool is_opaque(std::span<const std::uint8_t> rgba);

/// Straight RGBA to RGB over black: c·a/255, rounded to nearest. `rgb` has room for 3 bytes a pixel.
void compose_over_black(std::span<const std::uint8_t> rgba, std::uint8_t* rgb);
/// The same for opaque pixels, where it changes nothing.
void drop_alpha(std::span<const std::uint8_t> rgba, std::uint8_t* rgb);

/// RGB over black: c·a.
std::vector<float> compose_over_black(std::span<const float> rgba);
/// RGBA with colours multiplied by alpha.
std::vector<float> associate_alpha(std::span<const float> rgba);

}  // namespace barrido::scene
