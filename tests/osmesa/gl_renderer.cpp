#include "tests/osmesa/gl_renderer.h"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

// Before OSMesa's header, which would leave out the functions after OpenGL 1.3.
#include "tests/osmesa/gl_state.h"

#include <GL/osmesa.h>

namespace barrido::crosscheck {
namespace {

void check_error(const char* where) {
  if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
    throw std::runtime_error(std::string("OpenGL error ") + std::to_string(error) + " after " + where);
  }
}

void draw_call(const DrawCall& draw, const ScenePair& pair, const GlTextures& textures) {
  glPushAttrib(GL_ALL_ATTRIB_BITS);
  glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
  glDisable(GL_DITHER);
  set_transform(draw.state, pair.width, pair.height);
  set_current_values();
  set_lighting(draw.state);
  set_rasterization(draw.state);
  set_fragment_operations(draw.state);
  set_texture_units(draw.state, textures);
  const GLuint program = begin_shading(draw.state, !draw.mesh.color.empty());
  draw_mesh(draw.mesh);
  end_shading(program);
  glPopClientAttrib();
  glPopAttrib();
  check_error("a draw");
}

/// OSMesa's rows stand bottom first.
Picture read_back(int width, int height) {
  Picture picture{width, height, {}, {}};
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  picture.color.resize(pixels);
  picture.depth.resize(pixels);
  for (int row = 0; row < height; ++row) {
    const auto at = static_cast<std::size_t>(height - 1 - row) * static_cast<std::size_t>(width);
    glReadPixels(0, row, width, 1, GL_RGBA, GL_UNSIGNED_BYTE, picture.color.data() + at);
    glReadPixels(0, row, width, 1, GL_DEPTH_COMPONENT, GL_FLOAT, picture.depth.data() + at);
  }
  return picture;
}

void draw_scene(const ScenePair& pair) {
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  // As 8 bits hold it, also where the frame has more.
  const auto byte = [&](std::size_t channel) {
    return std::round(pair.clear.color[channel] * 255.0f) / 255.0f;
  };
  glClearColor(byte(0), byte(1), byte(2), byte(3));
  glClearDepth(pair.clear.depth);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const GlTextures textures(pair);
  for (const DrawCall& draw : pair.draws) draw_call(draw, pair, textures);
  glFinish();
}

/// A frame of 16 bits a channel that is drawn into while this lives.
class DeepTarget {
 public:
  DeepTarget(int width, int height) {
    glGenFramebuffers(1, &frame_);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    glGenRenderbuffers(2, buffers_);
    attach(buffers_[0], GL_RGBA16, GL_COLOR_ATTACHMENT0, width, height);
    attach(buffers_[1], GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT, width, height);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
      throw std::runtime_error("OSMesa has no frame of 16 bits a channel");
    }
  }
  ~DeepTarget() {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteRenderbuffers(2, buffers_);
    glDeleteFramebuffers(1, &frame_);
  }
  DeepTarget(const DeepTarget&) = delete;
  DeepTarget& operator=(const DeepTarget&) = delete;

 private:
  static void attach(GLuint buffer, GLenum format, GLenum place, int width, int height) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
  }

  GLuint frame_ = 0;
  GLuint buffers_[2] = {};
};

}  // namespace

struct GlRenderer::Implementation {
  OSMesaContext context = nullptr;
  std::vector<std::uint8_t> buffer;

  void make_current(const ScenePair& pair) {
    buffer.assign(static_cast<std::size_t>(pair.width * pair.height) * 4, 0);
    if (!OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, pair.width, pair.height)) {
      throw std::runtime_error("OSMesa cannot draw into the buffer");
    }
  }
};

GlRenderer::GlRenderer() : implementation_(std::make_unique<Implementation>()) {
  // llvmpipe's short cuts in texture filters are switched off, so that it does what the specification says.
  setenv("GALLIVM_PERF", "no_brilinear,no_rho_approx,no_quad_lod,no_aos_sampling,no_filter_hacks", 0);
  setenv("LP_NUM_THREADS", "0", 0);
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_DEPTH_BITS,
                            24,
                            OSMESA_PROFILE,
                            OSMESA_COMPAT_PROFILE,
                            OSMESA_STENCIL_BITS,
                            0,
                            0};
  implementation_->context = OSMesaCreateContextAttribs(attributes, nullptr);
  if (implementation_->context == nullptr) throw std::runtime_error("OSMesa gives no context");
  implementation_->buffer.resize(64);
  OSMesaMakeCurrent(implementation_->context, implementation_->buffer.data(), GL_UNSIGNED_BYTE, 4, 4);
}

GlRenderer::~GlRenderer() { OSMesaDestroyContext(implementation_->context); }

std::string GlRenderer::description() const {
  const auto text = [](GLenum name) { return std::string(reinterpret_cast<const char*>(glGetString(name))); };
  return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

Picture GlRenderer::draw(const ScenePair& pair) {
  implementation_->make_current(pair);
  draw_scene(pair);
  Picture picture = read_back(pair.width, pair.height);
  check_error("reading the frame");
  return picture;
}

DeepPicture GlRenderer::draw_deep(const ScenePair& pair) {
  implementation_->make_current(pair);
  const DeepTarget target(pair.width, pair.height);
  draw_scene(pair);
  DeepPicture picture;
  picture.color.resize(static_cast<std::size_t>(pair.width) * static_cast<std::size_t>(pair.height));
  for (int row = 0; row < pair.height; ++row) {
    const auto at = static_cast<std::size_t>(pair.height - 1 - row) * static_cast<std::size_t>(pair.width);
    glReadPixels(0, row, pair.width, 1, GL_RGBA, GL_UNSIGNED_SHORT, picture.color.data() + at);
  }
  check_error("reading the frame of 16 bits");
  return picture;
}

}  // namespace barrido::crosscheck
