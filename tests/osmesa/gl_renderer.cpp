#include "tests/osmesa/gl_renderer.h"

#include <cstdlib>
#include <stdexcept>

#include "viewer/osmesa/context.h"
#include "viewer/osmesa/gl_state.h"

namespace barrido::crosscheck {
namespace {

using osmesa::check_error;
using osmesa::gl;

/// OSMesa's rows stand bottom first.
Picture read_back(int width, int height) {
  Picture picture{width, height, {}, {}};
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  picture.color.resize(pixels);
  picture.depth.resize(pixels);
  osmesa::read_rgba8(width, height, picture.color.data());
  for (int row = 0; row < height; ++row) {
    const auto at = static_cast<std::size_t>(height - 1 - row) * static_cast<std::size_t>(width);
    gl().ReadPixels(0, row, width, 1, GL_DEPTH_COMPONENT, GL_FLOAT, picture.depth.data() + at);
  }
  return picture;
}

void draw_scene(const ScenePair& pair) {
  osmesa::clear(pair.clear);
  osmesa::Textures textures;
  for (const auto& texture : pair.textures) textures.add(*texture);
  osmesa::Programs programs;
  for (const DrawCall& draw : pair.draws) {
    osmesa::draw(draw.state, draw.mesh.geometry(), textures, programs, pair.width, pair.height);
  }
  gl().Finish();
}

/// A frame of 16 bits a channel that is drawn into while this lives.
class DeepTarget {
 public:
  DeepTarget(int width, int height) {
    gl().GenFramebuffers(1, &frame_);
    gl().BindFramebuffer(GL_FRAMEBUFFER, frame_);
    gl().GenRenderbuffers(2, buffers_);
    attach(buffers_[0], GL_RGBA16, GL_COLOR_ATTACHMENT0, width, height);
    attach(buffers_[1], GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT, width, height);
    if (gl().CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
      throw std::runtime_error("OSMesa has no frame of 16 bits a channel");
    }
  }
  ~DeepTarget() {
    gl().BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl().DeleteRenderbuffers(2, buffers_);
    gl().DeleteFramebuffers(1, &frame_);
  }
  DeepTarget(const DeepTarget&) = delete;
  DeepTarget& operator=(const DeepTarget&) = delete;

 private:
  static void attach(GLuint buffer, GLenum format, GLenum place, int width, int height) {
    gl().BindRenderbuffer(GL_RENDERBUFFER, buffer);
    gl().RenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    gl().FramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
  }

  GLuint frame_ = 0;
  GLuint buffers_[2] = {};
};

}  // namespace

struct GlRenderer::Implementation {
  osmesa::Context context{4, 4};
};

GlRenderer::GlRenderer() {
  osmesa::follow_the_specification();
  setenv("LP_NUM_THREADS", "0", 0);
  implementation_ = std::make_unique<Implementation>();
}

GlRenderer::~GlRenderer() = default;

std::string GlRenderer::description() const { return implementation_->context.description(); }

Picture GlRenderer::draw(const ScenePair& pair) {
  implementation_->context.make_current(pair.width, pair.height);
  draw_scene(pair);
  Picture picture = read_back(pair.width, pair.height);
  check_error("reading the frame");
  return picture;
}

DeepPicture GlRenderer::draw_deep(const ScenePair& pair) {
  implementation_->context.make_current(pair.width, pair.height);
  const DeepTarget target(pair.width, pair.height);
  draw_scene(pair);
  DeepPicture picture;
  picture.color.resize(static_cast<std::size_t>(pair.width) * static_cast<std::size_t>(pair.height));
  for (int row = 0; row < pair.height; ++row) {
    const auto at = static_cast<std::size_t>(pair.height - 1 - row) * static_cast<std::size_t>(pair.width);
    gl().ReadPixels(0, row, pair.width, 1, GL_RGBA, GL_UNSIGNED_SHORT, picture.color.data() + at);
  }
  check_error("reading the frame of 16 bits");
  return picture;
}

}  // namespace barrido::crosscheck
