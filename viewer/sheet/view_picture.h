// A view of a frame's structure as a picture. Enters: a scene, the settings of a frame and a view, or the
// view's values; leaves: false colours above their legend.
#pragma once

#include "pipeline/inspect/structure_view.h"
#include "raster/tiles/framebuffer.h"

namespace barrido::sheet {

/// The values in false colour: 8-bit, opaque, of the frame's size; with a legend that much higher (the
/// picture stands on it, so pixels keep their places from the top).
raster::Framebuffer view_picture(const inspect::ViewValues& values, bool with_legend);

/// Works the view out and draws it. @throws scene::InputError as SceneRenderer::render.
raster::Framebuffer draw_view(scene::SceneRenderer& renderer, const scene::RenderSettings& settings,
                              inspect::StructureView view, bool with_legend = true);

}  // namespace barrido::sheet
