// A glTF model, drawn into memory in the four shading modes; for each the mean colour of what is seen and how
// near it is. `model teapot.glb`
#include <cstdio>
#include <exception>

#include <barrido/pipeline/gltf/import_gltf.h>
#include <barrido/pipeline/scene/render_scene.h>

namespace {

struct Mode {
  const char* name;
  barrido::pipeline::ShadeModel shading;
};

constexpr Mode kModes[] = {{"flat", barrido::pipeline::ShadeModel::flat},
                           {"gouraud", barrido::pipeline::ShadeModel::gouraud},
                           {"cheap-phong", barrido::pipeline::ShadeModel::cheap_phong},
                           {"phong", barrido::pipeline::ShadeModel::phong}};

/// Pixels are R, G, B, A in memory; the depth is 1 where nothing was drawn.
void print(const char* name, const barrido::raster::Framebuffer& frame) {
  std::size_t seen = 0;
  double sum[3] = {0, 0, 0};
  float nearest = 1.0f;
  for (std::size_t i = 0; i < frame.color8().size(); ++i) {
    if (frame.depth()[i] == 1.0f) continue;
    const std::uint32_t pixel = frame.color8()[i];
    for (int channel = 0; channel < 3; ++channel) sum[channel] += pixel >> (8 * channel) & 255u;
    if (frame.depth()[i] < nearest) nearest = frame.depth()[i];
    ++seen;
  }
  const double count = seen > 0 ? static_cast<double>(seen) : 1.0;
  std::printf("%-12s %zu pixels, mean colour %.1f %.1f %.1f, nearest depth %.4f\n", name, seen,
              sum[0] / count, sum[1] / count, sum[2] / count, static_cast<double>(nearest));
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: model FILE\n");
    return 2;
  }
  try {
    const barrido::scene::Scene scene = barrido::scene::import_gltf(arguments[1]);
    for (const std::string& warning : scene.warnings) std::fprintf(stderr, "%s\n", warning.c_str());
    barrido::scene::SceneRenderer renderer(scene);
    barrido::scene::RenderSettings settings;
    settings.width = 320;
    settings.height = 240;
    settings.keep_depth = true;
    for (const Mode& mode : kModes) {
      settings.shading = mode.shading;
      print(mode.name, renderer.render(settings));
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
