// Views and hashes of a drawn frame.
#pragma once

#include <string>

#include "pipeline/pictures/image_io.h"
#include "raster/tiles/framebuffer.h"

namespace barrido::cli {

/// The frame's colours as a picture to be written; the framebuffer must outlive it.
scene::ImageView view_of(const raster::Framebuffer& framebuffer);

/// SHA-256 of the 8-bit RGBA pixels, top row first, as 64 lower-case hexadecimal digits.
std::string pixel_hash(const raster::Framebuffer& framebuffer);

}  // namespace barrido::cli
