#include "models/tool/write_models.h"

#include <array>
#include <string>

#include "models/tool/file.h"
#include "models/tool/pictures.h"
#include "models/tool/scenes.h"

namespace barrido::models {
namespace {

constexpr int kPictureSize = 256;
constexpr int kSkySize = 512;
constexpr double kBrickHeight = 0.02;  ///< Of bricks over mortar, in widths of the picture.

Textures write_textures(const WriteOptions& options) {
  Textures textures;
  const auto add = [&](const std::string& name, const Picture& picture) {
    textures[name] = encode_small_png(picture);
    write_file(options.folder / "textures" / (name + ".png"), textures[name]);
    if (!options.textures.empty()) textures[name] = read_file(options.textures / (name + ".png"));
  };
  add("checker", draw_checker(kPictureSize));
  add("patch", draw_patch(kPictureSize));
  add("bricks", draw_bricks(kPictureSize));
  add("marble", draw_marble(kPictureSize));
  const Picture heights = draw_brick_heights(kPictureSize);
  add("brick_heights", heights);
  add("brick_normals", draw_normals(heights, kBrickHeight));
  add("brick_occlusion", draw_brick_occlusion(kPictureSize));
  add("brick_shine", draw_brick_shine(kPictureSize));
  return textures;
}

void write_sky(const std::filesystem::path& folder) {
  constexpr std::array kFaces{"px", "nx", "py", "ny", "pz", "nz"};
  for (std::size_t face = 0; face < kFaces.size(); ++face) {
    write_file(folder / (std::string(kFaces[face]) + ".png"),
               encode_small_png(draw_sky(static_cast<int>(face), kSkySize)));
  }
}

}  // namespace

void write_models(const WriteOptions& options) {
  write_sky(options.folder / "sky");
  const Textures textures = write_textures(options);
  std::vector<SceneFile> scenes = make_object_scenes(textures, options.teapot_cells);
  for (SceneFile& scene : make_lesson_scenes(textures)) scenes.push_back(std::move(scene));
  scenes.push_back(make_showcase(textures, options.teapot_cells));
  for (const SceneFile& scene : scenes) write_file(options.folder / scene.name, scene.bytes);
}

}  // namespace barrido::models
