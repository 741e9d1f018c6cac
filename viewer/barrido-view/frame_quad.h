// A finished picture on the screen: one textured quad. The only thing that OpenGL draws here besides the
// panel.
#pragma once

#include "viewer/view/picture.h"

namespace barrido::window {

class FrameQuad {
 public:
  /// Needs a current context, here and below.
  FrameQuad();
  ~FrameQuad();
  FrameQuad(const FrameQuad&) = delete;
  FrameQuad& operator=(const FrameQuad&) = delete;

  void set_picture(const view::Picture& picture);
  /// Fills the rectangle (pixels of the window, origin lower left); texels are not blended.
  void draw(int x, int y, int width, int height) const;

 private:
  unsigned texture_ = 0;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace barrido::window
