// The peer: llvmpipe through OSMesa, as an application would use it: textures, programs and state are made
// ready before, vertices come from vertex arrays, quality settings are Mesa's own.
#include "tests/osmesa/gl_state.h"  // first: it asks for the prototypes of what came after OpenGL 1.1

#include <GL/osmesa.h>

#include <cstdlib>
#include <stdexcept>

#include "tests/bench/peer.h"

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

void set_arrays(const Mesh& mesh) {
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(mesh.position_components, GL_FLOAT, sizeof(glm::vec4), mesh.position.data());
  if (!mesh.normal.empty()) {
    glEnableClientState(GL_NORMAL_ARRAY);
    glNormalPointer(GL_FLOAT, sizeof(glm::vec3), mesh.normal.data());
  }
  if (!mesh.color.empty()) {
    glEnableClientState(GL_COLOR_ARRAY);
    glColorPointer(4, GL_FLOAT, sizeof(glm::vec4), mesh.color.data());
  }
  for (std::size_t unit = 0; unit < mesh.texcoord.size(); ++unit) {
    if (mesh.texcoord[unit].empty()) continue;
    glClientActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glTexCoordPointer(mesh.texcoord_components[unit], GL_FLOAT, sizeof(glm::vec4),
                      mesh.texcoord[unit].data());
  }
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
  explicit OsmesaDrawer(const crosscheck::ScenePair& scene)
      : scene_(scene), context_(scene.width, scene.height), textures_(scene) {
    const auto& c = scene.clear.color;
    glClearColor(c[0], c[1], c[2], c[3]);
    glClearDepth(scene.clear.depth);
    glDisable(GL_DITHER);
    crosscheck::set_current_values();
    for (const crosscheck::DrawCall& draw : scene.draws) {
      programs_.push_back(crosscheck::begin_shading(draw.state, !draw.mesh.color.empty()));
      glUseProgram(0);
    }
    // All draws of a workload differ in their arrays, and in a state that is set once.
    if (!scene.draws.empty()) set_state(scene.draws.front().state);
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
      throw std::runtime_error("OpenGL error " + std::to_string(error) + " while preparing a workload");
    }
  }

  void draw() override {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (std::size_t i = 0; i < scene_.draws.size(); ++i) {
      if (programs_[i] != 0) glUseProgram(programs_[i]);
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
  std::vector<GLuint> programs_;
};

}  // namespace

std::unique_ptr<Drawer> make_peer_drawer(const crosscheck::ScenePair& scene) {
  return std::make_unique<OsmesaDrawer>(scene);
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
