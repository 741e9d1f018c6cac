// In place of all else here where OSMesa was missing when Barrido was built.
#include <stdexcept>

#include "viewer/osmesa/frame_picture.h"

namespace barrido::osmesa {

struct FrameDrawer::Implementation {};

FrameDrawer::FrameDrawer() = default;
FrameDrawer::~FrameDrawer() = default;

FramePicture FrameDrawer::draw(const pipeline::AssembledFrame&, const raster::FramebufferOptions&) {
  throw std::runtime_error(why_missing());
}

std::string why_missing() {
  return "this program was built without OSMesa: install libosmesa6-dev (its name in Debian) and build again";
}

}  // namespace barrido::osmesa
