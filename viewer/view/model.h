// A model that is open: its file as a scene, and pictures of it for the options of `barrido render`, by the
// same way as that command. Knows no window and no keys.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/inspect/pixel_story.h"
#include "pipeline/scene/frame.h"
#include "pipeline/scene/render_scene.h"
#include "pipeline/scene/view.h"
#include "viewer/barrido/render_options.h"
#include "viewer/osmesa/frame_picture.h"

namespace barrido::view {

/// Where the eye is and what it looks at.
struct Look {
  scene::Eye eye;
  scene::Sphere bounds;
  scene::View view;
};

/// A picture with what it cost.
struct DrawnFrame {
  raster::Framebuffer framebuffer;
  pipeline::Statistics counts;  ///< All 0 for a view.
  double draw_ms = 0.0;
};

/// OSMesa's picture of the draws of a frame.
struct OsmesaFrame {
  int width = 0;
  int height = 0;
  osmesa::FramePicture picture;
  double draw_ms = 0.0;
};

class Model {
 public:
  /// `limits` are those of each file that is opened. @throws scene::InputError when the file cannot be read.
  explicit Model(std::string path, const cli::LimitOptions& limits = {});
  ~Model();

  const std::string& path() const { return path_; }
  const scene::Scene& scene() const { return *scene_; }

  /// The picture that `barrido render` makes with these options: they are written as a command line, and that
  /// is read and drawn. A view stands on its legend. @throws UsageError, scene::InputError.
  DrawnFrame draw(const cli::RenderOptions& options);

  /// The same frame's draws, drawn by OSMesa; options that make another picture of them (views) do not count.
  /// @throws as draw, and std::runtime_error from OSMesa.
  OsmesaFrame draw_by(osmesa::FrameDrawer& drawer, const cli::RenderOptions& options);

  /// What the renderer is given for these options. @throws as draw.
  scene::RenderSettings settings_for(const cli::RenderOptions& options);

  /// Why pixel (x, y), y from the top row, looks as it does. @throws as draw.
  inspect::PixelStory inspect(const cli::RenderOptions& options, int x, int y);

  /// @throws as draw.
  Look look(const cli::RenderOptions& options);

  /// The lights of the frame in world space, those switched off too; no ambient light. @throws as draw.
  std::vector<pipeline::Light> lights(const cli::RenderOptions& options);

  /// Seconds; 0 when there is no such animation.
  double duration_s(int animation) const;
  /// Gives the settings the pictures of their maps.
  void add_maps(scene::RenderSettings& settings);
  int camera_count(const cli::RenderOptions& options) const;
  std::vector<std::string> warnings() const;

 private:
  std::shared_ptr<const raster::Texture> environment(const cli::RenderOptions& options);
  std::shared_ptr<const scene::Image> texture(const cli::RenderOptions& options);
  std::shared_ptr<const raster::Texture> heights(const scene::UserDisplacement& displacement);

  std::string path_;
  scene::BudgetLimits limits_;
  std::unique_ptr<const scene::Scene> scene_;
  scene::SceneRenderer renderer_;
  scene::SceneCaches caches_;  ///< For looking; the renderer has its own.
  std::map<std::string, std::shared_ptr<const scene::Image>> textures_;  ///< By path
  /// Never thrown away while the renderer lives: it knows environments by their address.
  std::map<std::pair<std::string, scene::ColorManagement>, std::shared_ptr<const raster::Texture>>
      environments_;
  /// Maps with their pictures, by the pictures' paths and what colours are.
  std::map<std::string, scene::MapOverride> maps_;
  std::map<std::string, std::shared_ptr<const raster::Texture>> heights_;  ///< By path; kept likewise.
};

}  // namespace barrido::view
