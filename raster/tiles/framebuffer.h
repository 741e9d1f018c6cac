// The frame: what the rasterizer leaves behind. Colour and depth as plain arrays that any program can read.
// Knows nothing of triangles. Rows are stored top first, as picture files do; window coordinates (see
// primitive.h) have their origin at the lower left, as OpenGL's have.
#pragma once

#include <array>
#include <cstdint>

#include "raster/base/memory.h"
#include "raster/tiles/resolve.h"

namespace barrido::raster {

/// Precision in which fragments are combined and blended.
enum class ColorFormat {
  rgba8,    ///< 8 bits a channel, clamped to [0, 1] and rounded after every fragment: OpenGL 1.x.
  rgba32f,  ///< 32-bit float, not clamped: values over the maximum survive until tone reproduction (L8).
};

struct FramebufferOptions {
  int width = 0;   ///< Pixels, 1..16384.
  int height = 0;  ///< Pixels, 1..16384.
  ColorFormat format = ColorFormat::rgba8;
  /// rgba32f only: also keep the float colours. The 8-bit picture is always made.
  bool keep_float = false;
  bool keep_depth = true;    ///< Keep the depth values for reading after the frame.
  DisplayTransform display;  ///< rgba32f only: how float colours become the 8-bit picture.
};

struct ClearValues {
  std::array<float, 4> color{0, 0, 0, 0};
  float depth = 1.0f;
};

/// Colour and depth of one frame. All arrays are width × height, row-major, top row first.
class Framebuffer {
 public:
  /// @throws std::invalid_argument when a side is not in 1..16384.
  explicit Framebuffer(const FramebufferOptions& options);

  int width() const { return options_.width; }
  int height() const { return options_.height; }
  const FramebufferOptions& options() const { return options_; }

  /// Packed R, G, B, A bytes in memory order; alpha is straight (not premultiplied).
  PixelArray<std::uint32_t>& color8() { return color8_; }
  const PixelArray<std::uint32_t>& color8() const { return color8_; }

  /// Interleaved R, G, B, A floats; empty until the rasterizer needs or is asked to keep them.
  PixelArray<float>& color_float() { return color_float_; }
  const PixelArray<float>& color_float() const { return color_float_; }

  /// Window-space depth in [0, 1], 0 nearest with OpenGL's default depth range; empty unless kept.
  PixelArray<float>& depth() { return depth_; }
  const PixelArray<float>& depth() const { return depth_; }

  /// Array index of the pixel with window coordinates (x, y), y counted from the bottom row.
  std::size_t index(int x, int window_y) const {
    return static_cast<std::size_t>(height() - 1 - window_y) * static_cast<std::size_t>(width()) +
           static_cast<std::size_t>(x);
  }

 private:
  FramebufferOptions options_;
  PixelArray<std::uint32_t> color8_;
  PixelArray<float> color_float_;
  PixelArray<float> depth_;
};

}  // namespace barrido::raster
