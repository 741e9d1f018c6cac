// The story of a pixel ends in the pixel: random pixels of many scenes, techniques and frame formats.
#include "tests/unit/inspect/inspect_fixture.h"

namespace barrido::inspect {
namespace {

using pipeline::ShadeModel;

constexpr ShadeModel kModes[] = {ShadeModel::flat, ShadeModel::gouraud, ShadeModel::cheap_phong,
                                 ShadeModel::phong};

scene::RenderSettings small_frame(ShadeModel shading) {
  scene::RenderSettings settings;
  settings.width = 200;
  settings.height = 140;
  settings.shading = shading;
  return settings;
}

TEST(ExactStory, EveryModelInEveryMode) {
  for (const char* name :
       {"showcase.glb", "room.glb", "suzanne.glb", "checker_ground.glb", "t_junction.glb"}) {
    const scene::Scene scene = model(name);
    for (const ShadeModel shading : kModes) {
      scene::RenderSettings settings = small_frame(shading);
      settings.keep_float = true;
      expect_exact(scene, settings, 100, name);
      settings.keep_float = false;
      settings.color_management = scene::ColorManagement::none;
      expect_exact(scene, settings, 100, std::string(name) + " in 8 bits");
    }
  }
}

}  // namespace
}  // namespace barrido::inspect
