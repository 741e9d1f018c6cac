// libwebp behind a C interface, as a module that is loaded when a WebP picture is read. Must not know:
// anything of Barrido but the interface.
#include <webp/decode.h>

#include "pipeline/files/module_guard.h"
#include "pipeline/pictures/webp_module/interface.h"

namespace {

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

}  // namespace

extern "C" __attribute__((visibility("default"))) const BarridoWebpFunctions* barrido_webp_functions(void) {
  static const BarridoWebpFunctions functions{BARRIDO_WEBP_INTERFACE_VERSION, read_size, decode};
  return &functions;
}
