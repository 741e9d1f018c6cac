#include "raster/reference/reference_rasterizer.h"

#include "raster/reference/canvas.h"
#include "raster/reference/fragment_operations.h"
#include "raster/reference/fragment_walk.h"
#include "raster/reference/shading.h"

namespace barrido::raster::reference {

void rasterize(std::span<const PrimitiveChunk* const> chunks, const ClearValues& clear,
               Framebuffer& framebuffer) {
  Canvas canvas(framebuffer.options(), clear);
  Fragment fragment;
  for_each_fragment(chunks, {framebuffer.width(), framebuffer.height()}, {}, [&](const FragmentPlace& place) {
    const FragmentState& state = *place.chunk.state;
    if (!is_inside_scissor(state.scissor, place.x, place.y)) return;
    interpolate(place, fragment);
    const Color color = shade_fragment(fragment);
    canvas.apply(state, place.x, place.y, color, fragment.depth);
  });
  canvas.finish();
  canvas.store(framebuffer);
}

}  // namespace barrido::raster::reference
