#include "viewer/barrido/render_call.h"

#include <tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <new>
#include <set>

#include "pipeline/files/write_file.h"
#include "pipeline/gltf/import_gltf.h"
#include "pipeline/pictures/image_io.h"
#include "pipeline/scene/displacer.h"
#include "pipeline/scene/scene_nodes.h"
#include "raster/base/simd_target.h"
#include "viewer/barrido/commands.h"
#include "viewer/barrido/help.h"
#include "viewer/barrido/map_spec.h"
#include "viewer/barrido/process_guard.h"
#include "viewer/barrido/standard_streams.h"
#include "viewer/sheet/view_picture.h"

namespace barrido::cli {
namespace {

int thread_count() {
  return static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

/// Formats that hold floats as the renderer makes them; the others get the 8-bit picture.
bool holds_floats(const std::string& output) {
  std::string extension = std::filesystem::path(output).extension().string();
  for (char& letter : extension)
    letter = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter + 32) : letter;
  return extension == ".exr" || extension == ".hdr";
}

/// Of a drawn frame, with as much again for encoding it.
std::size_t frame_bytes(const scene::RenderSettings& settings) {
  const std::size_t pixels =
      static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height);
  return pixels * (settings.keep_float ? 40 : 8);
}

/// Makes the folders that the frames lie in, before time is spent on drawing.
void make_folders(const std::vector<PlannedFrame>& frames) {
  std::set<std::filesystem::path> made;
  for (const PlannedFrame& frame : frames) {
    if (frame.output.empty() || frame.output == "-") continue;
    if (made.insert(std::filesystem::path(frame.output).parent_path()).second)
      make_parent_folder(frame.output);
  }
}

/// A picture never takes the place of what it is made from: a model, its textures, the surroundings, heights.
void refuse_inputs(const std::string& output, const RenderOptions& options, const std::string& path,
                   const scene::Scene& scene) {
  if (output.empty() || output == "-") return;
  const auto refuse = [&](const std::filesystem::path& input) {
    std::error_code ignored;
    if (!std::filesystem::equivalent(output, input, ignored)) return;
    throw UsageError("--output: '" + output + "' would be written over an input");
  };
  for (const std::string& file : options.files) refuse(file);
  for (const std::string& map : map_paths(options.settings)) refuse(map);
  for (const std::string& picture :
       {options.environment_path, options.texture_path, options.settings.displacement.source}) {
    if (!picture.empty()) refuse(picture);
  }
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  for (const scene::Image& image : scene.images) refuse(folder / image.name);
}

}  // namespace

RenderCall::RenderCall(const RenderOptions& options, Console& console)
    : options_(options), console_(console), limits_(options.limits), settings_(options.settings) {}

int RenderCall::run() {
  const Stopwatch watch;
  check_output_names(options_);
  resolve_settings();
  load_texture();
  load_environment();
  load_heights();
  bool all_fine = true;
  for (const std::string& path : options_.files) all_fine = render_file(path) && all_fine;
  if (options_.sheet) write_sheet();
  console_.end_progress();
  if (options_.stats != StatsFormat::none) print_costs(watch.milliseconds());
  return all_fine ? kExitFine : kExitError;
}

void RenderCall::resolve_settings() {
  settings_ = resolved_settings(options_);
  const bool is_picture = options_.views.size() == 1 && !options_.views[0];
  settings_.keep_float = is_picture && !options_.sheet && holds_floats(options_.output);
}

void RenderCall::load_texture() {
  if (options_.texture_path.empty()) return;
  settings_.texture.picture = cli::load_texture(options_, limits_.open(options_.texture_path, true).get());
}

void RenderCall::load_environment() {
  if (const std::vector<std::string> maps = map_paths(settings_); !maps.empty()) {
    load_maps(settings_, limits_.open(maps.front(), true).get());
  }
  if (options_.environment_path.empty()) return;
  console_.set_progress("loading " + options_.environment_path);
  const Stopwatch watch;
  settings_.environment =
      cli::load_environment(options_, limits_.open(options_.environment_path, true).get());
  report_.environment_ms = watch.milliseconds();
}

void RenderCall::load_heights() {
  scene::UserDisplacement& displacement = settings_.displacement;
  if (!displacement.names_picture()) return;
  displacement.picture = cli::load_heights(displacement, limits_.open(displacement.source, true).get());
}

/// @return false when the file cannot be drawn and that has been told.
bool RenderCall::render_file(const std::string& path) {
  console_.set_progress("loading " + shown_file(path));
  const Stopwatch watch;
  std::optional<scene::Scene> scene;
  std::vector<PlannedFrame> frames;
  try {
    scene::ImportOptions import;
    import.image_roles = kDrawnImages;
    import.budget = limits_.open(shown_file(path));
    scene = read_model(path, import);
    frames = plan(*scene, path);
    for (const PlannedFrame& frame : frames) {
      refuse_inputs(frame.output, options_, path, *scene);
    }
  } catch (const std::exception& error) {
    const bool memory = is_out_of_memory(error);
    if (options_.sheet && memory) throw scene::InputError(shown_file(path), "", out_of_memory());
    if (options_.sheet) throw;
    console_.error(memory ? shown_file(path) + ": " + out_of_memory() : error.what());
    return false;
  }
  report_.models.push_back({shown_file(path), watch.milliseconds()});
  for (const std::string& warning : scene->warnings) console_.warning(warning);
  try {
    render_frames(*scene, shown_file(path), frames);
  } catch (const std::exception& error) {
    if (!is_out_of_memory(error)) throw;
    throw scene::InputError(shown_file(path), "", out_of_memory());
  }
  return true;
}

std::vector<PlannedFrame> RenderCall::plan(const scene::Scene& scene, const std::string& path) const {
  const int root = scene::resolve_scene_index(scene, settings_.scene_index);
  const auto cameras = scene::camera_nodes(scene, scene::nodes_of_scene(scene, root));
  scene::resolve_variant(scene, settings_.variant);
  return plan_frames(options_,
                     {path, static_cast<int>(cameras.size()), static_cast<int>(scene.animations.size())});
}

void RenderCall::render_frames(const scene::Scene& scene, const std::string& path,
                               const std::vector<PlannedFrame>& frames) {
  make_folders(frames);
  expect_frames(frames.size(), scene);
  scene::SceneRenderer renderer(scene);
  std::set<std::string> warned;
  FrameStages stages;
  stages.draw = [&](std::size_t index, FrameInFlight& frame) {
    frame.plan = &frames[index];
    console_.set_progress("drawing " + frame.plan->label + " (" + std::to_string(index + 1) + " of " +
                          std::to_string(frames.size()) + ")");
    draw(renderer, path, frame);
    for (const std::string& warning : renderer.warnings()) {
      if (warned.insert(warning).second) console_.warning(path + ": " + warning);
    }
  };
  stages.encode = [this](FrameInFlight& frame) { encode(frame); };
  stages.deliver = [this](FrameInFlight& frame) { deliver(frame); };
  run_frames(frames.size(), frames_in_flight(frame_bytes(settings_), thread_count()), stages);
  finish_animation();
  limits_.rest();
}

/// What frames take while they are drawn, encoded, and kept for a sheet; and what displacement may take.
void RenderCall::expect_frames(std::size_t count, const scene::Scene& scene) {
  constexpr std::uint64_t kDrawnBytes = 64, kKeptBytes = 24, kSumBytes = 20;
  const scene::SampleChoice& samples = settings_.samples;
  const std::uint64_t drawn = kDrawnBytes + (samples.moves() || samples.has_lens() ? kSumBytes : 0);
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(settings_.width) * static_cast<std::uint64_t>(settings_.height);
  const std::uint64_t in_flight = frames_in_flight(frame_bytes(settings_), thread_count());
  const std::uint64_t waiting = std::min<std::uint64_t>(in_flight, count) * frame_bytes(settings_);
  const std::uint64_t kept = options_.sheet ? (report_.frames.size() + count) * pixels * kKeptBytes : 0;
  const bool displaces = scene::farthest_displacement(scene, settings_.displacement) > 0.0f;
  const std::uint64_t displaced = displaces ? scene::Budget().allowed_memory() : 0;
  limits_.expect_frames(pixels * drawn + waiting + kept + displaced);
}

void RenderCall::draw(scene::SceneRenderer& renderer, const std::string& path, FrameInFlight& frame) {
  // Environments from the centres of objects are up to 16 times six pictures more.
  constexpr double kPixelsOfDynamicMaps = 16.0 * 6.0 * 256.0 * 256.0;
  limits_.draw(path + ": " + frame.plan->label,
               (static_cast<double>(settings_.width) * settings_.height +
                (settings_.dynamic_environment ? kPixelsOfDynamicMaps : 0.0)) *
                   settings_.samples.count);
  const Stopwatch watch;
  try {
    scene::RenderSettings settings = settings_of(settings_, *frame.plan);
    raster::StageProfile profile;
    if (options_.stats != StatsFormat::none) settings.profile = &profile;
    frame.framebuffer = frame.plan->view ? sheet::draw_view(renderer, settings, *frame.plan->view)
                                         : renderer.render(settings, &frame.cost.counts);
    for (int stage = 0; stage < raster::kStageCount; ++stage) {
      frame.cost.stage_ms[static_cast<std::size_t>(stage)] =
          profile.milliseconds(static_cast<raster::Stage>(stage));
    }
  } catch (const std::exception& error) {
    if (!is_out_of_memory(error)) throw;
    throw scene::InputError(path, frame.plan->label, out_of_memory());
  }
  frame.framebuffer->depth() = {};  // Not written; the memory serves the next frame.
  frame.cost.draw_ms = watch.milliseconds();
  const bool has_file =
      !frame.plan->output.empty() && frame.plan->output != "-" && !frame.plan->animation_file;
  frame.cost.name = has_file ? frame.plan->output : frame.plan->label;
  frame.cost.model = path;
  frame.cost.shading = frame.plan->shading;
  frame.cost.width = frame.framebuffer->width();
  frame.cost.height = frame.framebuffer->height();
}

void RenderCall::encode(FrameInFlight& frame) const {
  if (options_.hash) frame.cost.sha256 = pixel_hash(*frame.framebuffer);
  if (frame.plan->output.empty()) return;
  const Stopwatch watch;
  scene::WriteOptions write;
  write.png_compression = options_.png_compression;
  if (frame.plan->animation_file) {
    frame.of_animation = scene::prepare_frame(*frame.plan->animation_file, view_of(*frame.framebuffer));
  } else if (options_.raw) {
    const std::span<const std::uint8_t> pixels = view_of(*frame.framebuffer).rgba8;
    frame.encoded.assign(pixels.begin(), pixels.end());
  } else if (frame.plan->output == "-") {
    frame.encoded = scene::encode_png(view_of(*frame.framebuffer), write);
  } else {
    scene::write_image(frame.plan->output, view_of(*frame.framebuffer), write);
  }
  frame.cost.write_ms = watch.milliseconds();
}

void RenderCall::add_to_animation(FrameInFlight& frame) {
  const std::string& name = frame.plan->output;
  if (name != animation_name_) {
    finish_animation();
    animation_.emplace(*frame.plan->animation_file, name, options_.frames_per_second);
    animation_name_ = name;
  }
  const Stopwatch watch;
  animation_->add(*frame.of_animation);
  frame.of_animation.reset();
  frame.cost.write_ms += watch.milliseconds();
}

/// All frames are in it: it appears whole, or not at all where one has failed.
void RenderCall::finish_animation() {
  if (!animation_) return;
  scene::write_file(animation_name_, animation_->finish());
  animation_.reset();
  animation_name_.clear();
}

void RenderCall::deliver(FrameInFlight& frame) {
  if (frame.of_animation) add_to_animation(frame);
  if (!frame.encoded.empty()) {
    console_.end_progress();
    write_standard_output(frame.encoded);
  }
  if (options_.sheet) sheet_.add(frame.plan->label, std::move(*frame.framebuffer));
  if (options_.hash && options_.stats != StatsFormat::json) {
    console_.print(text_descriptor(), frame.cost.sha256 + "  " + on_one_line(frame.cost.name) + "\n");
  }
  report_.frames.push_back(std::move(frame.cost));
}

void RenderCall::write_sheet() {
  console_.set_progress("writing the sheet");
  const std::string name = sheet_name(options_);
  const int columns = sheet_columns(report_.frames.size(), frames_side_by_side(options_));
  if (name == "-") {
    console_.end_progress();
  } else {
    make_parent_folder(name);
  }
  sheet_.write(name, columns, options_.png_compression);
}

void RenderCall::print_costs(double total_ms) {
  report_.total_ms = total_ms;
  report_.threads = thread_count();
  report_.simd = raster::name_of(raster::simd_target());
  const bool json = options_.stats == StatsFormat::json;
  console_.print(text_descriptor(), json ? cost_json(report_) : cost_text(report_));
}

int RenderCall::text_descriptor() const { return options_.output == "-" ? kStandardError : kStandardOutput; }

void make_parent_folder(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (folder.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw scene::InputError(path, "", "cannot make its folder: " + error.message());
}

int run_render(std::span<const std::string> words) {
  const RenderOptions options = parse_render_options(words);
  if (options.help) {
    write_standard_output(bytes_of(render_help()));
    return kExitFine;
  }
  std::optional<tbb::global_control> threads;
  if (options.threads > 0) {
    threads.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(options.threads));
  }
  raster::set_simd_target(options.simd);  // That it is available was checked with the option.
  ConsoleOptions console_options;
  console_options.quiet = options.quiet;
  console_options.is_terminal = isatty(kStandardError) == 1;
  Console console(console_options);
  return RenderCall(options, console).run();
}

}  // namespace barrido::cli
