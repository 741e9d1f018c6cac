#include "viewer/barrido/frame_settings.h"

#include <array>

#include "pipeline/gltf/import_gltf.h"
#include "pipeline/pictures/environment.h"

namespace barrido::cli {

const unsigned kDrawnImages = scene::kBaseColorImage | scene::kMetallicRoughnessImage | scene::kEmissiveImage;

scene::RenderSettings resolved_settings(const RenderOptions& options) {
  scene::RenderSettings settings = options.settings;
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

}  // namespace barrido::cli
