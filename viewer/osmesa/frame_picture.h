// A frame's draws as OSMesa draws them, an OpenGL that has nothing in common with Barrido, to hold beside
// Barrido's picture. Enters: the draws just before Barrido would rasterize them; leaves: RGBA bytes. Whoever
// includes this sees no OpenGL.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/assembled_frame.h"
#include "raster/tiles/framebuffer.h"

namespace barrido::osmesa {

/// Why frames cannot be drawn here: built without OSMesa, or it is not installed. Empty: they can.
std::string why_missing();

struct FramePicture {
  std::vector<std::uint32_t> rgba;  ///< R, G, B, A bytes in memory order, top row first.
  /// What was asked for and OpenGL 1.x cannot do, so that the picture must differ: "lights after the eighth".
  std::vector<std::string> cannot;
};

class FrameDrawer {
 public:
  FrameDrawer();
  ~FrameDrawer();
  FrameDrawer(const FrameDrawer&) = delete;
  FrameDrawer& operator=(const FrameDrawer&) = delete;

  /// Draws on a thread of its own: an OpenGL that is current on the caller's stays so.
  /// @throws std::runtime_error when OSMesa is missing, and on errors of OpenGL.
  FramePicture draw(const pipeline::AssembledFrame& frame, const raster::FramebufferOptions& options);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace barrido::osmesa
