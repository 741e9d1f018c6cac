#include "viewer/barrido/frame_output.h"

#include "viewer/sheet/sha256.h"

namespace barrido::cli {
namespace {

/// The pixels as bytes; their order in memory is R, G, B, A on every machine.
std::span<const std::uint8_t> bytes_of_colors(const raster::Framebuffer& framebuffer) {
  const auto& colors = framebuffer.color8();
  return {reinterpret_cast<const std::uint8_t*>(colors.data()), colors.size() * 4};
}

}  // namespace

scene::ImageView view_of(const raster::Framebuffer& framebuffer) {
  return {framebuffer.width(), framebuffer.height(), bytes_of_colors(framebuffer), framebuffer.color_float()};
}

std::string pixel_hash(const raster::Framebuffer& framebuffer) {
  return sheet::sha256_hex(bytes_of_colors(framebuffer));
}

}  // namespace barrido::cli
