// Draws a model through the installed libraries; the status is 0 when something of it can be seen.
#include <algorithm>
#include <cstdio>
#include <exception>

#include <barrido/pipeline/gltf/import_gltf.h>
#include <barrido/pipeline/scene/render_scene.h>

int main(int count, char** arguments) {
  if (count != 2) return 2;
  try {
    const barrido::scene::Scene scene = barrido::scene::import_gltf(arguments[1]);
    barrido::scene::SceneRenderer renderer(scene);
    barrido::scene::RenderSettings settings;
    settings.width = 64;
    settings.height = 48;
    const barrido::raster::Framebuffer frame = renderer.render(settings);
    const auto& pixels = frame.color8();
    const bool is_empty = std::all_of(pixels.begin(), pixels.end(), [&](auto p) { return p == pixels[0]; });
    return is_empty ? 1 : 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
