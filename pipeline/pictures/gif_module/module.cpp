// giflib behind a C interface, as a module that is loaded when a GIF is written. Must not know: anything of
// Barrido but the interface.
#include "pipeline/pictures/gif_module/interface.h"

#include <gif_lib.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "pipeline/files/module_guard.h"

struct BarridoGifWriter {
  std::vector<uint8_t> bytes;
  GifFileType* file = nullptr;
  int width = 0, height = 0;
};

namespace {

using barrido::module::guarded;
using barrido::module::set_error;

int put_bytes(GifFileType* file, const GifByteType* bytes, int count) {
  auto* writer = static_cast<BarridoGifWriter*>(file->UserData);
  try {
    writer->bytes.insert(writer->bytes.end(), bytes, bytes + count);
  } catch (...) {
    return 0;  // giflib tells that too little was written
  }
  return count;
}

int fail(int code, BarridoModuleError* error) {
  const char* reason = GifErrorString(code);
  set_error(error, reason != nullptr ? reason : "unknown error");
  return GIF_ERROR;
}

/// "Repeat for ever", Netscape's extension: a block with the name, and one with 1 and the number of times.
int put_loop(GifFileType* file) {
  const unsigned char times[] = {1, 0, 0};
  if (EGifPutExtensionLeader(file, APPLICATION_EXT_FUNC_CODE) == GIF_ERROR) return GIF_ERROR;
  if (EGifPutExtensionBlock(file, 11, "NETSCAPE2.0") == GIF_ERROR) return GIF_ERROR;
  if (EGifPutExtensionBlock(file, sizeof(times), times) == GIF_ERROR) return GIF_ERROR;
  return EGifPutExtensionTrailer(file);
}

BarridoGifWriter* open_writer(int32_t width, int32_t height, BarridoModuleError* error) {
  auto writer = guarded(error, [] { return std::make_unique<BarridoGifWriter>(); });
  if (!writer) return nullptr;
  writer->width = width;
  writer->height = height;
  int code = 0;
  writer->file = EGifOpen(writer.get(), put_bytes, &code);
  if (writer->file == nullptr) {
    fail(code, error);
    return nullptr;
  }
  EGifSetGifVersion(writer->file, true);  // 89a
  if (EGifPutScreenDesc(writer->file, width, height, 8, 0, nullptr) == GIF_ERROR ||
      put_loop(writer->file) == GIF_ERROR) {
    fail(writer->file->Error, error);
    EGifCloseFile(writer->file, nullptr);
    return nullptr;
  }
  return writer.release();
}

int put_frame(BarridoGifWriter& writer, const BarridoGifFrame& frame) {
  constexpr int kColors = 256;
  GraphicsControlBlock control{};
  control.DisposalMode = frame.transparent < 0 ? DISPOSE_DO_NOT : DISPOSE_BACKGROUND;
  control.DelayTime = frame.delay_cs;
  control.TransparentColor = frame.transparent < 0 ? NO_TRANSPARENT_COLOR : frame.transparent;
  GifByteType extension[4];
  EGifGCBToExtension(&control, extension);
  if (EGifPutExtension(writer.file, GRAPHICS_EXT_FUNC_CODE, sizeof(extension), extension) == GIF_ERROR) {
    return GIF_ERROR;
  }
  GifColorType colors[kColors];
  for (int i = 0; i < kColors; ++i) {
    const uint8_t* color = frame.palette + static_cast<std::size_t>(3 * i);
    colors[i] = {color[0], color[1], color[2]};
  }
  const std::unique_ptr<ColorMapObject, void (*)(ColorMapObject*)> map(GifMakeMapObject(kColors, colors),
                                                                       GifFreeMapObject);
  if (!map ||
      EGifPutImageDesc(writer.file, 0, 0, writer.width, writer.height, false, map.get()) == GIF_ERROR) {
    return GIF_ERROR;
  }
  std::vector<GifByteType> row(static_cast<std::size_t>(writer.width));
  for (int y = 0; y < writer.height; ++y) {
    const uint8_t* from = frame.indices + static_cast<std::size_t>(y) * row.size();
    row.assign(from, from + writer.width);  // giflib may change what it is given
    if (EGifPutLine(writer.file, row.data(), writer.width) == GIF_ERROR) return GIF_ERROR;
  }
  return GIF_OK;
}

int add_frame(BarridoGifWriter* writer, const BarridoGifFrame* frame, BarridoModuleError* error) {
  return guarded(error, [&]() -> int {
    return put_frame(*writer, *frame) == GIF_OK ? 1 : fail(writer->file->Error, error);
  });
}

int finish(BarridoGifWriter* writer, const uint8_t** bytes, size_t* size, BarridoModuleError* error) {
  int code = 0;
  const int closed = EGifCloseFile(writer->file, &code);
  writer->file = nullptr;
  if (closed == GIF_ERROR) return fail(code, error);
  *bytes = writer->bytes.data();
  *size = writer->bytes.size();
  return 1;
}

void close_writer(BarridoGifWriter* writer) {
  if (writer->file != nullptr) EGifCloseFile(writer->file, nullptr);
  delete writer;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const BarridoGifFunctions* barrido_gif_functions(void) {
  static const BarridoGifFunctions functions{BARRIDO_GIF_INTERFACE_VERSION, open_writer, add_frame, finish,
                                             close_writer};
  return &functions;
}
