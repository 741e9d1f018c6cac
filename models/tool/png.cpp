#include "models/tool/png.h"

#include <cstdlib>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>

#include <spng.h>

#include "models/tool/file.h"

namespace barrido::models {
namespace {

using Context = std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)>;

void check(int error, const std::string& name) {
  if (error != 0) throw std::runtime_error(name + ": " + spng_strerror(error));
}

/// The picture as indices into at most 256 colours; no colours when it has more.
struct Indexed {
  std::vector<std::uint8_t> indices;
  spng_plte palette{};
};

Indexed to_indexed(const Picture& picture) {
  Indexed result;
  std::map<std::uint32_t, std::uint8_t> index_of_color;
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
    const std::uint8_t* c = &picture.rgb[i];
    const std::uint32_t key = (std::uint32_t{c[0]} << 16) | (std::uint32_t{c[1]} << 8) | c[2];
    const auto [found, is_new] =
        index_of_color.try_emplace(key, static_cast<std::uint8_t>(result.palette.n_entries));
    if (is_new) {
      if (result.palette.n_entries == 256) return {};
      result.palette.entries[result.palette.n_entries++] = {c[0], c[1], c[2], 255};
    }
    result.indices.push_back(found->second);
  }
  return result;
}

std::vector<std::uint8_t> encode(const Picture& picture, const Indexed& indexed, int filters) {
  const Context context(spng_ctx_new(SPNG_CTX_ENCODER), &spng_ctx_free);
  const bool use_palette = indexed.palette.n_entries > 0;
  spng_ihdr header{};
  header.width = static_cast<std::uint32_t>(picture.width);
  header.height = static_cast<std::uint32_t>(picture.height);
  header.bit_depth = 8;
  header.color_type = use_palette ? SPNG_COLOR_TYPE_INDEXED : SPNG_COLOR_TYPE_TRUECOLOR;
  check(spng_set_ihdr(context.get(), &header), "png header");
  if (use_palette) {
    spng_plte palette = indexed.palette;
    check(spng_set_plte(context.get(), &palette), "png palette");
  }
  check(spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1), "png buffer");
  check(spng_set_option(context.get(), SPNG_IMG_COMPRESSION_LEVEL, 9), "png compression");
  check(spng_set_option(context.get(), SPNG_FILTER_CHOICE, filters), "png filter");
  const std::vector<std::uint8_t>& pixels = use_palette ? indexed.indices : picture.rgb;
  check(spng_encode_image(context.get(), pixels.data(), pixels.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE),
        "png pixels");
  int error = 0;
  std::size_t size = 0;
  void* buffer = spng_get_png_buffer(context.get(), &size, &error);
  check(error, "png buffer");
  const std::unique_ptr<void, decltype(&std::free)> owner(buffer, &std::free);
  const auto* bytes = static_cast<const std::uint8_t*>(buffer);
  return {bytes, bytes + size};
}

}  // namespace

std::vector<std::uint8_t> encode_small_png(const Picture& picture) {
  const Indexed indexed = to_indexed(picture);
  // Filters help where neighbouring bytes are close in value, which indices of a palette are not.
  const bool use_palette = indexed.palette.n_entries > 0;
  std::vector<std::uint8_t> smallest;
  for (const int filters : {SPNG_FILTER_CHOICE_NONE, SPNG_FILTER_CHOICE_PAETH, SPNG_FILTER_CHOICE_ALL}) {
    if (use_palette && filters != SPNG_FILTER_CHOICE_NONE) continue;
    std::vector<std::uint8_t> bytes = encode(picture, indexed, filters);
    if (smallest.empty() || bytes.size() < smallest.size()) smallest = std::move(bytes);
  }
  return smallest;
}

Picture read_png(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> bytes = read_file(path);
  const Context context(spng_ctx_new(0), &spng_ctx_free);
  check(spng_set_png_buffer(context.get(), bytes.data(), bytes.size()), path.string());
  spng_ihdr header{};
  check(spng_get_ihdr(context.get(), &header), path.string());
  Picture picture{static_cast<int>(header.width), static_cast<int>(header.height), {}};
  picture.rgb.resize(std::size_t{header.width} * header.height * 3);
  check(spng_decode_image(context.get(), picture.rgb.data(), picture.rgb.size(), SPNG_FMT_RGB8, 0),
        path.string());
  return picture;
}

}  // namespace barrido::models
