// Texels of an environment picture as floats to be filtered, and back to bytes; the same loops serve bytes
// and floats. Must not know: layouts, files.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pipeline/pictures/environment_layout.h"

namespace barrido::scene {

/// Clamps and stores a fraction as a byte, either as it is or encoded as sRGB.
class TexelEncoder {
 public:
  TexelEncoder(float scale, bool srgb);

  std::uint8_t color(float value) const {
    const float scaled = value * scale_;
    const float clamped = scaled > 0.0f ? std::min(scaled, 1.0f) : 0.0f;  // NaN counts as 0
    return table_[static_cast<std::size_t>(clamped * kMaxIndex + 0.5f)];
  }
  static std::uint8_t alpha(float value);

 private:
  static constexpr float kMaxIndex = 65535.0f;  // 20 steps for the smallest step of an sRGB byte

  float scale_;
  std::vector<std::uint8_t> table_;
};

/// Four floats of each pixel of a picture of bytes or floats.
class TexelReader {
 public:
  /// `linearise`: bytes of colour are decoded from sRGB.
  TexelReader(const Picture& picture, bool linearise);

  int width() const { return width_; }
  int height() const { return height_; }
  bool holds_floats() const { return floats_ != nullptr; }

  std::array<float, 4> texel(int x, int y) const {
    const std::size_t at =
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)) * 4;
    if (floats_ != nullptr) return {floats_[at], floats_[at + 1], floats_[at + 2], floats_[at + 3]};
    return {color_[bytes_[at]], color_[bytes_[at + 1]], color_[bytes_[at + 2]],
            static_cast<float>(bytes_[at + 3]) / 255.0f};
  }

 private:
  int width_;
  int height_;
  const std::uint8_t* bytes_ = nullptr;
  const float* floats_ = nullptr;
  std::array<float, 256> color_{};
};

}  // namespace barrido::scene
