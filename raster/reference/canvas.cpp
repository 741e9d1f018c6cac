#include "raster/reference/canvas.h"

#include <algorithm>

#include "raster/reference/fragment_operations.h"
#include "raster/reference/resolve.h"

namespace barrido::raster::reference {

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

void Canvas::apply(const FragmentState& state, int x, int y, const Color& color, float depth,
                   FateTrace* trace) {
  FateTrace unused;
  FateTrace& fate = trace != nullptr ? *trace : unused;
  const AlphaTest& alpha = state.alpha_test;
  const std::size_t pixel = index(x, y);
  fate.before = fate.after = color_[pixel];
  fate.depth_before = fate.depth_after = depth_[pixel];
  fate.alpha_passed = !alpha.enabled || compare(alpha.compare, color[3], alpha.reference);
  if (!fate.alpha_passed) return;
  if (state.depth.test) {
    fate.depth_passed = compare(state.depth.compare, depth, depth_[pixel]);
    if (!fate.depth_passed) return;
    if (state.depth.write) depth_[pixel] = depth;
    fate.depth_after = depth_[pixel];
  }
  fate.incoming = incoming_color(color);
  fate.blended = blend(state.blend, fate.incoming, fate.before);
  const Color written = stored_color(fate.blended);
  for (std::size_t c = 0; c < 4; ++c) {
    if (state.color_mask[c]) color_[pixel][c] = written[c];
  }
  fate.after = color_[pixel];
  if (trace == nullptr) return;
  const BlendState& b = state.blend;
  const auto factors = [&](BlendFactor rgb, BlendFactor a) {
    return blend_factor(rgb, a, fate.incoming, fate.before, b.constant);
  };
  fate.source_factor = b.enabled ? factors(b.src_rgb, b.src_alpha) : Color{1, 1, 1, 1};
  fate.destination_factor = b.enabled ? factors(b.dst_rgb, b.dst_alpha) : Color{0, 0, 0, 0};
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
