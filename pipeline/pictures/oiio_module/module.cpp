// OpenImageIO behind a C interface, as a module that is loaded when a picture other than PNG or JPEG is read
// or written. Enters: paths and pixels. Leaves: pixels, files, reasons. Must not know: anything of Barrido
// but the interface.
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/files/module_guard.h"
#include "pipeline/pictures/oiio_module/interface.h"

namespace {

/// More channels than any picture has that is meant to be looked at.
constexpr int kMaxChannels = 64;
constexpr int kMaxTileSide = 4096;

using barrido::module::guarded;
using barrido::module::set_error;

OIIO::TypeDesc type_of(BarridoOiioType type) {
  return type == BARRIDO_OIIO_FLOAT ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
}

/// Why a header is refused; empty when it is fine.
std::string problem_of(const OIIO::ImageSpec& spec) {
  if (spec.deep) return "deep pictures are not read";
  if (spec.depth > 1) return "volumes are not read";
  if (spec.width < 1 || spec.height < 1) return "the picture is empty";
  if (spec.nchannels < 1 || spec.nchannels > kMaxChannels) {
    return std::to_string(spec.nchannels) + " channels; 1 to " + std::to_string(kMaxChannels) + " are read";
  }
  if (spec.tile_width > kMaxTileSide || spec.tile_height > kMaxTileSide) {
    return "tiles of more than " + std::to_string(kMaxTileSide) + " pixels a side are not read";
  }
  return {};
}

BarridoOiioHeader header_of(const OIIO::ImageSpec& spec) {
  const bool has_alpha = (spec.alpha_channel == 1 && spec.nchannels == 2) || spec.alpha_channel == 3;
  BarridoOiioHeader header{};
  header.width = spec.width;
  header.height = spec.height;
  header.channels = spec.nchannels >= 3 ? (has_alpha ? 4 : 3) : (has_alpha ? 2 : 1);
  header.is_float = spec.format.is_floating_point() ? 1 : 0;
  header.associated_alpha = has_alpha && spec.get_int_attribute("oiio:UnassociatedAlpha") == 0 ? 1 : 0;
  const int orientation = spec.get_int_attribute("Orientation", 1);
  header.orientation = orientation >= 1 && orientation <= 8 ? orientation : 1;
  header.row_step = spec.tile_width > 0 ? std::max(spec.tile_height, 1) : 1;
  return header;
}

}  // namespace

struct BarridoOiioReader {
  std::unique_ptr<OIIO::ImageInput> input;
  BarridoOiioHeader header;
};

namespace {

BarridoOiioReader* open_reader(const char* path, const char* format, BarridoOiioHeader* header,
                               BarridoModuleError* error) {
  return guarded(error, [&]() -> BarridoOiioReader* {
    auto reader = std::make_unique<BarridoOiioReader>();
    reader->input = OIIO::ImageInput::create(format);
    if (!reader->input) {
      set_error(error, std::string("this OpenImageIO has no reader for ") + format + ": " + OIIO::geterror());
      return nullptr;
    }
    OIIO::ImageSpec wishes;
    wishes.attribute("oiio:UnassociatedAlpha", 1);  // else straight alpha is multiplied into the colours
    OIIO::ImageSpec spec;
    if (!reader->input->open(path, spec, wishes)) {
      set_error(error, reader->input->geterror());
      return nullptr;
    }
    if (std::string problem = problem_of(spec); !problem.empty()) {
      set_error(error, std::move(problem));
      return nullptr;
    }
    reader->header = header_of(spec);
    // Of Radiance's "+X +Y" and "-X -Y" OpenImageIO 2.4 gives each the number of the other.
    int32_t& orientation = reader->header.orientation;
    if (std::strcmp(format, "hdr") == 0 && (orientation == 6 || orientation == 8))
      orientation = 14 - orientation;
    *header = reader->header;
    return reader.release();
  });
}

int read_rows(BarridoOiioReader* reader, int32_t begin, int32_t end, BarridoOiioType type, void* pixels,
              BarridoModuleError* error) {
  return guarded(error, [&]() -> int {
    OIIO::ImageInput& input = *reader->input;
    const OIIO::ImageSpec& spec = input.spec();
    const int channels = reader->header.channels;
    const bool done = spec.tile_width > 0
                          ? input.read_tiles(0, 0, spec.x, spec.x + spec.width, spec.y + begin, spec.y + end,
                                             spec.z, spec.z + 1, 0, channels, type_of(type), pixels)
                          : input.read_scanlines(0, 0, spec.y + begin, spec.y + end, spec.z, 0, channels,
                                                 type_of(type), pixels);
    if (!done) set_error(error, input.geterror());
    return done ? 1 : 0;
  });
}

void close_reader(BarridoOiioReader* reader) { delete reader; }

int write_picture(const char* path, const char* format, const BarridoOiioPicture* picture,
                  BarridoModuleError* error) {
  return guarded(error, [&]() -> int {
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
    if (!output) {
      set_error(error, std::string("this OpenImageIO has no writer for ") + format + ": " + OIIO::geterror());
      return 0;
    }
    const bool half = picture->type == BARRIDO_OIIO_FLOAT && picture->half_floats != 0;
    OIIO::ImageSpec spec(picture->width, picture->height, picture->channels,
                         half ? OIIO::TypeDesc(OIIO::TypeDesc::HALF) : type_of(picture->type));
    spec.attribute("oiio:UnassociatedAlpha", picture->associated_alpha != 0 ? 0 : 1);
    spec.attribute("oiio:ColorSpace", picture->type == BARRIDO_OIIO_FLOAT ? "linear" : "sRGB");
    spec.attribute("compression", "zip");
    const bool done = output->open(path, spec) &&
                      output->write_image(type_of(picture->type), picture->pixels) && output->close();
    if (!done) set_error(error, output->geterror());
    return done ? 1 : 0;
  });
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const BarridoOiioFunctions* barrido_oiio_functions(void) {
  static const BarridoOiioFunctions functions{BARRIDO_OIIO_INTERFACE_VERSION, open_reader, read_rows,
                                              close_reader, write_picture};
  return &functions;
}
