#include "viewer/osmesa/frame_picture.h"

#include <exception>
#include <future>

#include "viewer/osmesa/cannot.h"
#include "viewer/osmesa/context.h"
#include "viewer/osmesa/gl_state.h"

namespace barrido::osmesa {

struct FrameDrawer::Implementation {
  Context context{4, 4};
  Programs programs;

  Implementation() { context.release(); }
  ~Implementation() { context.make_current(4, 4); }  // For the programs' end.

  std::vector<std::uint32_t> draw(const pipeline::AssembledFrame& frame, int width, int height) {
    context.make_current(width, height);
    Textures textures;
    for (const pipeline::AssembledDraw& draw : frame.draws) textures.add_of(draw.state);
    clear(frame.clear);
    for (const pipeline::AssembledDraw& draw : frame.draws) {
      osmesa::draw(draw.state, draw.geometry, textures, programs, width, height);
    }
    gl().Finish();
    std::vector<std::uint32_t> rgba(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    read_rgba8(width, height, rgba.data());
    check_error("reading the frame");
    return rgba;
  }
};

namespace {

/// Runs it on another thread, for OpenGL's current context is a thread's own.
template <class Work>
auto elsewhere(const Work& work) {
  return std::async(std::launch::async, work).get();
}

}  // namespace

FrameDrawer::FrameDrawer() = default;

FrameDrawer::~FrameDrawer() {
  if (implementation_) elsewhere([this] { implementation_.reset(); });
}

FramePicture FrameDrawer::draw(const pipeline::AssembledFrame& frame,
                               const raster::FramebufferOptions& options) {
  follow_the_specification();
  FramePicture picture;
  picture.rgba = elsewhere([&] {
    if (!implementation_) implementation_ = std::make_unique<Implementation>();
    std::vector<std::uint32_t> rgba = implementation_->draw(frame, options.width, options.height);
    implementation_->context.release();
    return rgba;
  });
  picture.cannot = what_opengl_cannot(frame, options);
  return picture;
}

std::string why_missing() {
  try {
    gl();
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace barrido::osmesa
