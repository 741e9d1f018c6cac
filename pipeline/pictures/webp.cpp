// WebP (RFC 9649), by libwebp in a module of its own. Enters: the bytes of a whole file. Must not know:
// paths.
#include <algorithm>

#include "pipeline/files/module_loader.h"
#include "pipeline/pictures/codecs.h"
#include "pipeline/pictures/webp_module/interface.h"

namespace barrido::scene {

bool is_webp(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kRiff = "RIFF", kWebp = "WEBP";
  return bytes.size() >= 12 && std::equal(kRiff.begin(), kRiff.end(), bytes.begin()) &&
         std::equal(kWebp.begin(), kWebp.end(), bytes.begin() + 8);
}

const BarridoWebpFunctions* webp_functions(const std::string& name, const std::string& purpose) {
  static const Module module("barrido_webp.so", BARRIDO_WEBP_ENTRY, BARRIDO_WEBP_INTERFACE_VERSION);
  const auto* functions = module.functions<BarridoWebpFunctions>();
  if (functions == nullptr) throw InputError(name, "", module.problem(purpose));
  return functions;
}

Image decode_webp(std::span<const std::uint8_t> bytes, const std::string& name, const ImageLimits& limits) {
  const auto* functions = webp_functions(name, "reading WebP");
  const auto fail = [&](const BarridoModuleError& error) {
    throw InputError(name, "", std::string("damaged WebP: ") + error.text);
  };
  BarridoModuleError error{};
  std::int32_t width = 0, height = 0;
  if (functions->read_size(bytes.data(), bytes.size(), &width, &height, &error) == 0) fail(error);
  ImageLimits with_decoder = limits;
  with_decoder.bytes_a_pixel =
      std::max<std::uint64_t>(limits.bytes_a_pixel, 10);  // libwebp's planes and ours
  check_image_size(static_cast<std::uint64_t>(std::max(width, 0)),
                   static_cast<std::uint64_t>(std::max(height, 0)), name, with_decoder);
  Image image{name, width, height, {}};
  image.rgba.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  if (functions->decode(bytes.data(), bytes.size(), width, height, image.rgba.data(), &error) == 0) {
    fail(error);
  }
  return image;
}

}  // namespace barrido::scene
