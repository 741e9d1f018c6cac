// Model files from strangers: the import may refuse them with InputError and nothing else; what it lets pass
// is drawn, small, in every shading mode.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "model_file.h"
#include "pipeline/gltf/import_gltf.h"
#include "pipeline/scene/render_scene.h"
#include "targets.h"

namespace barrido::fuzz {
namespace {

/// FNV-1a: the choices below should not be bytes of the file, which is to stay a file.
std::uint32_t hash_of(Bytes bytes) {
  std::uint32_t hash = 2166136261u;
  for (const std::uint8_t byte : bytes) hash = (hash ^ byte) * 16777619u;
  return hash;
}

scene::RenderSettings settings_for(const scene::Scene& scene, std::uint32_t hash) {
  scene::RenderSettings settings;
  settings.width = 24;
  settings.height = 17;
  settings.shading = static_cast<pipeline::ShadeModel>(hash & 3);
  if ((hash & 0x10) != 0) settings.color_management = scene::ColorManagement::none;
  if ((hash & 0x60) == 0) settings.wireframe = true;
  if ((hash & 0x180) == 0) settings.overlays = {true, true, true};
  if ((hash & 0x600) == 0) settings.crease_angle_deg = 30.0f;
  settings.dynamic_environment = (hash & 0x1800) == 0;
  settings.keep_float = (hash & 0x2000) != 0;
  settings.camera.ignore_file_cameras = (hash & 0x4000) != 0;
  if (!scene.animations.empty() && (hash & 0x8000) != 0) {
    settings.animation = 0;
    settings.time_s = static_cast<double>(hash >> 16) / 4096.0;
  }
  return settings;
}

void run_model(Bytes bytes, const char* name) {
  static const ModelFile file;
  try {
    const scene::Scene scene = scene::import_gltf(file.write(name, bytes), small_limits());
    scene::SceneRenderer renderer(scene);
    const scene::RenderSettings settings = settings_for(scene, hash_of(bytes));
    const raster::Framebuffer frame = renderer.render(settings);
    require(frame.color8().size() == std::size_t{24} * 17, "the frame is not complete");
  } catch (const scene::InputError& error) {
    const std::string_view message = error.what();
    require(!message.empty() && message.find('\n') == std::string_view::npos,
            "not one line: " + std::string(message));
  }
}

}  // namespace

ModelFile::ModelFile() {
  std::string name = (std::filesystem::temp_directory_path() / "barrido-fuzz-XXXXXX").string();
  require(mkdtemp(name.data()) != nullptr, "no temporary folder");
  folder_ = name;
}

ModelFile::~ModelFile() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

std::filesystem::path ModelFile::write(const std::string& name, Bytes bytes) const {
  const std::filesystem::path path = folder_ / name;
  std::filesystem::remove(path);  // to replace the content of a file would wait for the disk
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  require(file.flush().good(), "cannot write " + path.string());
  return path;
}

scene::ImportOptions small_limits() {
  scene::ImportOptions options;
  options.max_file_bytes = 1 << 22;
  options.max_vertices = 2000;
  options.max_image_pixels = 1 << 16;
  return options;
}

void run_gltf(Bytes bytes) { run_model(bytes, "model.gltf"); }
void run_glb(Bytes bytes) { run_model(bytes, "model.glb"); }

}  // namespace barrido::fuzz
