#include "viewer/osmesa/context.h"

#include <cstdlib>
#include <stdexcept>

namespace barrido::osmesa {

void follow_the_specification() {
  setenv("GALLIVM_PERF", "no_brilinear,no_rho_approx,no_quad_lod,no_aos_sampling,no_filter_hacks", 0);
}

Context::Context(int width, int height) {
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_DEPTH_BITS,
                            24,
                            OSMESA_PROFILE,
                            OSMESA_COMPAT_PROFILE,
                            OSMESA_STENCIL_BITS,
                            0,
                            0};
  handle_ = gl().create_context(attributes, nullptr);
  if (handle_ == nullptr) throw std::runtime_error("OSMesa gives no context");
  try {
    make_current(width, height);
  } catch (...) {
    gl().destroy_context(handle_);
    throw;
  }
}

Context::~Context() { gl().destroy_context(handle_); }

void Context::make_current(int width, int height) {
  buffer_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4, 0);
  if (!gl().make_current(handle_, buffer_.data(), GL_UNSIGNED_BYTE, width, height)) {
    throw std::runtime_error("OSMesa cannot draw into a frame of " + std::to_string(width) + " x " +
                             std::to_string(height) + " pixels");
  }
  gl().PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl().PixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

void Context::release() { gl().make_current(nullptr, nullptr, 0, 0, 0); }

std::string Context::description() const {
  const auto text = [](GLenum name) {
    return std::string(reinterpret_cast<const char*>(gl().GetString(name)));
  };
  return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

void read_rgba8(int width, int height, void* rgba) {
  auto* const bytes = static_cast<std::uint8_t*>(rgba);
  for (int row = 0; row < height; ++row) {  // OpenGL's rows stand bottom first.
    const auto at = static_cast<std::size_t>(height - 1 - row) * static_cast<std::size_t>(width) * 4;
    gl().ReadPixels(0, row, width, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes + at);
  }
}

}  // namespace barrido::osmesa
