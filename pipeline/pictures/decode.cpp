// Tells PNG, JPEG, WebP and KTX2 apart by the first bytes and has the right library decode them. Enters: a
// whole file in memory. Must not know: paths, other formats.
#include "pipeline/pictures/codecs.h"

namespace barrido::scene {

void check_image_size(std::uint64_t width, std::uint64_t height, const std::string& name,
                      const ImageLimits& limits) {
  const auto max_side = static_cast<std::uint64_t>(limits.max_side);
  const std::string size = std::to_string(width) + " × " + std::to_string(height) + " pixels";
  if (width < 1 || height < 1) throw InputError(name, "", "a picture of " + size + " is empty");
  if (width > max_side || height > max_side) {
    throw InputError(name, "", size + ": a side may have at most " + std::to_string(max_side));
  }
  if (width * height > limits.max_pixels) {
    throw InputError(name, "", size + ": a picture may have at most " + std::to_string(limits.max_pixels));
  }
  if (limits.budget != nullptr) limits.budget->take(width * height * limits.bytes_a_pixel, name, "");
}

Image decode_image(std::span<const std::uint8_t> bytes, const std::string& name, const ImageLimits& limits) {
  if (bytes.empty()) throw InputError(name, "", "the picture is empty (0 bytes)");
  if (is_png(bytes)) return decode_png(bytes, name, limits);
  if (is_jpeg(bytes)) return decode_jpeg(bytes, name, limits);
  if (is_webp(bytes)) return decode_webp(bytes, name, limits);
  if (is_ktx2(bytes)) return decode_ktx2(bytes, name, limits);
  throw InputError(name, "", "neither PNG nor JPEG, by its first bytes");
}

}  // namespace barrido::scene
