// Internal to the reference: sets OpenGL's state from the structs, and draws. An OpenGL context must be
// current.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include "tests/osmesa/scene_pair.h"

namespace barrido::crosscheck {

/// Texture objects of a scene pair, in the order of its textures, and deleted with this.
class GlTextures {
 public:
  explicit GlTextures(const ScenePair& pair);
  ~GlTextures();
  GlTextures(const GlTextures&) = delete;
  GlTextures& operator=(const GlTextures&) = delete;
  GLuint name_of(const raster::Texture* texture) const;

 private:
  const ScenePair& pair_;
  std::vector<GLuint> names_;
};

void set_transform(const pipeline::State& state, int frame_width, int frame_height);
/// Normal, colour and texture coordinates of meshes that have no array of them.
void set_current_values();
void set_lighting(const pipeline::State& state);
void set_rasterization(const pipeline::State& state);
void set_fragment_operations(const pipeline::State& state);
void set_texture_units(const pipeline::State& state, const GlTextures& textures);
void draw_mesh(const Mesh& mesh);

/// Program for per-pixel illumination, current until end_shading(); 0 where fixed function does it.
GLuint begin_shading(const pipeline::State& state, bool has_vertex_colors);
void end_shading(GLuint program);

}  // namespace barrido::crosscheck
