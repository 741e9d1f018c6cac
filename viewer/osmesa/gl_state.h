// Sets OpenGL's state from Barrido's structs, and draws Barrido's geometry. Written from the OpenGL
// specification; shares nothing with Barrido but the structs. A context must be current.
#pragma once

#include <map>
#include <string>

#include "pipeline/geometry.h"
#include "pipeline/state.h"
#include "raster/rasterizer.h"
#include "viewer/osmesa/gl.h"

namespace barrido::osmesa {

/// Mesa has as many as OpenGL 1.x asks for; lights after them are left out.
inline constexpr std::size_t kGlLights = 8;
/// OpenGL 1.x's largest shininess and exponent of a spot, of which larger ones become.
inline constexpr float kGlLargestExponent = 128.0f;

/// Texture objects, deleted with this.
class Textures {
 public:
  Textures() = default;
  ~Textures();
  Textures(const Textures&) = delete;
  Textures& operator=(const Textures&) = delete;
  /// Makes it a texture object, once. It must stay where and as it is.
  void add(const raster::Texture& texture);
  /// Those of the state's units.
  void add_of(const pipeline::State& state);
  /// @throws std::runtime_error for one that was not added.
  GLuint name_of(const raster::Texture* texture) const;

 private:
  std::map<const raster::Texture*, GLuint> names_;
};

/// Programs for per-pixel illumination, one for all draws that agree in its text; deleted with this.
class Programs {
 public:
  Programs() = default;
  ~Programs();
  Programs(const Programs&) = delete;
  Programs& operator=(const Programs&) = delete;
  /// 0 where fixed function does it. None is current afterwards.
  /// @throws std::runtime_error for a shader that does not compile, and texture environments it does not
  /// know.
  GLuint program_of(const pipeline::State& state, bool has_vertex_colors);

 private:
  std::map<std::string, GLuint> programs_;
};

void set_transform(const pipeline::State& state, int frame_width, int frame_height);
/// Normal, colour and texture coordinates of geometry that has no array of them.
void set_current_values(const pipeline::Geometry& geometry);
void set_lighting(const pipeline::State& state);
void set_rasterization(const pipeline::State& state);
void set_fragment_operations(const pipeline::State& state);
void set_texture_units(const pipeline::State& state, const Textures& textures);

/// Points OpenGL's arrays to the geometry's; those that it has not are switched off.
void set_arrays(const pipeline::Geometry& geometry);
/// Draws from the arrays.
void draw_arrays(const pipeline::Geometry& geometry);

void clear(const raster::ClearValues& values);

/// One draw, from OpenGL's default state and back to it.
void draw(const pipeline::State& state, const pipeline::Geometry& geometry, const Textures& textures,
          Programs& programs, int frame_width, int frame_height);

}  // namespace barrido::osmesa
