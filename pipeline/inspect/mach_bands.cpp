#include <algorithm>

#include <tbb/parallel_for.h>

#include "pipeline/inspect/view_observers.h"
#include "raster/reference/resolve.h"

namespace barrido::inspect {
namespace {

/// Luma of the displayed colours (Rec. 709), in 1/255 and not rounded.
std::vector<float> displayed_luma(const raster::Framebuffer& frame) {
  const raster::DisplayTransform& display = frame.options().display;
  std::vector<float> luma(frame.color8().size());
  tbb::parallel_for(std::size_t{0}, luma.size(), [&](std::size_t i) {
    const float* c = frame.color_float().data() + 4 * i;
    const auto shown = [&](std::size_t k) { return raster::reference::display_channel(display, c[k]); };
    luma[i] = (0.2126f * shown(0) + 0.7152f * shown(1) + 0.0722f * shown(2)) * 255.0f;
  });
  return luma;
}

}  // namespace

void differentiate(const raster::Framebuffer& frame, ViewValues& values) {
  const std::vector<float> luma = displayed_luma(frame);
  const int width = frame.width(), height = frame.height();
  const auto at = [&](int x, int y) {
    x = std::clamp(x, 0, width - 1);
    y = std::clamp(y, 0, height - 1);
    return luma[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float around = (at(x - 1, y) + at(x + 1, y)) + (at(x, y - 1) + at(x, y + 1));
      values.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(x)] = around - 4.0f * at(x, y);
    }
  }
}

}  // namespace barrido::inspect
