// The peer: llvmpipe through OSMesa, as an application would use it: textures, programs and state are made
// ready before, vertices come from vertex arrays, quality settings are Mesa's own.
#include <cstdlib>

#include "tests/bench/peer.h"
#include "viewer/osmesa/context.h"
#include "viewer/osmesa/gl_map_stages.h"
#include "viewer/osmesa/gl_state.h"

namespace barrido::bench {
namespace {

using osmesa::gl;

/// Switches off what a draw before may have switched on and this one does not use.
void disable_unused(const pipeline::State& state) {
  if (state.lighting.color_material == pipeline::ColorMaterial::none) gl().Disable(GL_COLOR_MATERIAL);
  for (std::size_t i = 0; i < state.texture_units.size(); ++i) {
    const raster::Texture* const texture = state.texture_units[i].texture;
    gl().ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
    if (texture == nullptr || texture->is_cube()) gl().Disable(GL_TEXTURE_2D);
    if (texture == nullptr || !texture->is_cube()) gl().Disable(GL_TEXTURE_CUBE_MAP);
    for (std::size_t axis = 0; axis < 4; ++axis) {
      const bool generated = texture != nullptr && state.texture_coordinates[i].generation[axis].enabled;
      if (!generated) gl().Disable(GL_TEXTURE_GEN_S + static_cast<GLenum>(axis));
    }
  }
  gl().ActiveTexture(GL_TEXTURE0);
}

class OsmesaDrawer final : public Drawer {
 public:
  OsmesaDrawer(const crosscheck::ScenePair& scene, PeerStates states)
      : scene_(scene), context_(scene.width, scene.height) {
    for (const auto& texture : scene.textures) textures_.add(*texture);
    osmesa::clear(scene.clear);  // Its values stay.
    gl().Disable(GL_DITHER);
    osmesa::set_current_values({});
    if (states == PeerStates::one && !scene.draws.empty()) set_state(scene.draws.front().state);
    for (const crosscheck::DrawCall& draw : scene.draws) {
      programs_.push_back(known_programs_.program_of(draw.state, !draw.mesh.color.empty()));
      geometry_.push_back(draw.mesh.geometry());
      if (states == PeerStates::of_each_draw) states_.push_back(compile_state(draw.state));
    }
    osmesa::check_error("preparing a workload");
  }

  void draw() override {
    gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (std::size_t i = 0; i < scene_.draws.size(); ++i) {
      if (!states_.empty()) gl().CallList(states_[i]);
      gl().UseProgram(programs_[i]);
      osmesa::set_arrays(geometry_[i]);
      osmesa::set_tangents(scene_.draws[i].state, geometry_[i]);
      osmesa::draw_arrays(geometry_[i]);
    }
    gl().Finish();
  }

  crosscheck::Picture picture() override {
    crosscheck::Picture picture{scene_.width, scene_.height, {}, {}};
    picture.color.resize(static_cast<std::size_t>(scene_.width) * static_cast<std::size_t>(scene_.height));
    osmesa::read_rgba8(scene_.width, scene_.height, picture.color.data());
    return picture;
  }

 private:
  /// A display list, as applications have one a material.
  GLuint compile_state(const pipeline::State& state) const {
    const GLuint list = gl().GenLists(1);
    gl().NewList(list, GL_COMPILE);
    disable_unused(state);
    set_state(state);
    gl().EndList();
    return list;
  }

  void set_state(const pipeline::State& state) const {
    osmesa::set_transform(state, scene_.width, scene_.height);
    osmesa::set_lighting(state);
    osmesa::set_rasterization(state);
    osmesa::set_fragment_operations(state);
    osmesa::set_texture_units(state, textures_);
  }

  const crosscheck::ScenePair& scene_;
  osmesa::Context context_;
  osmesa::Textures textures_;
  osmesa::Programs known_programs_;
  std::vector<pipeline::Geometry> geometry_;
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

std::string peer_description() { return osmesa::Context(4, 4).description(); }

}  // namespace barrido::bench
