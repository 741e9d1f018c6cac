// JPEG from pixels to bytes with libjpeg-turbo: baseline, so that any reader shows it. The library reports
// errors by longjmp, so the function between setjmp and its calls holds nothing that needs a destructor.
#include <csetjmp>
#include <cstdio>
#include <cstdlib>

// jpeglib.h needs size_t and FILE, which <cstdio> declares.
#include <jpeglib.h>

#include <algorithm>
#include <stdexcept>

#include "pipeline/pictures/image_io.h"
#include "pipeline/pictures/pack.h"

namespace barrido::scene {
namespace {

/// From here on colour keeps its full resolution; below, it is halved both ways.
constexpr int kFullColorQuality = 90;

struct ErrorManager {
  jpeg_error_mgr base;  // first, so that the library's pointer is ours
  std::jmp_buf target;
  char message[JMSG_LENGTH_MAX];
};

[[noreturn]] void on_error(j_common_ptr info) {
  auto* manager = reinterpret_cast<ErrorManager*>(info->err);
  info->err->format_message(info, manager->message);
  std::longjmp(manager->target, 1);
}

/// Everything that lives while a picture is encoded; freed by its destructor, outside the jumps.
struct Encoder {
  jpeg_compress_struct info{};
  ErrorManager error{};
  unsigned char* bytes = nullptr;
  unsigned long size = 0;

  Encoder() {
    info.err = jpeg_std_error(&error.base);
    error.base.error_exit = on_error;
  }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;
  ~Encoder() {
    jpeg_destroy_compress(&info);
    std::free(bytes);  // jpeg_mem_dest allocates with malloc
  }
};

/// `row_pixels` has room for a row of RGB, used where the picture is not opaque.
bool encode(Encoder& encoder, int width, int height, const std::uint8_t* rgba, bool opaque, int quality,
            std::uint8_t* row_pixels) {
  if (setjmp(encoder.error.target) != 0) return false;
  jpeg_create_compress(&encoder.info);
  jpeg_mem_dest(&encoder.info, &encoder.bytes, &encoder.size);
  encoder.info.image_width = static_cast<JDIMENSION>(width);
  encoder.info.image_height = static_cast<JDIMENSION>(height);
  encoder.info.input_components = opaque ? 4 : 3;
  encoder.info.in_color_space = opaque ? JCS_EXT_RGBX : JCS_RGB;
  jpeg_set_defaults(&encoder.info);
  jpeg_set_quality(&encoder.info, quality, TRUE);
  const int subsampling = quality >= kFullColorQuality ? 1 : 2;
  encoder.info.comp_info[0].h_samp_factor = subsampling;
  encoder.info.comp_info[0].v_samp_factor = subsampling;
  jpeg_start_compress(&encoder.info, TRUE);
  const std::size_t pitch = static_cast<std::size_t>(width) * 4;
  while (encoder.info.next_scanline < encoder.info.image_height) {
    const std::uint8_t* in = rgba + encoder.info.next_scanline * pitch;
    if (!opaque) compose_over_black({in, pitch}, row_pixels);
    JSAMPROW row = opaque ? const_cast<JSAMPROW>(in) : row_pixels;  // the library only reads it
    jpeg_write_scanlines(&encoder.info, &row, 1);
  }
  jpeg_finish_compress(&encoder.info);
  return true;
}

}  // namespace

std::vector<std::uint8_t> encode_jpeg(const ImageView& image, const WriteOptions& options) {
  PixelBytes storage;
  const auto rgba = bytes_of(image, storage);
  std::vector<std::uint8_t> row_pixels(static_cast<std::size_t>(image.width) * 3);
  Encoder encoder;
  if (!encode(encoder, image.width, image.height, rgba.data(), is_opaque(rgba),
              std::clamp(options.jpeg_quality, 1, 100), row_pixels.data())) {
    throw InputError("JPEG", "", std::string("cannot be encoded: ") + encoder.error.message);
  }
  return {encoder.bytes, encoder.bytes + encoder.size};
}

}  // namespace barrido::scene
