// What a frame asks for that OpenGL 1.x does not have. Knows structs, no OpenGL.
#pragma once

#include <string>
#include <vector>

#include "pipeline/assembled_frame.h"
#include "raster/tiles/framebuffer.h"

namespace barrido::osmesa {

/// Short names, each once: "lights after the eighth", "R·V highlights at vertices". Empty: the two pictures
/// should be the same but for rounding and for what happens on edges.
std::vector<std::string> what_opengl_cannot(const pipeline::AssembledFrame& frame,
                                            const raster::FramebufferOptions& options);

}  // namespace barrido::osmesa
