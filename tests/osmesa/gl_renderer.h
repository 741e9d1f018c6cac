// The reference: draws a scene pair with OSMesa through OpenGL 1.x's fixed-function calls, and Phong and
// cheap Phong through GLSL 1.20 (viewer/osmesa).
#pragma once

#include <memory>
#include <string>

#include "tests/osmesa/scene_pair.h"

namespace barrido::crosscheck {

class GlRenderer {
 public:
  /// Makes an OSMesa context: 8 bits a channel, 24 bits of depth.
  /// @throws std::runtime_error when OSMesa gives none.
  GlRenderer();
  ~GlRenderer();
  GlRenderer(const GlRenderer&) = delete;
  GlRenderer& operator=(const GlRenderer&) = delete;

  /// @throws std::runtime_error on an OpenGL error or a shader that does not compile.
  Picture draw(const ScenePair& pair);
  /// The same with 16 bits a channel, where blending and filters do not round to 8: a second look at pixels
  /// that differ.
  DeepPicture draw_deep(const ScenePair& pair);

  /// GL_RENDERER and GL_VERSION.
  std::string description() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace barrido::crosscheck
