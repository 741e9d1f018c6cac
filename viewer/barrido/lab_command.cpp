#include <tbb/global_control.h>

#include <fstream>
#include <optional>

#include "pipeline/gltf/import_gltf.h"
#include "pipeline/scene/scene_nodes.h"
#include "raster/base/simd_target.h"
#include "viewer/barrido/commands.h"
#include "viewer/barrido/console.h"
#include "viewer/barrido/frame_plan.h"
#include "viewer/barrido/help.h"
#include "viewer/barrido/lab_options.h"
#include "viewer/barrido/render_call.h"
#include "viewer/barrido/sampling_lab.h"
#include "viewer/barrido/standard_streams.h"

namespace barrido::cli {
namespace {

void write_text(const std::string& path, const std::string& text) {
  make_parent_folder(path);
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw scene::InputError(path, "", "cannot be written");
}

}  // namespace

int run_lab(std::span<const std::string> words) {
  const LabOptions options = parse_lab_options(words);
  if (options.frame.help) {
    write_standard_output(bytes_of(lab_help()));
    return kExitFine;
  }
  std::optional<tbb::global_control> threads;
  if (options.frame.threads > 0) {
    threads.emplace(tbb::global_control::max_allowed_parallelism,
                    static_cast<std::size_t>(options.frame.threads));
  }
  raster::set_simd_target(options.frame.simd);
  CallLimits limits(options.frame.limits);
  const double pixels = static_cast<double>(options.frame.settings.width) * options.frame.settings.height;
  limits.expect_frames(static_cast<std::uint64_t>(pixels) * 128);
  const std::string& path = options.frame.files[0];
  scene::RenderSettings settings = resolved_settings(options.frame);
  settings.environment =
      load_environment(options.frame, limits.open(options.frame.environment_path, true).get());
  scene::ImportOptions import;
  import.budget = limits.open(path);
  import.image_roles = kDrawnImages;
  const scene::Scene scene = scene::import_gltf(path, import);
  const int root = scene::resolve_scene_index(scene, settings.scene_index);
  const auto cameras = scene::camera_nodes(scene, scene::nodes_of_scene(scene, root));
  const FileFacts facts{path, static_cast<int>(cameras.size()), static_cast<int>(scene.animations.size())};
  settings = settings_of(settings, plan_frames(options.frame, facts).front());
  constexpr double kSamplesDrawn = 5000.0;  // of the reference, both grids and adaptive sampling
  limits.draw(path, pixels * kSamplesDrawn);
  scene::SceneRenderer renderer(scene);
  const SamplingFigures figures = measure_sampling(renderer, settings);
  limits.rest();
  if (!options.plot.empty()) write_text(options.plot, figures_svg(figures, model_name(path)));
  write_standard_output(bytes_of(figures_json(figures, path)));
  return kExitFine;
}

}  // namespace barrido::cli
