#include "raster/reference/canvas.h"

#include <algorithm>

#include "raster/portable_math.h"
#include "raster/reference/fragment_operations.h"

namespace barrido::raster::reference {
namespace {

float srgb_encoded(float c) {
  return c <= 0.0031308f ? c * 12.92f : 1.055f * portable_pow(c, 1.0f / 2.4f) - 0.055f;
}

float display_channel(const DisplayTransform& display, float c) {
  c = c * display.exposure_scale;
  if (display.tone_map == ToneMap::reinhard) {
    c = maximum(c, 0.0f);
    c = c / (1.0f + c);
  }
  c = clamp_to_unit(c);
  return display.srgb_encode ? srgb_encoded(c) : c;
}

}  // namespace

std::uint32_t display_color(const DisplayTransform& display, const Color& color) {
  Color shown = color;
  for (std::size_t c = 0; c < 3; ++c) shown[c] = display_channel(display, color[c]);
  return pack_rgba8(shown);
}

Canvas::Canvas(const FramebufferOptions& options, const ClearValues& clear) : options_(options) {
  const std::size_t pixels =
      static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height);
  color_.assign(pixels, stored_color(clear.color));
  depth_.assign(pixels, clear.depth);
}

/// What is read back after storing `color`.
Color Canvas::stored_color(Color color) const {
  return options_.format == ColorFormat::rgba8 ? unpack_rgba8(pack_rgba8(color)) : color;
}

Color Canvas::incoming_color(Color color) const {
  if (options_.format == ColorFormat::rgba8) {
    for (float& channel : color) channel = clamp_to_unit(channel);
  }
  return color;
}

void Canvas::apply(const FragmentState& state, int x, int y, const Color& color, float depth) {
  const AlphaTest& alpha = state.alpha_test;
  if (alpha.enabled && !compare(alpha.compare, color[3], alpha.reference)) return;
  const std::size_t pixel = index(x, y);
  if (state.depth.test) {
    if (!compare(state.depth.compare, depth, depth_[pixel])) return;
    if (state.depth.write) depth_[pixel] = depth;
  }
  const Color old = color_[pixel];
  const Color written = stored_color(blend(state.blend, incoming_color(color), old));
  for (std::size_t c = 0; c < 4; ++c) {
    if (state.color_mask[c]) color_[pixel][c] = written[c];
  }
}

void Canvas::store(Framebuffer& framebuffer) const {
  const bool is_float = options_.format == ColorFormat::rgba32f;
  for (int y = 0; y < options_.height; ++y) {
    for (int x = 0; x < options_.width; ++x) {
      const std::size_t to = framebuffer.index(x, y);
      const Color& color = color_[index(x, y)];
      framebuffer.color8()[to] = is_float ? display_color(options_.display, color) : pack_rgba8(color);
      if (!framebuffer.color_float().empty()) {
        std::copy(color.begin(), color.end(),
                  framebuffer.color_float().begin() + static_cast<std::ptrdiff_t>(to * 4));
      }
      if (!framebuffer.depth().empty()) framebuffer.depth()[to] = depth_[index(x, y)];
    }
  }
}

}  // namespace barrido::raster::reference
