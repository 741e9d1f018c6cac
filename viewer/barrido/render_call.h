// One call of `barrido render`, from its options to pictures on disk: loads each file once, plans its frames,
// and sends them through the pipeline of drawing, encoding and delivering.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/scene/render_scene.h"
#include "viewer/barrido/call_limits.h"
#include "viewer/barrido/console.h"
#include "viewer/barrido/cost_report.h"
#include "viewer/barrido/frame_pipeline.h"
#include "viewer/barrido/frame_sheet.h"
#include "viewer/barrido/render_options.h"

namespace barrido::cli {

class RenderCall {
 public:
  /// Both must outlive the call.
  RenderCall(const RenderOptions& options, Console& console);

  /// Draws and writes everything. A file that cannot be read is reported and the others are drawn, except for
  /// a sheet, which is whole or not at all.
  /// @return the exit status. @throws UsageError, scene::InputError, std::bad_alloc for what ends the call.
  int run();

 private:
  void resolve_settings();
  void load_texture();
  void load_environment();
  void load_heights();
  bool render_file(const std::string& path);
  std::vector<PlannedFrame> plan(const scene::Scene& scene, const std::string& path) const;
  void render_frames(const scene::Scene& scene, const std::string& path,
                     const std::vector<PlannedFrame>& frames);
  void expect_frames(std::size_t count, const scene::Scene& scene);
  void draw(scene::SceneRenderer& renderer, const std::string& path, FrameInFlight& frame);
  void encode(FrameInFlight& frame) const;
  void deliver(FrameInFlight& frame);
  void add_to_animation(FrameInFlight& frame);
  void finish_animation();
  void write_sheet();
  void print_costs(double total_ms);

  /// Where text goes: standard output, unless the picture goes there.
  int text_descriptor() const;

  const RenderOptions& options_;
  Console& console_;
  CallLimits limits_;
  scene::RenderSettings settings_;
  CostReport report_;
  FrameSheet sheet_;
  std::optional<scene::AnimationEncoder> animation_;  ///< That frames are being delivered to,
  std::string animation_name_;                        ///< and its file.
};

/// Makes the folder that `path` lies in. @throws scene::InputError.
void make_parent_folder(const std::string& path);

}  // namespace barrido::cli
