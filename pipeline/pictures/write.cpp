// Pictures to files and to bytes in memory, by format: PNG and JPEG here, the others through the module.
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkstemp is POSIX's

#include <system_error>

#include "pipeline/files/bytes.h"
#include "pipeline/files/temporary_files.h"
#include "pipeline/files/write_file.h"
#include "pipeline/pictures/format.h"
#include "pipeline/pictures/image_io.h"
#include "pipeline/pictures/module.h"
#include "pipeline/pictures/pack.h"

namespace barrido::scene {
namespace {

namespace fs = std::filesystem;

const FormatTraits& format_to_write(const fs::path& path) {
  const FormatTraits* format = format_by_extension(path);
  if (format != nullptr) return *format;
  const std::string extension = path.extension().string();
  throw InputError(path.string(), "",
                   (extension.empty() ? "a name without extension says no format"
                                      : "'" + extension + "' is no format that can be written") +
                       std::string(" (png jpg exr hdr tif webp bmp tga ppm)"));
}

void write_floats(const fs::path& file, const fs::path& target, const FormatTraits& format,
                  const ImageView& image, const WriteOptions& options) {
  std::vector<float> storage;
  std::span<const float> pixels = floats_of(image, storage);
  const bool alpha = format.has_alpha && options.write_alpha;
  std::vector<float> packed;
  if (!alpha) packed = compose_over_black(pixels);
  if (alpha && format.associated_alpha) packed = associate_alpha(pixels);
  if (!packed.empty()) pixels = packed;
  write_with_module(file, target, format, {image.width, image.height, alpha ? 4 : 3, {}, pixels},
                    options.half_floats && format.format == ImageFormat::exr);
}

void write_bytes(const fs::path& file, const fs::path& target, const FormatTraits& format,
                 const ImageView& image, const WriteOptions& options) {
  PixelBytes storage;
  std::span<const std::uint8_t> pixels = bytes_of(image, storage);
  const bool alpha = format.has_alpha && options.write_alpha && !is_opaque(pixels);
  std::vector<std::uint8_t> packed;
  if (!alpha) {
    packed.resize(pixels.size() / 4 * 3);
    compose_over_black(pixels, packed.data());
    pixels = packed;
  }
  write_with_module(file, target, format, {image.width, image.height, alpha ? 4 : 3, pixels, {}}, false);
}

/// EXR and HDR hold nothing but floats; TIFF holds them where the picture has them.
bool writes_floats(const FormatTraits& format, const ImageView& image) {
  return format.holds_floats && (format.format != ImageFormat::tiff || !image.rgba_float.empty());
}

void write_external(const fs::path& file, const fs::path& target, const FormatTraits& format,
                    const ImageView& image, const WriteOptions& options) {
  if (writes_floats(format, image)) {
    write_floats(file, target, format, image, options);
  } else {
    write_bytes(file, target, format, image, options);
  }
}

std::vector<std::uint8_t> encode_built_in(const FormatTraits& format, const ImageView& image,
                                          const WriteOptions& options) {
  return format.format == ImageFormat::png ? encode_png(image, options) : encode_jpeg(image, options);
}

/// A folder of our own for files that exist only on the way to memory.
fs::path make_temporary_folder() {
  std::string pattern = (fs::temp_directory_path() / "barrido-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) {
    throw InputError(pattern, "", "a temporary folder cannot be made");
  }
  return pattern;
}

}  // namespace

bool is_writable_format(const fs::path& path) { return format_by_extension(path) != nullptr; }

std::vector<std::uint8_t> encode_image(const std::string& extension, const ImageView& image,
                                       const WriteOptions& options) {
  const std::string name = "picture." + (extension.starts_with('.') ? extension.substr(1) : extension);
  const FormatTraits& format = format_to_write(name);
  if (format.openimageio_name == nullptr) return encode_built_in(format, image, options);
  // Most of the module's writers know files only.
  const TemporaryPath folder(make_temporary_folder);
  const TemporaryPath file_in_folder(folder.path() / name);
  const fs::path& file = file_in_folder.path();
  write_external(file, file, format, image, options);
  const gltf::Content content = gltf::read_regular_file(file, std::uint64_t{1} << 40);
  if (!content.problem.empty()) throw InputError(file.string(), "", content.problem);
  return {content.block.bytes().begin(), content.block.bytes().end()};
}

void write_image(const fs::path& path, const ImageView& image, const WriteOptions& options) {
  const FormatTraits& format = format_to_write(path);
  if (format.openimageio_name == nullptr) return write_file(path, encode_built_in(format, image, options));
  write_atomically(path, [&](const fs::path& file) { write_external(file, path, format, image, options); });
}

}  // namespace barrido::scene
