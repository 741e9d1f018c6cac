#include "pipeline/pictures/module.h"

#include <algorithm>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "pipeline/files/module_loader.h"
#include "pipeline/pictures/codecs.h"
#include "pipeline/pictures/oiio_module/interface.h"

namespace barrido::scene {
namespace {

/// Rows that are read at a time: a header that promises more than the file holds fails in the first of them,
/// before the picture's memory is taken.
constexpr int kRowsAtATime = 64;

const BarridoOiioFunctions& openimageio_module(const std::string& name, const FormatTraits& format,
                                               const std::string& purpose) {
  static const Module module("barrido_oiio.so", BARRIDO_OIIO_ENTRY, BARRIDO_OIIO_INTERFACE_VERSION);
  const auto* functions = module.functions<BarridoOiioFunctions>();
  if (functions == nullptr)
    throw InputError(name, "", module.problem(purpose + " " + std::string(format.name)));
  return *functions;
}

struct ReaderCloser {
  const BarridoOiioFunctions* functions;
  void operator()(BarridoOiioReader* reader) const { functions->close(reader); }
};
using Reader = std::unique_ptr<BarridoOiioReader, ReaderCloser>;

template <class T>
constexpr BarridoOiioType kTypeOf = sizeof(T) == 1 ? BARRIDO_OIIO_UINT8 : BARRIDO_OIIO_FLOAT;

/// Grey is spread over three channels; a missing alpha is opaque.
template <class T>
void widen(const T* in, int channels, std::size_t pixel_count, T opaque, T* rgba) {
  for (std::size_t i = 0; i < pixel_count; ++i, in += channels, rgba += 4) {
    rgba[0] = in[0];
    rgba[1] = in[channels >= 3 ? 1 : 0];
    rgba[2] = in[channels >= 3 ? 2 : 0];
    rgba[3] = channels == 4 ? in[3] : channels == 2 ? in[1] : opaque;
  }
}

template <class T>
using PixelsOf = std::conditional_t<std::is_same_v<T, std::uint8_t>, PixelBytes, std::vector<T>>;

/// Colours multiplied by alpha become straight; where alpha is 0 they stay as they are.
template <class T>
void make_straight(PixelsOf<T>& rgba, float opaque) {
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    const float alpha = static_cast<float>(rgba[i + 3]) / opaque;
    if (!(alpha > 0.0f) || alpha == 1.0f) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const float straight = static_cast<float>(rgba[i + c]) / alpha;
      rgba[i + c] =
          sizeof(T) == 1 ? static_cast<T>(std::min(straight + 0.5f, opaque)) : static_cast<T>(straight);
    }
  }
}

template <class T>
PixelsOf<T> read_pixels(const BarridoOiioFunctions& functions, BarridoOiioReader* reader,
                        const BarridoOiioHeader& header, T opaque, const std::string& name) {
  const int step = std::max(kRowsAtATime / header.row_step, 1) * header.row_step;
  const auto width = static_cast<std::size_t>(header.width);
  std::vector<T> rows(width * static_cast<std::size_t>(std::min(step, header.height) * header.channels));
  PixelsOf<T> rgba;
  for (int begin = 0; begin < header.height; begin += step) {
    const int end = std::min(begin + step, header.height);
    BarridoModuleError error{};
    if (functions.read_rows(reader, begin, end, kTypeOf<T>, rows.data(), &error) == 0) {
      throw InputError(name, "", std::string("cannot be read: ") + error.text);
    }
    if (begin == 0) rgba.resize(width * static_cast<std::size_t>(header.height) * 4);
    widen(rows.data(), header.channels, width * static_cast<std::size_t>(end - begin), opaque,
          rgba.data() + width * static_cast<std::size_t>(begin) * 4);
  }
  return rgba;
}

/// The picture upright: stored row and column of what is seen at (x, y), as TIFF 6.0 (tag 274) defines.
template <class Pixels>
Pixels upright(const Pixels& stored, const BarridoOiioHeader& header) {
  const bool transposed = header.orientation >= 5;
  const bool right_to_left = header.orientation == 2 || header.orientation == 3 || header.orientation == 7 ||
                             header.orientation == 8;
  const bool bottom_first = header.orientation == 3 || header.orientation == 4 || header.orientation == 6 ||
                            header.orientation == 7;
  const int width = transposed ? header.height : header.width;
  const int height = transposed ? header.width : header.height;
  Pixels seen;
  seen.resize(stored.size());
  auto out = seen.begin();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      int column = transposed ? y : x, row = transposed ? x : y;
      if (right_to_left) column = header.width - 1 - column;
      if (bottom_first) row = header.height - 1 - row;
      const auto at = (std::ptrdiff_t{row} * header.width + column) * 4;
      out = std::copy_n(stored.begin() + at, 4, out);
    }
  }
  return seen;
}

/// Afterwards the header has the size of what is seen.
template <class Pixels>
Pixels made_upright(Pixels stored, BarridoOiioHeader& header) {
  if (header.orientation == 1) return stored;
  Pixels seen = upright(stored, header);
  if (header.orientation >= 5) std::swap(header.width, header.height);
  header.orientation = 1;
  return seen;
}

template <class T>
PixelsOf<T> read_straight(const BarridoOiioFunctions& functions, BarridoOiioReader* reader,
                          BarridoOiioHeader& header, T opaque, const std::string& name) {
  PixelsOf<T> rgba = read_pixels<T>(functions, reader, header, opaque, name);
  if (header.associated_alpha != 0) make_straight<T>(rgba, static_cast<float>(opaque));
  return made_upright(std::move(rgba), header);
}

/// Opens the file and reads its header, which is checked.
Reader open_checked(const BarridoOiioFunctions& functions, const std::filesystem::path& path,
                    const FormatTraits& format, const ImageLimits& limits, BarridoOiioHeader& header) {
  const std::string name = path.string();
  BarridoModuleError error{};
  Reader reader(functions.open(path.c_str(), format.openimageio_name, &header, &error), {&functions});
  if (!reader) {
    throw InputError(name, "", "damaged " + std::string(format.name) + ": " + error.text);
  }
  ImageLimits limits_here = limits;
  if (header.is_float != 0) {
    limits_here.max_pixels = limits.max_pixels / 2;
    limits_here.bytes_a_pixel = std::max<std::uint64_t>(limits.bytes_a_pixel, 16);
  }
  if (header.orientation != 1) limits_here.bytes_a_pixel *= 2;  // As stored, and upright
  check_image_size(static_cast<std::uint64_t>(header.width), static_cast<std::uint64_t>(header.height), name,
                   limits_here);
  return reader;
}

/// Whether a file of ours can be read to its last row.
bool is_readable(const BarridoOiioFunctions& functions, const std::filesystem::path& file,
                 const FormatTraits& format) {
  BarridoOiioHeader header{};
  BarridoModuleError error{};
  const Reader reader(functions.open(file.c_str(), format.openimageio_name, &header, &error), {&functions});
  if (!reader) return false;
  const int step = std::max(kRowsAtATime / header.row_step, 1) * header.row_step;
  std::vector<std::uint8_t> rows(static_cast<std::size_t>(header.width) *
                                 static_cast<std::size_t>(std::min(step, header.height) * header.channels));
  for (int begin = 0; begin < header.height; begin += step) {
    const int end = std::min(begin + step, header.height);
    if (functions.read_rows(reader.get(), begin, end, BARRIDO_OIIO_UINT8, rows.data(), &error) == 0) {
      return false;
    }
  }
  return true;
}

}  // namespace

Picture read_with_module(const std::filesystem::path& path, const FormatTraits& format,
                         const ImageLimits& limits) {
  const std::string name = path.string();
  const BarridoOiioFunctions& functions = openimageio_module(name, format, "reading");
  BarridoOiioHeader header{};
  const Reader reader = open_checked(functions, path, format, limits, header);
  if (header.is_float != 0) {
    FloatImage image;
    image.rgba = read_straight<float>(functions, reader.get(), header, 1.0f, name);
    image.width = header.width;
    image.height = header.height;
    return image;
  }
  Image image;
  image.name = name;
  image.rgba = read_straight<std::uint8_t>(functions, reader.get(), header, 255, name);
  image.width = header.width;
  image.height = header.height;
  return image;
}

StoredPicture read_stored_with_module(const std::filesystem::path& path, const FormatTraits& format,
                                      const ImageLimits& limits) {
  const std::string name = path.string();
  const BarridoOiioFunctions& functions = openimageio_module(name, format, "reading");
  BarridoOiioHeader header{};
  const Reader reader = open_checked(functions, path, format, limits, header);
  StoredPicture picture;
  picture.channels = header.channels;
  picture.is_linear = header.is_float != 0;
  picture.is_associated = header.associated_alpha != 0;
  picture.rgba = made_upright(read_pixels<float>(functions, reader.get(), header, 1.0f, name), header);
  picture.width = header.width;
  picture.height = header.height;
  return picture;
}

void write_with_module(const std::filesystem::path& file, const std::filesystem::path& target,
                       const FormatTraits& format, const PackedPicture& picture, bool half_floats) {
  const BarridoOiioFunctions& functions = openimageio_module(target.string(), format, "writing");
  BarridoOiioPicture packed{};
  packed.width = picture.width;
  packed.height = picture.height;
  packed.channels = picture.channels;
  packed.type = picture.floats.empty() ? BARRIDO_OIIO_UINT8 : BARRIDO_OIIO_FLOAT;
  packed.half_floats = half_floats ? 1 : 0;
  packed.associated_alpha = format.associated_alpha ? 1 : 0;
  packed.pixels = picture.floats.empty() ? static_cast<const void*>(picture.bytes.data())
                                         : static_cast<const void*>(picture.floats.data());
  BarridoModuleError error{};
  if (functions.write(file.c_str(), format.openimageio_name, &packed, &error) == 0) {
    throw InputError(target.string(), "", std::string("cannot be written: ") + error.text);
  }
  // TIFF's writer does not tell of a full disk. Pipes and devices cannot be read again.
  std::error_code ignored;
  const bool can_check =
      format.format == ImageFormat::tiff && std::filesystem::is_regular_file(file, ignored);
  if (can_check && !is_readable(functions, file, format)) {
    throw InputError(target.string(), "", "cannot be written whole: is the disk full?");
  }
}

}  // namespace barrido::scene
