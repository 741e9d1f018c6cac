#include "raster/tiles/framebuffer.h"

#include <stdexcept>
#include <string>

#include "raster/fragments/primitive.h"

namespace barrido::raster {

Framebuffer::Framebuffer(const FramebufferOptions& options) : options_(options) {
  if (options.width < 1 || options.height < 1 || options.width > kMaxFrameSide ||
      options.height > kMaxFrameSide) {
    throw std::invalid_argument("frame of " + std::to_string(options.width) + " × " +
                                std::to_string(options.height) + " pixels: each side must be in 1.." +
                                std::to_string(kMaxFrameSide));
  }
  const std::size_t pixels =
      static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height);
  color8_.resize(pixels);
  if (options.format == ColorFormat::rgba32f && options.keep_float) color_float_.resize(pixels * 4);
  if (options.keep_depth) depth_.resize(pixels);
}

}  // namespace barrido::raster
