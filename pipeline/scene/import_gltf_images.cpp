// Images: those that a material uses are read and decoded, each by whichever thread is free. Which of several
// broken images is reported does not depend on the threads: always the first.
#include <optional>
#include <span>
#include <vector>

#include <tbb/parallel_for.h>

#include "pipeline/scene/image_io.h"
#include "pipeline/scene/import_gltf_parts.h"

namespace barrido::scene::gltf {
namespace {

void mark(const Scene& scene, const TextureUse& use, std::vector<char>& used) {
  if (use.texture == kNone) return;
  const int image = scene.textures[static_cast<std::size_t>(use.texture)].image;
  if (image != kNone) used[static_cast<std::size_t>(image)] = 1;
}

/// Indices, ascending, of the images in one of the roles that the caller asked for.
std::vector<std::size_t> used_images(const Import& import, std::size_t count) {
  std::vector<char> used(count, 0);
  const unsigned roles = import.options.load_images ? import.options.image_roles : 0u;
  for (const Material& material : import.scene.materials) {
    if (roles & kBaseColorImage) mark(import.scene, material.base_color_texture, used);
    if (roles & kMetallicRoughnessImage) mark(import.scene, material.metallic_roughness_texture, used);
    if (roles & kNormalImage) mark(import.scene, material.normal_texture, used);
    if (roles & kOcclusionImage) mark(import.scene, material.occlusion_texture, used);
    if (roles & kEmissiveImage) mark(import.scene, material.emissive_texture, used);
  }
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < count; ++i) {
    if (used[i]) indices.push_back(i);
  }
  return indices;
}

/// Fills `image` or returns the error.
std::optional<InputError> decode(const Import& import, std::size_t index, Image& image) {
  try {
    const EncodedImage encoded = import.document.read_image(index);
    const std::string place = encoded.name == element("images", index)
                                  ? encoded.name
                                  : element("images", index) + " (" + encoded.name + ")";
    if (!encoded.problem.empty()) import.report.fail(place, encoded.problem);
    ImageLimits limits;
    limits.max_pixels = import.options.max_image_pixels;
    image = decode_image(encoded.bytes, import.report.file() + ": " + place, limits);
    image.name = encoded.name;
    return std::nullopt;
  } catch (const InputError& error) {
    return error;
  }
}

}  // namespace

void import_images(Import& import) {
  const std::size_t count = import.document.image_count();
  import.scene.images.resize(count);
  for (std::size_t i = 0; i < count; ++i) import.scene.images[i].name = element("images", i);
  const std::vector<std::size_t> used = used_images(import, count);
  std::vector<std::optional<InputError>> errors(used.size());
  const auto decode_one = [&](std::size_t i) {
    errors[i] = decode(import, used[i], import.scene.images[used[i]]);
  };
  tbb::parallel_for(std::size_t{0}, used.size(), decode_one, tbb::simple_partitioner());
  for (const auto& error : errors) {
    if (error) throw *error;
  }
}

}  // namespace barrido::scene::gltf
