#include <tbb/global_control.h>

#include <optional>

#include "pipeline/inspect/pixel_story.h"
#include "pipeline/scene/scene_nodes.h"
#include "raster/base/simd_target.h"
#include "viewer/barrido/commands.h"
#include "viewer/barrido/console.h"
#include "viewer/barrido/frame_plan.h"
#include "viewer/barrido/help.h"
#include "viewer/barrido/inspect_options.h"
#include "viewer/barrido/map_spec.h"
#include "viewer/barrido/standard_streams.h"

namespace barrido::cli {
namespace {

/// The settings of the one frame that the options ask for.
scene::RenderSettings settings_of_frame(const RenderOptions& options, const scene::Scene& scene,
                                        CallLimits& limits) {
  scene::RenderSettings settings = resolved_settings(options);
  settings.environment = load_environment(options, limits.open(options.environment_path, true).get());
  if (const std::vector<std::string> maps = map_paths(settings); !maps.empty()) {
    load_maps(settings, limits.open(maps.front(), true).get());
  }
  if (!options.texture_path.empty()) {
    settings.texture.picture = load_texture(options, limits.open(options.texture_path, true).get());
  }
  if (scene::UserDisplacement& displacement = settings.displacement; displacement.names_picture()) {
    displacement.picture = load_heights(displacement, limits.open(displacement.source, true).get());
  }
  const int root = scene::resolve_scene_index(scene, settings.scene_index);
  const auto cameras = scene::camera_nodes(scene, scene::nodes_of_scene(scene, root));
  const FileFacts facts{shown_file(options.files[0]), static_cast<int>(cameras.size()),
                        static_cast<int>(scene.animations.size())};
  return settings_of(settings, plan_frames(options, facts).front());
}

}  // namespace

int run_inspect(std::span<const std::string> words) {
  const InspectOptions options = parse_inspect_options(words);
  if (options.frame.help) {
    write_standard_output(bytes_of(inspect_help()));
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
  limits.expect_frames(static_cast<std::uint64_t>(pixels) * 64);
  scene::ImportOptions import;
  import.budget = limits.open(shown_file(options.frame.files[0]));
  import.image_roles = kDrawnImages;
  const scene::Scene scene = read_model(options.frame.files[0], import);
  scene::SceneRenderer renderer(scene);
  const scene::RenderSettings settings = settings_of_frame(options.frame, scene, limits);
  limits.draw(shown_file(options.frame.files[0]), pixels);
  const inspect::PixelStory story = inspect::inspect_pixel(scene, renderer, settings, options.x, options.y);
  limits.rest();
  ConsoleOptions console_options;
  console_options.quiet = options.frame.quiet;
  Console console(console_options);
  for (const std::string& warning : scene.warnings) console.warning(warning);
  for (const std::string& warning : renderer.warnings()) console.warning(warning);
  write_standard_output(bytes_of(options.json ? inspect::story_json(story) : inspect::story_text(story)));
  return kExitFine;
}

}  // namespace barrido::cli
