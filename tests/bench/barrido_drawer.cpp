#include <cstring>

#include "pipeline/renderer.h"
#include "tests/bench/peer.h"

namespace barrido::bench {
namespace {

raster::FramebufferOptions frame_options(const crosscheck::ScenePair& scene) {
  raster::FramebufferOptions options;
  options.width = scene.width;
  options.height = scene.height;
  return options;
}

class BarridoDrawer final : public Drawer {
 public:
  explicit BarridoDrawer(const crosscheck::ScenePair& scene)
      : scene_(scene), frame_(frame_options(scene)), renderer_(frame_) {}

  void draw() override {
    renderer_.clear(scene_.clear);
    for (const crosscheck::DrawCall& draw : scene_.draws) renderer_.draw(draw.state, draw.mesh.geometry());
    renderer_.finish();
  }

  crosscheck::Picture picture() override {
    crosscheck::Picture picture{scene_.width, scene_.height, {}, {}};
    picture.depth.assign(frame_.depth().begin(), frame_.depth().end());
    picture.color.resize(frame_.color8().size());
    std::memcpy(picture.color.data(), frame_.color8().data(), frame_.color8().size() * 4);
    return picture;
  }

 private:
  const crosscheck::ScenePair& scene_;
  raster::Framebuffer frame_;
  pipeline::Renderer renderer_;
};

}  // namespace

std::unique_ptr<Drawer> make_barrido_drawer(const crosscheck::ScenePair& scene) {
  return std::make_unique<BarridoDrawer>(scene);
}

}  // namespace barrido::bench
