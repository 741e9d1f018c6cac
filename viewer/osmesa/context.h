// An OSMesa context with the memory that it draws into: RGBA with 8 bits a channel, 24 bits of depth.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "viewer/osmesa/gl.h"

namespace barrido::osmesa {

/// Switches llvmpipe's short cuts in texture filters off, so that it does what the specification says. Has an
/// effect before the first context only.
void follow_the_specification();

class Context {
 public:
  /// Current on this thread, with a frame of this size. @throws std::runtime_error when OSMesa gives none.
  Context(int width, int height);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// Makes it current on this thread, with an empty frame. @throws std::runtime_error when OSMesa refuses.
  void make_current(int width, int height);
  /// Takes it away from this thread; another may make it current then.
  void release();

  /// GL_RENDERER and GL_VERSION: "llvmpipe (LLVM 15.0.6, 512 bits), OpenGL 4.5 … Mesa 22.3.6".
  std::string description() const;

 private:
  OSMesaContext handle_ = nullptr;
  std::vector<std::uint8_t> buffer_;
};

/// The current context's colours: width × height RGBA bytes, top row first.
void read_rgba8(int width, int height, void* rgba);

}  // namespace barrido::osmesa
