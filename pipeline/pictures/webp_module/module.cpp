// libwebp behind a C interface, as a module that is loaded when a WebP picture is read or an animation
// written. Must not know:
// anything of Barrido but the interface.
#include <webp/decode.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include <memory>

#include "pipeline/files/module_guard.h"
#include "pipeline/pictures/webp_module/interface.h"

struct BarridoWebpWriter {
  int width = 0, height = 0;
  WebPAnimEncoder* encoder = nullptr;
  WebPData data{};
};

namespace {

using barrido::module::guarded;
using barrido::module::set_error;

int read_size(const uint8_t* bytes, size_t size, int32_t* width, int32_t* height, BarridoModuleError* error) {
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(bytes, size, &features) != VP8_STATUS_OK) {
    set_error(error, "its header is damaged");
    return 0;
  }
  if (features.has_animation != 0) {
    set_error(error, "animations are not read");
    return 0;
  }
  *width = features.width;
  *height = features.height;
  return 1;
}

int decode(const uint8_t* bytes, size_t size, int32_t width, int32_t height, uint8_t* rgba,
           BarridoModuleError* error) {
  const auto stride = static_cast<std::size_t>(width) * 4;
  // It gives nothing where it can only decode a part.
  if (WebPDecodeRGBAInto(bytes, size, rgba, stride * static_cast<std::size_t>(height),
                         static_cast<int>(stride)) != nullptr) {
    return 1;
  }
  set_error(error, "its pixels are damaged or cut off");
  return 0;
}

void close_writer(BarridoWebpWriter* writer) {
  WebPAnimEncoderDelete(writer->encoder);
  WebPDataClear(&writer->data);
  delete writer;
}

using Writer = std::unique_ptr<BarridoWebpWriter, void (*)(BarridoWebpWriter*)>;

BarridoWebpWriter* open_writer(int32_t width, int32_t height, BarridoModuleError* error) {
  Writer writer(guarded(error, [] { return new BarridoWebpWriter; }), close_writer);
  if (!writer) return nullptr;
  writer->width = width;
  writer->height = height;
  WebPAnimEncoderOptions options;
  if (WebPAnimEncoderOptionsInit(&options) != 0) {
    writer->encoder = WebPAnimEncoderNew(width, height, &options);
  }
  if (writer->encoder != nullptr) return writer.release();
  set_error(error, "libwebp makes no encoder of this size");
  return nullptr;
}

int fail(const BarridoWebpWriter* writer, BarridoModuleError* error) {
  set_error(error, WebPAnimEncoderGetError(writer->encoder));
  return 0;
}

int add_frame(BarridoWebpWriter* writer, const uint8_t* rgba, int32_t begin_ms, BarridoModuleError* error) {
  WebPConfig config;
  WebPPicture picture;
  if (WebPConfigInit(&config) == 0 || WebPPictureInit(&picture) == 0) {
    set_error(error, "libwebp has another version than its headers");
    return 0;
  }
  config.lossless = 1;
  config.exact = 1;  // also the colours of what lets all through
  config.quality = 30;
  config.method = 2;
  picture.use_argb = 1;
  picture.width = writer->width;
  picture.height = writer->height;
  const bool added = WebPPictureImportRGBA(&picture, rgba, 4 * writer->width) != 0 &&
                     WebPAnimEncoderAdd(writer->encoder, &picture, begin_ms, &config) != 0;
  WebPPictureFree(&picture);
  return added ? 1 : fail(writer, error);
}

int finish(BarridoWebpWriter* writer, int32_t end_ms, const uint8_t** bytes, size_t* size,
           BarridoModuleError* error) {
  if (WebPAnimEncoderAdd(writer->encoder, nullptr, end_ms, nullptr) == 0 ||
      WebPAnimEncoderAssemble(writer->encoder, &writer->data) == 0) {
    return fail(writer, error);
  }
  *bytes = writer->data.bytes;
  *size = writer->data.size;
  return 1;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const BarridoWebpFunctions* barrido_webp_functions(void) {
  static const BarridoWebpFunctions functions{
      BARRIDO_WEBP_INTERFACE_VERSION, read_size, decode, open_writer, add_frame, finish, close_writer};
  return &functions;
}
