// JPEG from bytes to straight RGBA8 with libjpeg-turbo. Enters: a whole file in memory. Must not know: paths,
// scenes. The library reports errors by longjmp, so the functions between setjmp and its calls hold
// nothing that needs a destructor.
#include <csetjmp>
#include <cstdio>

// jpeglib.h needs size_t and FILE, which <cstdio> declares.
#include <jpeglib.h>
// jerror.h needs jpeglib.h
#include <jerror.h>

#include <algorithm>

#include "pipeline/pictures/codecs.h"

namespace barrido::scene {
namespace {

/// Progressive pictures may repeat scans without end in a few bytes each.
constexpr int kMaxScans = 100;
constexpr std::uint64_t kMaxScannedPixels = std::uint64_t{1} << 31;

struct ErrorManager {
  jpeg_error_mgr base;  // first, so that the library's pointer is ours
  std::jmp_buf target;
  char message[JMSG_LENGTH_MAX];
};

[[noreturn]] void leave(j_common_ptr info, const char* message) {
  auto* manager = reinterpret_cast<ErrorManager*>(info->err);
  if (message == nullptr) {
    info->err->format_message(info, manager->message);
  } else {
    std::snprintf(manager->message, sizeof(manager->message), "%s", message);
  }
  std::longjmp(manager->target, 1);
}

[[noreturn]] void on_error(j_common_ptr info) { leave(info, nullptr); }

/// Damage that loses pixels is an error; oddities that lose none (stray bytes between markers) are not.
void on_message(j_common_ptr info, int level) {
  if (level >= 0) return;
  switch (info->err->msg_code) {
    case JWRN_JPEG_EOF:
    case JWRN_HIT_MARKER:
    case JWRN_HUFF_BAD_CODE:
    case JWRN_ARITH_BAD_CODE:
    case JWRN_MUST_RESYNC:
      leave(info, nullptr);
    default:
      break;
  }
}

void on_progress(j_common_ptr info) {
  const auto* decoder = reinterpret_cast<j_decompress_ptr>(info);
  const auto scans = static_cast<std::uint64_t>(std::max(decoder->input_scan_number, 0));
  const std::uint64_t pixels = std::uint64_t{decoder->image_width} * decoder->image_height;
  if (scans > kMaxScans || scans * pixels > kMaxScannedPixels) leave(info, "it has too many scans");
  const auto* budget = static_cast<const Budget*>(info->client_data);
  if (budget != nullptr && budget->is_late())
    leave(info, "it takes too long to read (--max-seconds allows more)");
}

/// Everything that lives while a picture is decoded; freed by its destructor, outside the jumps.
struct Decoder {
  jpeg_decompress_struct info{};
  ErrorManager error{};
  jpeg_progress_mgr progress{};
  bool inverted_cmyk = false;

  Decoder() {
    info.err = jpeg_std_error(&error.base);
    error.base.error_exit = on_error;
    error.base.emit_message = on_message;
    progress.progress_monitor = on_progress;
  }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;
  ~Decoder() { jpeg_destroy_decompress(&info); }
};

bool read_header(Decoder& decoder, std::span<const std::uint8_t> bytes) {
  if (setjmp(decoder.error.target) != 0) return false;
  jpeg_create_decompress(&decoder.info);
  jpeg_mem_src(&decoder.info, bytes.data(), static_cast<unsigned long>(bytes.size()));
  jpeg_read_header(&decoder.info, TRUE);
  const J_COLOR_SPACE space = decoder.info.jpeg_color_space;
  const bool cmyk = space == JCS_CMYK || space == JCS_YCCK;
  decoder.info.out_color_space = cmyk ? JCS_CMYK : JCS_EXT_RGBA;
  // Adobe's programs write ink amounts upside down, and mark the file as theirs.
  decoder.inverted_cmyk = cmyk && decoder.info.saw_Adobe_marker != 0;
  decoder.info.progress = &decoder.progress;
  return true;
}

/// Pictures of several scans are held as 16-bit coefficients of whole blocks until the last has come.
ImageLimits limits_of(Decoder& decoder, const ImageLimits& asked) {
  ImageLimits limits = asked;
  if (jpeg_has_multiple_scans(&decoder.info) != FALSE) {
    limits.bytes_a_pixel += 2 * static_cast<std::uint64_t>(decoder.info.num_components);
  }
  return limits;
}

/// `pixels` has room for 4 bytes a pixel of the header's size.
bool read_rows(Decoder& decoder, std::uint8_t* pixels) {
  if (setjmp(decoder.error.target) != 0) return false;
  jpeg_start_decompress(&decoder.info);
  const std::size_t pitch = std::size_t{decoder.info.output_width} * 4;
  while (decoder.info.output_scanline < decoder.info.output_height) {
    JSAMPROW row = pixels + decoder.info.output_scanline * pitch;
    jpeg_read_scanlines(&decoder.info, &row, 1);
  }
  jpeg_finish_decompress(&decoder.info);
  return true;
}

/// The naive conversion that browsers use where no profile is applied: r = (1 − c)(1 − k).
void convert_cmyk(PixelBytes& pixels, bool inverted) {
  const unsigned flip = inverted ? 0 : 255;
  for (std::size_t i = 0; i < pixels.size(); i += 4) {
    const unsigned white = pixels[i + 3] ^ flip;
    for (std::size_t c = 0; c < 3; ++c) {
      pixels[i + c] = static_cast<std::uint8_t>(((pixels[i + c] ^ flip) * white + 127) / 255);
    }
    pixels[i + 3] = 255;
  }
}

}  // namespace

bool is_jpeg(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= 3 && bytes[0] == 0xff && bytes[1] == 0xd8 && bytes[2] == 0xff;
}

Image decode_jpeg(std::span<const std::uint8_t> bytes, const std::string& name, const ImageLimits& limits) {
  const auto refuse = [&name](const Decoder& decoder) -> InputError {
    return {name, "", std::string("damaged JPEG: ") + decoder.error.message};
  };
  Decoder decoder;
  if (!read_header(decoder, bytes)) throw refuse(decoder);
  decoder.info.client_data = limits.budget;
  check_image_size(decoder.info.image_width, decoder.info.image_height, name, limits_of(decoder, limits));
  Image image;
  image.name = name;
  image.width = static_cast<int>(decoder.info.image_width);
  image.height = static_cast<int>(decoder.info.image_height);
  image.rgba.resize(std::size_t{decoder.info.image_width} * decoder.info.image_height * 4);
  if (!read_rows(decoder, image.rgba.data())) throw refuse(decoder);
  if (decoder.info.out_color_space == JCS_CMYK) convert_cmyk(image.rgba, decoder.inverted_cmyk);
  return image;
}

}  // namespace barrido::scene
