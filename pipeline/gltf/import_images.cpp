// Images: those that a material uses are read and decoded, each by whichever thread is free. Which of several
// broken images is reported does not depend on the threads: always the first; but where memory is short, on
// which came last.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include <tbb/parallel_for.h>
#include <nlohmann/json.hpp>

#include "pipeline/gltf/import_parts.h"
#include "pipeline/pictures/image_io.h"

namespace barrido::scene::gltf {
namespace {

// Of a pixel as it is decoded, and with the mip levels of a texture.
constexpr std::uint64_t kDecodedBytes = 4, kTextureBytes = 10;

void mark(const Scene& scene, const TextureUse& use, std::uint64_t bytes, std::vector<std::uint64_t>& used) {
  if (use.texture == kNone) return;
  const int image = scene.textures[static_cast<std::size_t>(use.texture)].image;
  if (image == kNone) return;
  std::uint64_t& slot = used[static_cast<std::size_t>(image)];
  slot = std::max(slot, bytes);
}

/// What a pixel of each image will take; 0 for those in none of the roles that the caller asked for.
std::vector<std::uint64_t> pixel_bytes(const Import& import, std::size_t count) {
  std::vector<std::uint64_t> used(count, 0);
  const unsigned roles = import.options.load_images ? import.options.image_roles : 0u;
  for (const Material& material : import.scene.materials) {
    if (roles & kBaseColorImage) mark(import.scene, material.base_color_texture, kTextureBytes, used);
    if (roles & kMetallicRoughnessImage) {
      mark(import.scene, material.metallic_roughness_texture, kDecodedBytes, used);
    }
    if (roles & kNormalImage) mark(import.scene, material.normal_texture, kDecodedBytes, used);
    if (roles & kOcclusionImage) mark(import.scene, material.occlusion_texture, kDecodedBytes, used);
    if (roles & kEmissiveImage) mark(import.scene, material.emissive_texture, kTextureBytes, used);
  }
  return used;
}

/// Fills `image` or returns the error.
std::optional<InputError> decode(const Import& import, std::size_t index, std::uint64_t pixel_bytes,
                                 Image& image) {
  try {
    const EncodedImage encoded = import.document.read_image(index);
    const std::string place = encoded.name == element("images", index)
                                  ? encoded.name
                                  : element("images", index) + " (" + encoded.name + ")";
    if (!encoded.problem.empty()) import.report.fail(place, encoded.problem);
    ImageLimits limits;
    limits.max_pixels = import.options.max_image_pixels;
    limits.budget = import.options.budget.get();
    limits.bytes_a_pixel = pixel_bytes;
    image = decode_image(encoded.bytes, import.report.file() + ": " + place, limits);
    image.name = encoded.name;
    return std::nullopt;
  } catch (const InputError& error) {
    return error;
  }
}

/// Pictures within the model's own files are packed as tightly as in files of their own. Many may share
/// bytes, but no more count than there are.
void add_embedded(Import& import, const std::vector<std::uint64_t>& used) {
  const nlohmann::json& document = import.document.tree();
  std::uint64_t embedded = 0, most = 0;
  for (const Buffer& buffer : import.document.buffers()) most += buffer.bytes.size();
  for (std::size_t i = 0; i < used.size(); ++i) {
    const nlohmann::json& image = document["images"][i];
    const auto view = image.find("bufferView");
    if (used[i] != 0 && view != image.end() && import.document.has_bytes(view->get<int>())) {
      embedded += import.document.view_bytes(view->get<int>()).size();
    }
  }
  import.options.budget->add_file(std::min(embedded, most), Budget::Kind::picture, import.report.file());
}

}  // namespace

void import_images(Import& import) {
  const std::size_t count = import.document.image_count();
  import.scene.images.resize(count);
  for (std::size_t i = 0; i < count; ++i) import.scene.images[i].name = element("images", i);
  const std::vector<std::uint64_t> bytes = pixel_bytes(import, count);
  add_embedded(import, bytes);
  std::vector<std::optional<InputError>> errors(count);
  const auto decode_one = [&](std::size_t i) {
    if (bytes[i] != 0) errors[i] = decode(import, i, bytes[i], import.scene.images[i]);
  };
  tbb::parallel_for(std::size_t{0}, count, decode_one, tbb::simple_partitioner());
  for (const auto& error : errors) {
    if (error) throw *error;
  }
}

}  // namespace barrido::scene::gltf
