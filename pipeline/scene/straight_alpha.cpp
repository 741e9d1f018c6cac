#include "pipeline/scene/straight_alpha.h"

#include <algorithm>

#include "raster/base/parallel_rows.h"
#include "raster/reference/fragment_operations.h"
#include "raster/reference/resolve.h"

namespace barrido::scene {

std::array<float, 4> straight_color(const std::array<float, 4>& color, float depth, const Backing& backing) {
  if (depth < backing.depth) return {color[0], color[1], color[2], 1.0f};
  const float alpha = color[3];
  if (!(alpha > 0.0f)) return backing.color;
  if (alpha >= 1.0f) return color;
  return {color[0] / alpha, color[1] / alpha, color[2] / alpha, alpha};
}

void make_straight(raster::Framebuffer& frame, const Backing& backing) {
  namespace reference = raster::reference;
  const raster::FramebufferOptions& options = frame.options();
  const bool is_float = options.format == raster::ColorFormat::rgba32f;
  const auto width = static_cast<std::size_t>(options.width);
  raster::for_each_row(options.width, options.height, [&](int row) {
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t at = static_cast<std::size_t>(row) * width + x;
      std::array<float, 4> color = reference::unpack_rgba8(frame.color8()[at]);
      if (is_float) std::copy_n(&frame.color_float()[4 * at], 4, color.begin());
      const std::array<float, 4> straight = straight_color(color, frame.depth()[at], backing);
      if (straight == color) continue;
      if (is_float) std::copy_n(straight.begin(), 4, &frame.color_float()[4 * at]);
      frame.color8()[at] =
          is_float ? reference::display_color(options.display, straight) : reference::pack_rgba8(straight);
    }
  });
}

}  // namespace barrido::scene
