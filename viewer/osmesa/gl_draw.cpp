// Vertex arrays, clears and whole draws.
#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/gtc/type_ptr.hpp>

#include "viewer/osmesa/gl_map_stages.h"
#include "viewer/osmesa/gl_state.h"

namespace barrido::osmesa {
namespace {

constexpr std::size_t kUnits = raster::kMaxTextureUnits;

GLenum unit_name(std::size_t unit) { return GL_TEXTURE0 + static_cast<GLenum>(unit); }

int stride_bytes(const pipeline::Attribute& attribute) {
  return attribute.stride * static_cast<int>(sizeof(float));
}

bool enable_array(GLenum array, const pipeline::Attribute& attribute) {
  const bool on = attribute.data != nullptr;
  on ? gl().EnableClientState(array) : gl().DisableClientState(array);
  return on;
}

/// Saves what draws change, and restores it.
class SavedState {
 public:
  SavedState() {
    gl().PushAttrib(GL_ALL_ATTRIB_BITS);
    gl().PushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
  }
  ~SavedState() {
    gl().UseProgram(0);
    gl().PopClientAttrib();
    gl().PopAttrib();
  }
  SavedState(const SavedState&) = delete;
  SavedState& operator=(const SavedState&) = delete;
};

}  // namespace

void set_current_values(const pipeline::Geometry& geometry) {
  const glm::vec3& n = geometry.constant_normal;
  const glm::vec4& c = geometry.constant_color;
  gl().Normal3f(n.x, n.y, n.z);
  gl().Color4f(c.r, c.g, c.b, c.a);
  for (std::size_t unit = 0; unit < kUnits; ++unit) {
    gl().MultiTexCoord4fv(unit_name(unit), glm::value_ptr(geometry.constant_texcoord[unit]));
  }
}

void set_arrays(const pipeline::Geometry& geometry) {
  const pipeline::Attribute& p = geometry.position;
  gl().EnableClientState(GL_VERTEX_ARRAY);
  gl().VertexPointer(p.components, GL_FLOAT, stride_bytes(p), p.data);
  if (const auto& n = geometry.normal; enable_array(GL_NORMAL_ARRAY, n)) {
    gl().NormalPointer(GL_FLOAT, stride_bytes(n), n.data);
  }
  if (const auto& c = geometry.color; enable_array(GL_COLOR_ARRAY, c)) {
    gl().ColorPointer(c.components, GL_FLOAT, stride_bytes(c), c.data);
  }
  for (std::size_t unit = 0; unit < kUnits; ++unit) {
    const pipeline::Attribute& t = geometry.texcoord[unit];
    gl().ClientActiveTexture(unit_name(unit));
    if (enable_array(GL_TEXTURE_COORD_ARRAY, t)) {
      gl().TexCoordPointer(t.components, GL_FLOAT, stride_bytes(t), t.data);
    }
  }
}

void draw_arrays(const pipeline::Geometry& geometry) {
  const auto mode = static_cast<GLenum>(geometry.mode);  // the same order as OpenGL's constants
  if (geometry.indices.empty()) {
    gl().DrawArrays(mode, 0, static_cast<GLsizei>(geometry.vertex_count));
  } else {
    gl().DrawElements(mode, static_cast<GLsizei>(geometry.indices.size()), GL_UNSIGNED_INT,
                      geometry.indices.data());
  }
}

void clear(const raster::ClearValues& values) {
  // As 8 bits hold it, also where the frame has more.
  const auto byte = [&](std::size_t channel) { return std::round(values.color[channel] * 255.0f) / 255.0f; };
  gl().ClearColor(byte(0), byte(1), byte(2), byte(3));
  gl().ClearDepth(values.depth);
  gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void draw(const pipeline::State& state, const pipeline::Geometry& geometry, const Textures& textures,
          Programs& programs, int frame_width, int frame_height) {
  const SavedState saved;
  gl().Disable(GL_DITHER);
  set_transform(state, frame_width, frame_height);
  set_current_values(geometry);
  set_lighting(state);
  set_rasterization(state);
  set_fragment_operations(state);
  set_texture_units(state, textures);
  const bool has_colors = geometry.color.data != nullptr;
  const bool has_own_color = has_colors || geometry.constant_color != glm::vec4(1.0f);
  gl().UseProgram(programs.program_of(state, has_own_color));
  // An array of one colour instead of none: Mesa 22.3's colour material does not see the current colour.
  const std::vector<glm::vec4> colors(has_colors ? 0 : geometry.vertex_count, geometry.constant_color);
  pipeline::Geometry complete = geometry;
  if (!colors.empty()) complete.color = {glm::value_ptr(colors[0]), 4, 4};
  set_arrays(complete);
  set_tangents(state, complete);
  draw_arrays(complete);
  check_error("a draw");
}

}  // namespace barrido::osmesa
