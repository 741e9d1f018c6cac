#include "viewer/view/model.h"

#include "pipeline/gltf/import_gltf.h"
#include "pipeline/scene/frame_observer.h"
#include "pipeline/scene/light_conversion.h"
#include "pipeline/scene/metering.h"
#include "pipeline/scene/names.h"
#include "pipeline/scene/scene_nodes.h"
#include "viewer/barrido/cost_report.h"
#include "viewer/barrido/frame_plan.h"
#include "viewer/barrido/map_spec.h"
#include "viewer/sheet/view_picture.h"
#include "viewer/view/render_words.h"

namespace barrido::view {
namespace {

std::unique_ptr<const scene::Scene> load(const std::string& path, const scene::BudgetLimits& limits) {
  scene::ImportOptions options;
  options.budget = std::make_shared<scene::Budget>(limits);
  options.image_roles = cli::kDrawnImages;
  return std::make_unique<const scene::Scene>(scene::import_gltf(path, options));
}

/// Gives the frame to OSMesa instead of having it drawn.
class OsmesaObserver final : public scene::FrameObserver {
 public:
  explicit OsmesaObserver(osmesa::FrameDrawer& drawer) : drawer_(drawer) {}

  bool observe(const scene::ObservedFrame& frame) override {
    drawn_ = {frame.options.width, frame.options.height, drawer_.draw(frame.assembled, frame.options), 0.0};
    return false;
  }

  OsmesaFrame take() { return std::move(drawn_); }

 private:
  osmesa::FrameDrawer& drawer_;
  OsmesaFrame drawn_;
};

}  // namespace

Model::Model(std::string path, const cli::LimitOptions& limits)
    : path_(std::move(path)),
      limits_{limits.max_memory, limits.max_seconds},
      scene_(load(path_, limits_)),
      renderer_(*scene_),
      caches_(*scene_) {}

Model::~Model() = default;

std::shared_ptr<const raster::Texture> Model::environment(const cli::RenderOptions& options) {
  std::shared_ptr<const raster::Texture>& slot =
      environments_[{options.environment_path, options.settings.color_management}];
  if (slot) return slot;
  scene::Budget budget(limits_);
  slot = cli::load_environment(options, &budget);
  return slot;
}

void Model::add_maps(scene::RenderSettings& settings) {
  const auto words = [](const scene::RenderSettings& s) {
    std::string text = std::string(name_of(s.color_management));
    for (const std::string& path : cli::map_paths(s)) text += '\n' + path;
    return text;
  };
  if (cli::map_paths(settings).empty()) return;
  const auto [slot, is_new] = maps_.try_emplace(words(settings));
  scene::MapOverride& loaded = slot->second;
  if (is_new) {
    scene::Budget budget(limits_);
    scene::RenderSettings own = settings;
    cli::load_maps(own, &budget);
    loaded = own.maps;
  }
  for (auto member :
       {&scene::MapOverride::bump, &scene::MapOverride::transparency, &scene::MapOverride::specularity}) {
    if (settings.maps.*member) (settings.maps.*member)->picture = (loaded.*member)->picture;
  }
}

std::shared_ptr<const scene::Image> Model::texture(const cli::RenderOptions& options) {
  std::shared_ptr<const scene::Image>& slot = textures_[options.texture_path];
  if (slot) return slot;
  scene::Budget budget(limits_);
  slot = cli::load_texture(options, &budget);
  return slot;
}

std::shared_ptr<const raster::Texture> Model::heights(const scene::UserDisplacement& displacement) {
  std::shared_ptr<const raster::Texture>& slot = heights_[displacement.source];
  if (slot) return slot;
  scene::Budget budget(limits_);
  slot = cli::load_heights(displacement, &budget);
  return slot;
}

int Model::camera_count(const cli::RenderOptions& options) const {
  const int root = scene::resolve_scene_index(*scene_, options.settings.scene_index);
  return static_cast<int>(scene::camera_nodes(*scene_, scene::nodes_of_scene(*scene_, root)).size());
}

scene::RenderSettings Model::settings_for(const cli::RenderOptions& wanted) {
  const cli::RenderOptions options = cli::parse_view_options(words_of(wanted));
  scene::RenderSettings settings = cli::resolved_settings(options);
  if (!options.environment_path.empty()) {
    settings.environment = environment(options);
  }
  add_maps(settings);
  if (!options.texture_path.empty()) settings.texture.picture = texture(options);
  settings.max_memory = limits_.max_memory;
  settings.displacement.picture = heights(settings.displacement);
  const cli::FileFacts facts{path_, camera_count(options), static_cast<int>(scene_->animations.size())};
  return cli::settings_of(settings, cli::plan_frames(options, facts).at(0));
}

DrawnFrame Model::draw(const cli::RenderOptions& options) {
  const cli::Stopwatch watch;
  pipeline::Statistics counts;
  const scene::RenderSettings settings = settings_for(options);
  const std::optional<inspect::StructureView>& view = options.views.at(0);
  raster::Framebuffer framebuffer =
      view ? sheet::draw_view(renderer_, settings, *view) : renderer_.render(settings, &counts);
  return {std::move(framebuffer), counts, watch.milliseconds()};
}

OsmesaFrame Model::draw_by(osmesa::FrameDrawer& drawer, const cli::RenderOptions& options) {
  const cli::Stopwatch watch;
  OsmesaObserver observer(drawer);
  renderer_.render(settings_for(options), nullptr, &observer);
  OsmesaFrame frame = observer.take();
  frame.draw_ms = watch.milliseconds();
  return frame;
}

inspect::PixelStory Model::inspect(const cli::RenderOptions& options, int x, int y) {
  return inspect::inspect_pixel(*scene_, renderer_, settings_for(options), x, y);
}

Look Model::look(const cli::RenderOptions& options) {
  const scene::RenderSettings settings = settings_for(options);
  const scene::PosedScene posed = scene::pose_scene(*scene_, settings, caches_);
  Look look;
  look.bounds = posed.bounds.sphere;
  look.eye = scene::choose_eye(*scene_, posed.nodes, posed.pose, posed.bounds, settings);
  look.view = scene::choose_view(*scene_, posed, settings);
  return look;
}

std::vector<pipeline::Light> Model::lights(const cli::RenderOptions& options) {
  scene::RenderSettings settings = settings_for(options);
  settings.lights_off.clear();
  const scene::PosedScene posed = scene::pose_scene(*scene_, settings, caches_);
  const scene::View view = scene::choose_view(*scene_, posed, settings);
  const float scale =
      scene::physical_light_scale(*scene_, posed.nodes, scene::pose_at(*scene_, scene::kNone, 0.0));
  std::vector<std::string> warnings;
  return scene::choose_lights(*scene_, posed.nodes, posed.scene_index, posed.pose, settings,
                              view.eye_from_world, scale, warnings)
      .lights;
}

double Model::duration_s(int animation) const {
  const auto index = static_cast<std::size_t>(animation);
  return animation >= 0 && index < scene_->animations.size() ? scene_->animations[index].duration_s : 0.0;
}

std::vector<std::string> Model::warnings() const { return renderer_.warnings(); }

}  // namespace barrido::view
