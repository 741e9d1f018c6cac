#include "raster/reference/canvas.h"

#include <algorithm>

#include "raster/reference/fragment_operations.h"
#include "raster/reference/resolve.h"
#include "raster/tiles/pixel_layers.h"

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
  if (!state.sorted) blend_layers(pixel);
  fate.turn = ++turn_;
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
  if (state.sorted) return add_layer(pixel, {&state, fate.incoming, depth, trace});
  write(state, pixel, fate.incoming, fate);
}

/// Of too many layers the farthest does not wait for more.
void Canvas::add_layer(std::size_t pixel, const Layer& layer) {
  std::vector<Layer>& layers = layers_[pixel];
  layers.push_back(layer);
  if (layers.size() <= kMaxPixelLayers) return;
  const auto farthest = std::max_element(layers.begin(), layers.end(),
                                         [](const Layer& a, const Layer& b) { return a.depth < b.depth; });
  FateTrace unused;
  FateTrace& fate = farthest->trace != nullptr ? *farthest->trace : unused;
  fate.turn = ++turn_;
  write(*farthest->state, pixel, farthest->color, fate);
  layers.erase(farthest);
}

/// Farthest first; of equally far ones the first that was drawn.
void Canvas::blend_layers(std::size_t pixel) {
  const auto found = layers_.find(pixel);
  if (found == layers_.end()) return;
  std::vector<Layer> layers = std::move(found->second);
  layers_.erase(found);
  std::stable_sort(layers.begin(), layers.end(),
                   [](const Layer& a, const Layer& b) { return a.depth > b.depth; });
  for (std::size_t i = 0; i < layers.size(); ++i) {
    FateTrace unused;
    FateTrace& fate = layers[i].trace != nullptr ? *layers[i].trace : unused;
    fate.turn = ++turn_;
    fate.layer = static_cast<int>(i) + 1;
    write(*layers[i].state, pixel, layers[i].color, fate);
  }
}

void Canvas::finish() {
  while (!layers_.empty()) blend_layers(layers_.begin()->first);
}

/// Blending, masks and storing.
void Canvas::write(const FragmentState& state, std::size_t pixel, const Color& color, FateTrace& fate) {
  fate.before = color_[pixel];
  fate.blended = blend(state.blend, color, fate.before);
  const Color written = stored_color(fate.blended);
  for (std::size_t c = 0; c < 4; ++c) {
    if (state.color_mask[c]) color_[pixel][c] = written[c];
  }
  fate.after = color_[pixel];
  const BlendState& b = state.blend;
  const auto factors = [&](BlendFactor rgb, BlendFactor a) {
    return blend_factor(rgb, a, color, fate.before, b.constant);
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
