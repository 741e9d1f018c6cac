#include "pipeline/pictures/read.h"

#include "pipeline/files/bytes.h"
#include "pipeline/pictures/codecs.h"
#include "pipeline/pictures/header_check.h"
#include "pipeline/pictures/pack.h"

namespace barrido::scene {
namespace {

/// More than any picture within the default limits needs.
constexpr std::uint64_t kMaxFileBytes = std::uint64_t{1} << 30;

/// A regular file's bytes and the format they are in.
struct Recognized {
  gltf::Content content;
  const FormatTraits* format = nullptr;
};

Recognized recognize(const std::filesystem::path& path, const ImageLimits& limits) {
  const std::string name = path.string();
  Recognized file{gltf::read_regular_file(path, kMaxFileBytes, limits.budget, Budget::Kind::picture),
                  nullptr};
  if (!file.content.problem.empty()) throw InputError(name, "", file.content.problem);
  const auto bytes = file.content.block.bytes();
  if (bytes.empty()) throw InputError(name, "", "the picture is empty (0 bytes)");
  file.format = format_by_content(bytes, path);
  if (file.format == nullptr || !file.format->is_read) {
    throw InputError(name, "",
                     "not a picture in a format that is read (PNG, JPEG, EXR, HDR, TIFF, BMP, TGA)");
  }
  if (file.format->openimageio_name != nullptr) check_header(bytes, *file.format, name, limits);
  return file;
}

/// Integers in 0..`most` as fractions.
template <class Values>
std::vector<float> fractions(const Values& values, float most) {
  std::vector<float> result(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) result[i] = static_cast<float>(values[i]) / most;
  return result;
}

}  // namespace

Picture read_picture(const std::filesystem::path& path, const ImageLimits& limits) {
  const Recognized file = recognize(path, limits);
  if (file.format->openimageio_name != nullptr) return read_with_module(path, *file.format, limits);
  return decode_image(file.content.block.bytes(), path.string(), limits);
}

StoredPicture read_stored_picture(const std::filesystem::path& path, const ImageLimits& asked) {
  ImageLimits limits = asked;
  limits.bytes_a_pixel = 24;  // Floats, and 16-bit integers on the way to them
  const Recognized file = recognize(path, limits);
  if (file.format->openimageio_name != nullptr) return read_stored_with_module(path, *file.format, limits);
  const auto bytes = file.content.block.bytes();
  if (is_png(bytes)) {
    const Samples16 samples = decode_png_16(bytes, path.string(), limits);
    return {samples.width, samples.height, samples.channels, false, false, fractions(samples.rgba, 65535.0f)};
  }
  const Image image = decode_image(bytes, path.string(), limits);
  return {image.width, image.height, 3, false, false, fractions(image.rgba, 255.0f)};
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
