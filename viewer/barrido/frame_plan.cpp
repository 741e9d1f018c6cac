#include "viewer/barrido/frame_plan.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>

#include "pipeline/gltf/import_gltf.h"
#include "pipeline/names.h"
#include "pipeline/pictures/environment.h"
#include "pipeline/pictures/image_io.h"
#include "viewer/barrido/output_template.h"

namespace barrido::cli {
namespace {

struct Moment {
  int number = 0;
  double time_s = 0.0;
  float azimuth_deg = 0.0f;
};

std::vector<Moment> moments_of(const RenderOptions& options) {
  std::vector<Moment> moments;
  if (options.frames) {
    for (int n = options.frames->first; n <= options.frames->last; ++n) {
      moments.push_back({n, n / options.frames_per_second, 0.0f});
    }
    return moments;
  }
  const int count = std::max(1, options.turntable);
  for (int n = 0; n < count; ++n) {
    const double turn = 360.0 * n / count;
    moments.push_back({n, options.time_s.value_or(0.0), static_cast<float>(turn)});
  }
  return moments;
}

bool has_several_moments(const RenderOptions& options) {
  return options.turntable > 1 || (options.frames && options.frames->first < options.frames->last);
}

bool chooses_camera(const RenderOptions& options) { return options.all_cameras || !options.cameras.empty(); }

/// The cameras to draw from; kNone is the default one.
std::vector<int> cameras_of(const RenderOptions& options, const FileFacts& file) {
  if (!chooses_camera(options)) return {scene::kNone};
  std::vector<int> cameras = options.cameras;
  for (int i = 0; options.all_cameras && i < file.cameras; ++i) cameras.push_back(i);
  if (cameras.empty()) throw UsageError(file.path + ": --camera-index all: the scene has no camera");
  for (const int camera : cameras) {
    if (camera < file.cameras) continue;
    throw UsageError(file.path + ": --camera-index " + std::to_string(camera) + ": the scene has " +
                     (file.cameras == 0   ? "no camera"
                      : file.cameras == 1 ? "only camera 0"
                                          : "only cameras 0 to " + std::to_string(file.cameras - 1)));
  }
  return cameras;
}

int animation_of(const RenderOptions& options, const FileFacts& file) {
  if (!options.animation && !options.frames && !options.time_s) {
    // What the shutter sees moves: the first animation, where there is any.
    return options.settings.samples.shutter && file.animations > 0 ? 0 : scene::kNone;
  }
  const int animation = options.animation.value_or(0);
  if (animation < file.animations) return animation;
  const std::string option = options.animation ? "--animation " + std::to_string(animation)
                             : options.frames  ? "--frames"
                                               : "--time";
  throw UsageError(file.path + ": " + option + ": the file has " +
                   (file.animations == 0   ? "no animation"
                    : file.animations == 1 ? "only animation 0"
                                           : "only animations 0 to " + std::to_string(file.animations - 1)));
}

std::string view_name(const PlannedFrame& frame) { return std::string(name_of(frame.view)); }

/// A path that leads to no other place than below the folder that it is appended to.
std::string folder_name(const std::string& path) {
  std::filesystem::path folder;
  for (const auto& part : std::filesystem::path(path).parent_path().lexically_normal().relative_path()) {
    folder /= part == ".." ? "up" : part;
  }
  return folder.empty() ? "." : folder.string();
}

FrameName name_of_frame(const std::string& path, const PlannedFrame& frame) {
  return {model_name(path),
          std::string(name_of(frame.shading)),
          frame.camera == scene::kNone ? "auto" : std::to_string(frame.camera),
          frame.number,
          view_name(frame),
          folder_name(path)};
}

std::string label_of(const RenderOptions& options, const std::string& path, const PlannedFrame& frame) {
  std::string label = model_name(path) + "/" + std::string(name_of(frame.shading));
  if (chooses_camera(options)) label += "/camera" + std::to_string(frame.camera);
  if (frame.view || options.views.size() > 1) label += "/" + view_name(frame);
  if (has_several_moments(options)) label += "/frame" + std::to_string(frame.number);
  return label;
}

/// GIF holds nothing but animations, if of a single frame; of WebP several moments that have no names of
/// their own are one.
std::optional<scene::AnimationFormat> animation_file_of(const RenderOptions& options,
                                                        const OutputTemplate& output,
                                                        const std::string& name) {
  const std::optional<scene::AnimationFormat> format = scene::animation_format(name);
  const bool is_still = output.has("frame") || !has_several_moments(options);
  return format == scene::AnimationFormat::webp && is_still ? std::nullopt : format;
}

bool has_own_file(const RenderOptions& options) { return !options.output.empty() && !options.sheet; }

/// "{model} and {shading}": placeholders for what differs from frame to frame that the template lacks.
std::string missing_placeholders(const RenderOptions& options, const OutputTemplate& output) {
  const std::pair<std::string_view, bool> differing[] = {
      {"model", options.files.size() > 1 && !output.has("folder")},
      {"shading", options.shadings.size() > 1},
      {"camera", options.all_cameras || options.cameras.size() > 1},
      {"frame", has_several_moments(options) && !scene::animation_format(options.output)},
      {"view", options.views.size() > 1}};
  std::string missing;
  for (const auto& [placeholder, differs] : differing) {
    if (!differs || output.has(placeholder)) continue;
    missing += (missing.empty() ? "{" : " and {") + std::string(placeholder) + "}";
  }
  return missing;
}

void check_format(const std::string& name) {
  if (scene::is_writable_format(name) || scene::animation_format(name)) return;
  const std::string extension = std::filesystem::path(name).extension().string();
  throw UsageError("--output: '" + name + "': " +
                   (extension.empty() ? "has no extension"
                                      : "no picture format is known by the extension '" + extension + "'") +
                   "; expected png, jpg, tif, exr, hdr or gif, for example");
}

/// Every name of the call once, as far as they are known before the files are loaded.
void check_names_differ(const RenderOptions& options) {
  std::map<std::string, std::string> label_by_name;
  std::string animation;  // The one before, whose further frames have its name again
  const int first = moments_of(options).front().number;
  for (const std::string& path : options.files) {
    FileFacts facts{path, 1, 1};
    for (const int camera : options.cameras) facts.cameras = std::max(facts.cameras, camera + 1);
    facts.animations = options.animation.value_or(0) + 1;
    for (const PlannedFrame& frame : plan_frames(options, facts)) {
      check_format(frame.output);
      const bool goes_on = frame.animation_file && frame.output == animation && frame.number != first;
      animation = frame.animation_file ? frame.output : "";
      if (goes_on) continue;
      const std::string label = path + " " + std::string(name_of(frame.shading));
      const auto [other, is_new] = label_by_name.emplace(frame.output, label);
      if (is_new) continue;
      throw UsageError(frame.output + ": two frames would have this name: " + other->second + " and " +
                       label);
    }
  }
}

}  // namespace

scene::Scene read_model(const std::string& file, scene::ImportOptions import) {
  import.from_standard_input = file == "-";
  return scene::import_gltf(shown_file(file), import);
}

std::string shown_file(const std::string& file) { return file == "-" ? "<stdin>" : file; }

std::string model_name(const std::string& path) {
  return path == "-" ? "stdin" : std::filesystem::path(path).stem().string();
}

std::vector<PlannedFrame> plan_frames(const RenderOptions& options, const FileFacts& file) {
  const int animation = animation_of(options, file);
  const std::vector<Moment> moments = moments_of(options);
  const OutputTemplate output(options.output.empty() ? "-" : options.output);
  std::vector<PlannedFrame> frames;
  for (const int camera : cameras_of(options, file)) {
    for (const pipeline::ShadeModel shading : options.shadings) {
      for (const auto& view : options.views) {
        for (const Moment& moment : moments) {
          PlannedFrame frame{shading, camera, moment.number, animation, moment.time_s, moment.azimuth_deg,
                             "",      "",     view,          {}};
          frame.label = label_of(options, file.path, frame);
          if (has_own_file(options)) frame.output = output.expand(name_of_frame(file.path, frame));
          frame.animation_file = animation_file_of(options, output, frame.output);
          frames.push_back(std::move(frame));
        }
      }
    }
  }
  return frames;
}

std::size_t frames_side_by_side(const RenderOptions& options) {
  const std::size_t moments = moments_of(options).size();
  if (moments > 1) return moments;
  return options.views.size() > 1 ? options.views.size() : options.shadings.size();
}

std::string sheet_name(const RenderOptions& options) {
  const OutputTemplate output(options.output);
  const std::pair<std::string_view, bool> impossible[] = {{"model", options.files.size() > 1},
                                                          {"shading", true},
                                                          {"camera", true},
                                                          {"frame", true},
                                                          {"view", true}};
  for (const auto& [placeholder, differs] : impossible) {
    if (!differs || !output.has(placeholder)) continue;
    throw UsageError("--output: '" + options.output + "': a sheet is one picture for every {" +
                     std::string(placeholder) + "}; leave it out");
  }
  return output.expand({model_name(options.files[0]), "", "", 0, "", folder_name(options.files[0])});
}

void check_output_names(const RenderOptions& options) {
  if (options.output.empty()) return;
  const OutputTemplate output(options.output);
  const std::string missing = missing_placeholders(options, output);
  if (options.sheet) {
    const std::string name = sheet_name(options);
    if (!output.is_standard_output()) check_format(name);
    return;
  }
  if (output.is_standard_output()) {
    if (missing.empty() || options.raw) return;
    throw UsageError(
        "--output: '-': standard output holds one picture; several frames need --sheet or --raw");
  }
  if (!missing.empty()) {
    throw UsageError("--output: '" + options.output + "': the frames need different names: add " + missing +
                     ", or use --sheet");
  }
  check_names_differ(options);
}

scene::RenderSettings settings_of(const scene::RenderSettings& base, const PlannedFrame& frame) {
  scene::RenderSettings settings = base;
  settings.shading = frame.shading;
  settings.camera.camera_index = frame.camera;
  settings.camera.azimuth_deg += frame.azimuth_deg;
  settings.animation = frame.animation;
  settings.time_s = frame.time_s;
  return settings;
}

const unsigned kDrawnImages = scene::kBaseColorImage | scene::kMetallicRoughnessImage | scene::kNormalImage |
                              scene::kOcclusionImage | scene::kEmissiveImage | scene::kLayerImage;

scene::RenderSettings resolved_settings(const RenderOptions& options) {
  scene::RenderSettings settings = options.settings;
  settings.max_memory = options.limits.max_memory;
  settings.frames_per_second = options.frames_per_second;
  if (options.turntable > 1) settings.turn_a_frame_deg = 360.0f / static_cast<float>(options.turntable);
  if (options.background_shown) {
    const auto& [red, green, blue, alpha] = *options.background_shown;
    settings.background_color = glm::vec4(red, green, blue, alpha);
  }
  if (!options.fog) return settings;
  settings.fog = options.fog->state;
  settings.fog_takes_background = !options.fog->color_shown.has_value();
  if (const auto& shown = options.fog->color_shown) {
    settings.fog->color = {(*shown)[0], (*shown)[1], (*shown)[2], 1.0f};
  }
  return settings;
}

std::shared_ptr<const scene::Image> load_texture(const RenderOptions& options, scene::Budget* budget) {
  if (options.texture_path.empty()) return nullptr;
  scene::ImageLimits limits;
  limits.budget = budget;
  return std::make_shared<const scene::Image>(scene::read_image(options.texture_path, limits));
}

std::shared_ptr<const raster::Texture> load_environment(const RenderOptions& options, scene::Budget* budget) {
  if (options.environment_path.empty()) return nullptr;
  const bool srgb = options.settings.color_management == scene::ColorManagement::srgb;
  scene::ImageLimits limits;
  limits.budget = budget;
  const scene::CubeMapImage image = scene::read_environment(options.environment_path, 0.0f, true, limits);
  raster::TextureOptions texture_options;
  texture_options.encoding = srgb ? raster::Encoding::srgb : raster::Encoding::linear;
  std::array<raster::Pixels8, raster::kCubeFaces> faces;
  for (std::size_t face = 0; face < faces.size(); ++face) {
    faces[face] = {image.size, image.size, image.faces_rgba[face]};
  }
  return std::make_shared<const raster::Texture>(raster::Texture::make_cube(faces, texture_options));
}

std::shared_ptr<const raster::Texture> load_heights(const scene::UserDisplacement& displacement,
                                                    scene::Budget* budget) {
  if (!displacement.names_picture()) return nullptr;
  scene::ImageLimits limits;
  limits.budget = budget;
  limits.bytes_a_pixel = 10;  // With its mip levels
  const scene::Image image = scene::read_image(displacement.source, limits);
  return std::make_shared<const raster::Texture>(
      raster::Texture::make_2d({image.width, image.height, image.rgba}, {}));
}

}  // namespace barrido::cli
