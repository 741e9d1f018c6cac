#include "pipeline/scene/image_read.h"

#include "pipeline/scene/gltf_bytes.h"
#include "pipeline/scene/image_codecs.h"
#include "pipeline/scene/image_header_check.h"
#include "pipeline/scene/image_pack.h"

namespace barrido::scene {
namespace {

/// More than any picture within the default limits needs.
constexpr std::uint64_t kMaxFileBytes = std::uint64_t{1} << 30;

}  // namespace

Picture read_picture(const std::filesystem::path& path, const ImageLimits& limits) {
  const std::string name = path.string();
  const gltf::Content content = gltf::read_regular_file(path, kMaxFileBytes);
  if (!content.problem.empty()) throw InputError(name, "", content.problem);
  const auto bytes = content.block.bytes();
  if (bytes.empty()) throw InputError(name, "", "the picture is empty (0 bytes)");
  const FormatTraits* format = format_by_content(bytes, path);
  if (format == nullptr || !format->is_read) {
    throw InputError(name, "",
                     "not a picture in a format that is read (PNG, JPEG, EXR, HDR, TIFF, BMP, TGA)");
  }
  if (format->openimageio_name == nullptr) return decode_image(bytes, name, limits);
  check_header(bytes, *format, name, limits);
  return read_with_module(path, *format, limits);
}

Image read_image(const std::filesystem::path& path, const ImageLimits& limits) {
  Picture picture = read_picture(path, limits);
  if (auto* image = std::get_if<Image>(&picture)) return std::move(*image);
  const auto& floats = std::get<FloatImage>(picture);
  Image image{path.string(), floats.width, floats.height, {}};
  bytes_of({floats.width, floats.height, {}, floats.rgba}, image.rgba);
  return image;
}

FloatImage read_float_image(const std::filesystem::path& path, const ImageLimits& limits) {
  Picture picture = read_picture(path, limits);
  if (auto* floats = std::get_if<FloatImage>(&picture)) return std::move(*floats);
  const auto& image = std::get<Image>(picture);
  FloatImage floats{image.width, image.height, {}};
  floats_of({image.width, image.height, image.rgba, {}}, floats.rgba);
  return floats;
}

}  // namespace barrido::scene
