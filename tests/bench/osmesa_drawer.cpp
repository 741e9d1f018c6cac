// The peer: llvmpipe through OSMesa, as an application would use it: textures, programs and state are made
// ready before, vertices come from vertex arrays, quality settings are Mesa's own.
#include "tests/osmesa/gl_state.h"  // first: it asks for the prototypes of what came after OpenGL 1.1

#include <GL/osmesa.h>

#include <cstdlib>
#include <map>
#include <stdexcept>

#include "tests/bench/peer.h"
#include "tests/osmesa/gl_texture_stages.h"

namespace barrido::bench {
namespace {

using crosscheck::Mesh;

/// A context and the memory that it draws into.
struct Context {
  OSMesaContext handle = nullptr;
  std::vector<std::uint8_t> buffer;

  Context(int width, int height) {
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              24,
                              OSMESA_PROFILE,
                              OSMESA_COMPAT_PROFILE,
                              OSMESA_STENCIL_BITS,
                              0,
                              0};
    handle = OSMesaCreateContextAttribs(attributes, nullptr);
    if (handle == nullptr) throw std::runtime_error("OSMesa gives no context");
    buffer.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    if (!OSMesaMakeCurrent(handle, buffer.data(), GL_UNSIGNED_BYTE, width, height)) {
      throw std::runtime_error("OSMesa cannot draw into the buffer");
    }
  }
  ~Context() { OSMesaDestroyContext(handle); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
};

void enable_array(GLenum array, bool on) { on ? glEnableClientState(array) : glDisableClientState(array); }

void set_arrays(const Mesh& mesh) {
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(mesh.position_components, GL_FLOAT, sizeof(glm::vec4), mesh.position.data());
  enable_array(GL_NORMAL_ARRAY, !mesh.normal.empty());
  if (!mesh.normal.empty()) glNormalPointer(GL_FLOAT, sizeof(glm::vec3), mesh.normal.data());
  enable_array(GL_COLOR_ARRAY, !mesh.color.empty());
  if (!mesh.color.empty()) glColorPointer(4, GL_FLOAT, sizeof(glm::vec4), mesh.color.data());
  for (std::size_t unit = 0; unit < mesh.texcoord.size(); ++unit) {
    glClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    enable_array(GL_TEXTURE_COORD_ARRAY, !mesh.texcoord[unit].empty());
    if (mesh.texcoord[unit].empty()) continue;
    glTexCoordPointer(mesh.texcoord_components[unit], GL_FLOAT, sizeof(glm::vec4),
                      mesh.texcoord[unit].data());
  }
}

/// Switches off what a draw before may have switched on and this one does not use.
void disable_unused(const pipeline::State& state) {
  if (state.lighting.color_material == pipeline::ColorMaterial::none) glDisable(GL_COLOR_MATERIAL);
  for (std::size_t i = 0; i < state.texture_units.size(); ++i) {
    const raster::Texture* const texture = state.texture_units[i].texture;
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
    if (texture == nullptr || texture->is_cube()) glDisable(GL_TEXTURE_2D);
    if (texture == nullptr || !texture->is_cube()) glDisable(GL_TEXTURE_CUBE_MAP);
    for (std::size_t axis = 0; axis < 4; ++axis) {
      const bool generated = texture != nullptr && state.texture_coordinates[i].generation[axis].enabled;
      if (!generated) glDisable(GL_TEXTURE_GEN_S + static_cast<GLenum>(axis));
    }
  }
  glActiveTexture(GL_TEXTURE0);
}

/// What the text of a draw's program depends on; draws that agree share one.
std::string program_key(const pipeline::State& state, bool has_colors) {
  const pipeline::Lighting& lighting = state.lighting;
  std::string key;
  for (const int part :
       {static_cast<int>(state.shade_model), static_cast<int>(lighting.enabled),
        static_cast<int>(lighting.lights.size()), static_cast<int>(lighting.local_viewer),
        static_cast<int>(lighting.two_sided), static_cast<int>(lighting.specular_model),
        static_cast<int>(lighting.separate_specular), static_cast<int>(state.cheap_phong_power),
        has_colors ? static_cast<int>(lighting.color_material) : 0}) {
    key += std::to_string(part) + ' ';
  }
  return key + crosscheck::vertex_texture_stages(state) + crosscheck::fragment_texture_stages(state);
}

void draw_arrays(const Mesh& mesh) {
  const auto mode = static_cast<GLenum>(mesh.mode);  // the same order as OpenGL's constants
  if (mesh.indices.empty()) {
    glDrawArrays(mode, 0, static_cast<GLsizei>(mesh.position.size()));
  } else {
    glDrawElements(mode, static_cast<GLsizei>(mesh.indices.size()), GL_UNSIGNED_INT, mesh.indices.data());
  }
}

class OsmesaDrawer final : public Drawer {
 public:
  OsmesaDrawer(const crosscheck::ScenePair& scene, PeerStates states)
      : scene_(scene), context_(scene.width, scene.height), textures_(scene) {
    const auto& c = scene.clear.color;
    glClearColor(c[0], c[1], c[2], c[3]);
    glClearDepth(scene.clear.depth);
    glDisable(GL_DITHER);
    crosscheck::set_current_values();
    if (states == PeerStates::one && !scene.draws.empty()) set_state(scene.draws.front().state);
    for (const crosscheck::DrawCall& draw : scene.draws) {
      programs_.push_back(program_of(draw));
      if (states == PeerStates::of_each_draw) states_.push_back(compile_state(draw.state));
    }
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
      throw std::runtime_error("OpenGL error " + std::to_string(error) + " while preparing a workload");
    }
  }

  void draw() override {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (std::size_t i = 0; i < scene_.draws.size(); ++i) {
      if (!states_.empty()) glCallList(states_[i]);
      glUseProgram(programs_[i]);
      set_arrays(scene_.draws[i].mesh);
      draw_arrays(scene_.draws[i].mesh);
    }
    glFinish();
  }

  crosscheck::Picture picture() override {
    crosscheck::Picture picture{scene_.width, scene_.height, {}, {}};
    const auto width = static_cast<std::size_t>(scene_.width);
    picture.color.resize(width * static_cast<std::size_t>(scene_.height));
    for (int row = 0; row < scene_.height; ++row) {  // OpenGL's rows stand bottom first
      const auto to = width * static_cast<std::size_t>(scene_.height - 1 - row);
      glReadPixels(0, row, scene_.width, 1, GL_RGBA, GL_UNSIGNED_BYTE, picture.color.data() + to);
    }
    return picture;
  }

 private:
  GLuint program_of(const crosscheck::DrawCall& draw) {
    const bool has_colors = !draw.mesh.color.empty();
    const auto [slot, is_new] = known_programs_.try_emplace(program_key(draw.state, has_colors), 0);
    if (is_new) slot->second = crosscheck::begin_shading(draw.state, has_colors);
    glUseProgram(0);
    return slot->second;
  }

  /// A display list, as applications have one a material.
  GLuint compile_state(const pipeline::State& state) const {
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    disable_unused(state);
    set_state(state);
    glEndList();
    return list;
  }

  void set_state(const pipeline::State& state) const {
    crosscheck::set_transform(state, scene_.width, scene_.height);
    crosscheck::set_lighting(state);
    crosscheck::set_rasterization(state);
    crosscheck::set_fragment_operations(state);
    crosscheck::set_texture_units(state, textures_);
  }

  const crosscheck::ScenePair& scene_;
  Context context_;
  crosscheck::GlTextures textures_;
  std::map<std::string, GLuint> known_programs_;
  std::vector<GLuint> programs_;
  std::vector<GLuint> states_;  ///< Display lists, one a draw; none where all draws have one state.
};

}  // namespace

std::unique_ptr<Drawer> make_peer_drawer(const crosscheck::ScenePair& scene, PeerStates states) {
  return std::make_unique<OsmesaDrawer>(scene, states);
}

void set_peer_threads(int threads) {
  setenv("LP_NUM_THREADS", threads <= 1 ? "0" : std::to_string(threads).c_str(), 1);
}

std::string peer_description() {
  const Context context(4, 4);
  const auto text = [](GLenum name) { return std::string(reinterpret_cast<const char*>(glGetString(name))); };
  return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

}  // namespace barrido::bench
