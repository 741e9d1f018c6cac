// The sRGB transfer function between picture bytes and linear light, for the few places outside the
// rasterizer that compute with colours: averages, built-in maps, colours a user gives as seen on screen.
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "raster/base/portable_math.h"
#include "raster/textures/texture_srgb.h"

namespace barrido::scene {

/// Linear light in [0, 1] of a colour byte (IEC 61966-2-1).
inline float linear_from_srgb8(std::uint8_t byte) {
  return static_cast<float>(raster::kLinear16FromSrgb8[byte]) * (1.0f / 65535.0f);
}

/// Byte in [0, 255] of a linear fraction, without encoding; clamped and rounded to nearest.
inline std::uint8_t byte_from_fraction(float value) {
  const float clamped = value > 0.0f ? std::min(value, 1.0f) : 0.0f;  // NaN counts as 0
  return static_cast<std::uint8_t>(clamped * 255.0f + 0.5f);
}

/// sRGB code of linear light, both in [0, 1] (values outside are clamped).
inline float srgb_from_linear(float linear) {
  const float c = linear > 0.0f ? std::min(linear, 1.0f) : 0.0f;
  return c <= 0.0031308f ? c * 12.92f : 1.055f * portable_pow(c, 1.0f / 2.4f) - 0.055f;
}

/// Linear light of an sRGB code in [0, 1]; codes above 1 continue the curve.
inline float linear_from_srgb(float code) {
  const float c = std::max(code, 0.0f);
  return c <= 0.04045f ? c / 12.92f : portable_pow((c + 0.055f) / 1.055f, 2.4f);
}

inline std::uint8_t srgb8_from_linear(float linear) { return byte_from_fraction(srgb_from_linear(linear)); }

inline glm::vec3 linear_from_srgb(const glm::vec3& code) {
  return {linear_from_srgb(code.x), linear_from_srgb(code.y), linear_from_srgb(code.z)};
}

}  // namespace barrido::scene
