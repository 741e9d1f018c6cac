// Which frames a call of `barrido render` makes, in which order and under which names, and what the renderer
// is given for each. Enters: the options and a few facts of a loaded file; leaves: a list, and settings.
// Draws and writes nothing.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/gltf/import_gltf.h"
#include "pipeline/pictures/animation.h"
#include "pipeline/scene/render_scene.h"
#include "viewer/barrido/render_options.h"

namespace barrido::cli {

struct PlannedFrame {
  pipeline::ShadeModel shading = pipeline::ShadeModel::phong;
  int camera = scene::kNone;     ///< Among the file's; kNone: as RenderSettings say.
  int number = 0;                ///< {frame}: of the animation, or of the turntable.
  int animation = scene::kNone;  ///< kNone: the scene as it stands.
  double time_s = 0.0;           ///< Of the animation.
  float azimuth_deg = 0.0f;      ///< Of the turntable, to be added.
  std::string label;             ///< "teapot/phong", "teapot/phong/camera1/frame3".
  std::string output;            ///< File name; empty where there is none of its own (sheet, only --hash).
  std::optional<inspect::StructureView> view;  ///< None: the frame itself.
  /// Set: `output` is an animation, which this frame is in with those that come before and after it.
  std::optional<scene::AnimationFormat> animation_file;
};

/// What a plan must know of a file.
struct FileFacts {
  std::string path;
  int cameras = 0;  ///< In the scene to be drawn.
  int animations = 0;
};

/// The frames of one file: cameras, in each all shadings, in each all views, in each all moments.
/// @throws UsageError when a camera or an animation asked for does not exist.
std::vector<PlannedFrame> plan_frames(const RenderOptions& options, const FileFacts& file);

/// How many frames stand side by side in a sheet: the moments of each camera, shading mode and view, or else
/// the views or the shading modes.
std::size_t frames_side_by_side(const RenderOptions& options);

/// Whether the template gives each frame of the call a name of its own that can be written; asked before
/// anything is loaded.
/// @throws UsageError naming the placeholder that is missing.
void check_output_names(const RenderOptions& options);

/// The name of the picture of all frames (--sheet). @throws UsageError for a placeholder that differs.
std::string sheet_name(const RenderOptions& options);

/// The settings for one frame; `base` are those of the call, with colours and environment resolved.
scene::RenderSettings settings_of(const scene::RenderSettings& base, const PlannedFrame& frame);

/// What the renderer looks at; pictures for other uses need not be decoded.
extern const unsigned kDrawnImages;

/// Colours are passed as they are to be seen: the renderer undoes its own display transform. The environment
/// is left out, and what differs from frame to frame.
scene::RenderSettings resolved_settings(const RenderOptions& options);

/// The picture of --texture PATH; null where none was asked for. @throws scene::InputError.
std::shared_ptr<const scene::Image> load_texture(const RenderOptions& options,
                                                 scene::Budget* budget = nullptr);

/// The cube map of --environment PATH; null where none was asked for. @throws scene::InputError.
std::shared_ptr<const raster::Texture> load_environment(const RenderOptions& options,
                                                        scene::Budget* budget = nullptr);

/// The heights that --displacement names, a picture as it is stored; null: none are asked for, or constant
/// ones. @throws scene::InputError.
std::shared_ptr<const raster::Texture> load_heights(const scene::UserDisplacement& displacement,
                                                    scene::Budget* budget = nullptr);

/// Reads the model of a FILE of the command line; "-" is standard input. @throws InputError.
scene::Scene read_model(const std::string& file, scene::ImportOptions import);

/// "<stdin>" for "-", which is standard input; else the file's name as it is.
std::string shown_file(const std::string& file);

/// File name without folder and extension; "stdin" for standard input.
std::string model_name(const std::string& path);

}  // namespace barrido::cli
