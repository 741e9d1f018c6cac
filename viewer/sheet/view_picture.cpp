#include "viewer/sheet/view_picture.h"

#include <algorithm>
#include <vector>

#include "viewer/sheet/view_legend.h"

namespace barrido::sheet {

raster::Framebuffer view_picture(const inspect::ViewValues& values, bool with_legend) {
  raster::FramebufferOptions options;
  options.width = values.width;
  const int strip = legend_height(values.width);
  with_legend = with_legend && values.height <= raster::kMaxFrameSide - strip;
  options.height = values.height + (with_legend ? strip : 0);
  options.keep_depth = false;
  raster::Framebuffer picture(options);
  const auto below = std::ranges::copy(inspect::colors_of(values), picture.color8().begin()).out;
  if (with_legend) std::ranges::copy(draw_legend(values), below);
  return picture;
}

raster::Framebuffer draw_view(scene::SceneRenderer& renderer, const scene::RenderSettings& settings,
                              inspect::StructureView view, bool with_legend) {
  return view_picture(inspect::measure_view(renderer, settings, view), with_legend);
}

}  // namespace barrido::sheet
