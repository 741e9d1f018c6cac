// Everything that `barrido render` was told, as values: the command line in, one plain struct out. Knows what
// the options mean and which exclude each other, and loads no file but that of --settings.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pipeline/inspect/structure_view.h"
#include "pipeline/scene/render_scene.h"
#include "raster/base/simd_target.h"
#include "viewer/barrido/arguments.h"
#include "viewer/barrido/call_limits.h"
#include "viewer/barrido/specs.h"

namespace barrido {

/// The picture itself, then the views.
template <>
inline constexpr auto kNames<std::optional<inspect::StructureView>> = [
]<std::size_t... rows>(std::index_sequence<rows...>) {
  return std::array<Named<std::optional<inspect::StructureView>>, sizeof...(rows) + 1>{
      {{std::nullopt, "picture", "picture"},
       {kNames<inspect::StructureView>[rows].value, kNames<inspect::StructureView>[rows].name,
        kNames<inspect::StructureView>[rows].name}...}};
}
(std::make_index_sequence<static_cast<std::size_t>(inspect::kStructureViewCount)>());

}  // namespace barrido

namespace barrido::cli {

enum class StatsFormat { none, text, json };

/// Frames of an animation, both ends included.
struct FrameRange {
  int first = 0;
  int last = 0;
};

struct RenderOption;

struct RenderOptions {
  bool help = false;  ///< Nothing else is looked at.
  std::vector<std::string> files;

  std::string output;  ///< Template; empty when only --hash or --stats is asked for.
  std::vector<pipeline::ShadeModel> shadings{pipeline::ShadeModel::phong};
  std::vector<std::optional<inspect::StructureView>> views{std::nullopt};  ///< None: the picture itself.
  bool sheet = false;
  bool raw = false;  ///< Frames go to standard output as bare pixels.
  bool hash = false;
  bool quiet = false;
  StatsFormat stats = StatsFormat::none;
  int png_compression = 1;
  std::string settings_path;  ///< File of further options; empty: none. They have been applied.

  std::string environment_path;                          ///< Empty: none, or `settings.dynamic_environment`.
  std::string texture_path;                              ///< Empty: none, or `settings.texture.solid`.
  std::optional<std::array<float, 4>> background_shown;  ///< As it is to be seen, straight alpha.
  std::optional<FogChoice> fog;

  std::vector<int> cameras;  ///< Empty: the first of the file, or the model framed.
  bool all_cameras = false;
  int turntable = 0;  ///< Pictures round the model; 0: no turntable.
  std::optional<FrameRange> frames;
  double frames_per_second = 30.0;
  std::optional<double> time_s;
  std::optional<int> animation;

  LimitOptions limits;
  int threads = 0;  ///< 0: as many as the machine has.
  raster::SimdTarget simd = raster::SimdTarget::automatic;

  /// What goes to the renderer as it stands; colours as seen, cameras and times are filled in per frame.
  scene::RenderSettings settings;
};

/// The syntax of `barrido render`, for the parser and the help.
std::span<const OptionSyntax> render_syntax();

/// Reads the values of `arguments`, whose options are those of `table`, and checks all that concerns a frame
/// and its model whoever asks for it; those of a settings file are as if they had been given. `command` is
/// named in messages. @throws UsageError, and scene::InputError for the settings file.
RenderOptions read_frame_options(Arguments arguments, std::span<const RenderOption> table,
                                 const std::string& command, bool needs_file = true);

/// @throws as read_frame_options.
RenderOptions parse_render_options(std::span<const std::string> words);

/// The options of one picture as barrido-view takes them: neither file nor output is needed.
/// @throws as read_frame_options.
RenderOptions parse_view_options(std::span<const std::string> words);

}  // namespace barrido::cli
