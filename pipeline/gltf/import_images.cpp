// Images: those that a material uses are read and decoded, each by whichever thread is free. One that is
// missing or damaged stays empty, with a warning: materials are drawn without it. Where memory is short, it
// depends on the threads which one is reported.
#include <algorithm>
#include <cstdint>
#include <exception>
#include <string>
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

void mark_layers(const Scene& scene, const MaterialLayers& layers, std::vector<std::uint64_t>& used) {
  if (layers.specular_glossiness) mark(scene, layers.specular_glossiness->texture, kDecodedBytes, used);
  for (const TextureUse* use :
       {&layers.sheen_color_texture, &layers.clearcoat_texture, &layers.clearcoat_roughness_texture,
        &layers.iridescence_texture, &layers.thickness_texture}) {
    mark(scene, *use, kDecodedBytes, used);
  }
  for (const TextureUse* use : {&layers.specular_texture, &layers.specular_color_texture}) {
    mark(scene, *use, kTextureBytes, used);
  }
  // Filtered by it and by what it leaves.
  mark(scene, layers.transmission_texture, 2 * kTextureBytes, used);
}

/// Images in no other role are looked at by those who want to know what is in the file; nothing is drawn with
/// them, so that nothing is wrong where they are missing.
constexpr unsigned kDrawnRoles =
    kBaseColorImage | kMetallicRoughnessImage | kNormalImage | kOcclusionImage | kEmissiveImage | kLayerImage;

/// What a pixel of each image will take; 0 for those in none of these roles.
std::vector<std::uint64_t> pixel_bytes(const Import& import, std::size_t count, unsigned roles) {
  std::vector<std::uint64_t> used(count, 0);
  for (const Material& material : import.scene.materials) {
    if (roles & kBaseColorImage) mark(import.scene, material.base_color_texture, kTextureBytes, used);
    if (roles & kMetallicRoughnessImage) {
      mark(import.scene, material.metallic_roughness_texture, kDecodedBytes, used);
    }
    if (roles & kNormalImage) mark(import.scene, material.normal_texture, kTextureBytes, used);
    if (roles & kOcclusionImage) mark(import.scene, material.occlusion_texture, kTextureBytes, used);
    if ((roles & kLayerImage) && material.layers) mark_layers(import.scene, *material.layers, used);
    if (roles & kLayerImage) {
      for (const TextureUse* use :
           {&material.bump.texture, &material.transparency_texture, &material.specularity_texture}) {
        mark(import.scene, *use, kTextureBytes, used);
      }
    }
    if ((roles & kLayerImage) && material.displacement) {
      mark(import.scene, material.displacement->texture, kTextureBytes, used);
    }
    if (roles & kEmissiveImage) mark(import.scene, material.emissive_texture, kTextureBytes, used);
  }
  return used;
}

/// What became of one image.
struct Decoded {
  std::string problem;       ///< Why it is drawn without, in words.
  std::exception_ptr limit;  ///< What ends the import: memory or time.
};

/// Fills `image` or says why not.
Decoded decode(const Import& import, std::size_t index, std::uint64_t pixel_bytes, Image& image) {
  std::string place;
  try {
    const EncodedImage encoded = import.document.read_image(index);
    place = encoded.name == element("images", index) ? encoded.name
                                                     : element("images", index) + " (" + encoded.name + ")";
    image.name = encoded.name;
    if (!encoded.problem.empty()) return {place + ": " + encoded.problem, nullptr};
    ImageLimits limits;
    limits.max_pixels = import.options.max_image_pixels;
    limits.budget = import.options.budget.get();
    limits.bytes_a_pixel = pixel_bytes;
    Image decoded = decode_image(encoded.bytes, place, limits);
    decoded.name = encoded.name;
    image = std::move(decoded);
    return {};
  } catch (const LimitError& error) {
    return {{}, std::make_exception_ptr(LimitError(import.report.file(), "", error.what()))};
  } catch (const InputError& error) {
    return {error.what(), nullptr};
  } catch (const std::bad_alloc&) {
    return {{}, std::current_exception()};
  }
}

/// Textures whose picture cannot be read take the one that their file holds beside it.
void use_fallbacks(Import& import, const std::vector<std::uint64_t>& bytes, std::vector<Decoded>& results) {
  std::vector<bool> replaced(results.size());
  for (Texture& texture : import.scene.textures) {
    if (texture.image == kNone || texture.fallback_image == kNone) continue;
    const auto image = static_cast<std::size_t>(texture.image),
               fallback = static_cast<std::size_t>(texture.fallback_image);
    if (results[image].problem.empty()) continue;
    if (import.scene.images[fallback].rgba.empty() && results[fallback].problem.empty()) {
      results[fallback] = decode(import, fallback, bytes[image], import.scene.images[fallback]);
    }
    import.report.warn(results[image].problem + "; " + element("images", fallback) + " is used in its place");
    texture.image = texture.fallback_image;
    replaced[image] = true;
  }
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (replaced[i]) results[i].problem.clear();
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
    if (used[i] != 0 && view != image.end() && !import.document.view_problem(view->get<int>()) &&
        import.document.has_bytes(view->get<int>())) {
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
  const unsigned roles = import.options.load_images ? import.options.image_roles : 0u;
  const std::vector<std::uint64_t> bytes = pixel_bytes(import, count, roles & kDrawnRoles);
  add_embedded(import, bytes);
  std::vector<Decoded> results(count);
  const auto decode_one = [&](std::size_t i) {
    if (bytes[i] != 0) results[i] = decode(import, i, bytes[i], import.scene.images[i]);
  };
  tbb::parallel_for(std::size_t{0}, count, decode_one, tbb::simple_partitioner());
  use_fallbacks(import, bytes, results);
  for (const Decoded& result : results) {
    if (result.limit) std::rethrow_exception(result.limit);
  }
  for (const Decoded& result : results) {
    if (!result.problem.empty()) import.report.warn(result.problem + "; drawn without this picture");
  }
  const std::vector<std::uint64_t> others = pixel_bytes(import, count, roles & ~kDrawnRoles);
  const auto look_at = [&](std::size_t i) {
    if (bytes[i] == 0 && others[i] != 0) decode(import, i, others[i], import.scene.images[i]);
  };
  tbb::parallel_for(std::size_t{0}, count, look_at, tbb::simple_partitioner());
}

}  // namespace barrido::scene::gltf
